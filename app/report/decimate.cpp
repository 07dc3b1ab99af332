#include "app/report/decimate.h"

#include <algorithm>

namespace dougong::app {
namespace {

void keep(Points& out, const std::vector<double>& x, const std::vector<double>& y, std::size_t i) {
  if (!out.x.empty() && out.x.back() == x[i] && out.y.back() == y[i]) return;
  out.x.push_back(x[i]);
  out.y.push_back(y[i]);
}

}  // namespace

Points decimated(const std::vector<double>& x, const std::vector<double>& y, std::size_t bins) {
  const std::size_t n = std::min(x.size(), y.size());
  const auto head = [n](const std::vector<double>& v) {
    return std::vector<double>(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(n));
  };
  if (n <= 2 * bins + 2) return {head(x), head(y)};
  Points out;
  keep(out, x, y, 0);
  for (std::size_t bin = 0; bin < bins; ++bin) {
    const auto first = y.begin() + static_cast<std::ptrdiff_t>(bin * n / bins);
    const auto last = y.begin() + static_cast<std::ptrdiff_t>((bin + 1) * n / bins);
    const auto [low, high] = std::minmax_element(first, last);
    keep(out, x, y, static_cast<std::size_t>(std::min(low, high) - y.begin()));
    keep(out, x, y, static_cast<std::size_t>(std::max(low, high) - y.begin()));
  }
  keep(out, x, y, n - 1);
  return out;
}

}  // namespace dougong::app
