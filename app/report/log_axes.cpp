#include "app/report/log_axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dougong::app {
namespace {

constexpr double every_decade = 4.2;  // decades beyond which 2 and 5 would crowd the axis

double decade_below(double v) {
  return std::pow(10.0, std::floor(std::log10(v) + 1e-9));
}

/// The next 1, 2 or 5 of a decade with some room.
double round_above(double v) {
  const double below = round_below(v);
  for (const double factor : {1.0, 2.0, 2.5, 5.0}) {
    const double candidate = factor * below;
    if (candidate >= 1.15 * v && std::abs(round_below(candidate) - candidate) < 1e-9 * candidate)
      return candidate;
  }
  return 10.0 * below;
}

}  // namespace

Range log_range(const std::vector<double>& values, double decades) {
  Range r{INFINITY, 0.0};
  for (const double v : values) {
    if (v > 0) r = {std::min(r.low, v), std::max(r.high, v)};
  }
  if (!(r.low <= r.high)) return {0.01, 1.0};
  const double high = round_above(r.high);
  const double low = std::max(r.low, high * std::pow(10.0, -decades));
  return {std::min(round_below(low), 0.1 * high), high};
}

std::string log_tics(const char* axis, Range range) {
  const bool crowded = std::log10(range.high / range.low) > every_decade;
  std::string out;
  for (double decade = decade_below(range.low); decade <= range.high; decade *= 10.0) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double v = factor * decade;
      if (v < range.low * 0.999 || v > range.high * 1.001 || (crowded && factor > 1.0)) continue;
      out += fmt::format("{}'{:g}' {:g}", out.empty() ? "" : ", ", v, v);
    }
  }
  return fmt::format("set {}tics ({})\n", axis, out);
}

}  // namespace dougong::app
