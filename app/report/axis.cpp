#include "app/report/axis.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dougong::app {

double round_below(double value) {
  if (!(value > 0.0) || !std::isfinite(value)) return 1.0;
  const double decade = std::pow(10.0, std::floor(std::log10(value) + 1e-9));
  for (const double factor : {5.0, 2.0}) {
    if (factor * decade <= value * (1.0 + 1e-9)) return factor * decade;
  }
  return decade;
}

double round_step(double span, int count) {
  const double raw = span / count;
  const double below = round_below(raw);
  for (const double step : {below, 2.0 * below, 2.5 * below}) {
    if (round_below(step) >= step * (1 - 1e-9) && span / step <= count) return step;
  }
  return 2.0 * below;
}

Range range_of(const std::vector<double>& values) {
  Range r{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const double v : values) {
    if (std::isfinite(v)) r = {std::min(r.low, v), std::max(r.high, v)};
  }
  return r.low <= r.high ? r : Range{};
}

Range joined(Range a, Range b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

Range padded(Range range, double share, double flat) {
  if (range.span() <= 1e-12 * std::max(std::abs(range.low), std::abs(range.high)) || range.span() == 0.0) {
    return {range.low - flat, range.high + flat};
  }
  return {range.low - share * range.span(), range.high + share * range.span()};
}

double round_up(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : {1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0}) {
    if (factor * decade >= value * (1 - 1e-9)) return factor * decade;
  }
  return 10.0 * decade;
}

}  // namespace dougong::app
