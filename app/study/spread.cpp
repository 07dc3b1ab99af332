#include "app/study/spread.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace dougong::app {

double mean_of(const std::vector<double>& values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double quantile(const std::vector<double>& sorted, double part) {
  if (sorted.empty()) return std::numeric_limits<double>::quiet_NaN();
  const double place = part * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

Spread spread_of(std::vector<double> values) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  std::sort(values.begin(), values.end());
  return {values.size(),         quantile(values, 0.0),  quantile(values, 0.16),
          quantile(values, 0.5), quantile(values, 0.84), quantile(values, 1.0)};
}

Share share_of(std::size_t events, std::size_t trials) {
  Share share{events, trials};
  if (trials == 0) return share;
  constexpr double z = 1.959963984540054;  // 97.5 % of the normal distribution
  const double n = static_cast<double>(trials), p = share.value(), z2 = z * z;
  const double middle = (p + z2 / (2.0 * n)) / (1.0 + z2 / n);
  const double half = z / (1.0 + z2 / n) * std::sqrt(p * (1.0 - p) / n + z2 / (4.0 * n * n));
  share.low = std::max(0.0, middle - half), share.high = std::min(1.0, middle + half);
  return share;
}

}  // namespace dougong::app
