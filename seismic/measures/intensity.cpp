#include "seismic/measures/intensity.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace dougong::seismic {
namespace {

double square_integral(double a0, double a1, double h, SquareIntegral rule) {
  if (rule == SquareIntegral::trapezoid) return 0.5 * h * (a0 * a0 + a1 * a1);
  return h * (a0 * a0 + a0 * a1 + a1 * a1) / 3.0;
}

std::vector<double> husid_curve(std::span<const double> a, double h) {
  std::vector<double> sum(a.size(), 0.0);
  for (std::size_t k = 1; k < a.size(); ++k) {
    sum[k] = sum[k - 1] + square_integral(a[k - 1], a[k], h, SquareIntegral::trapezoid);
  }
  return sum;
}

double time_of_share(const std::vector<double>& husid, double h, double share) {
  const double target = share * husid.back();
  std::size_t k = 1;
  while (k + 1 < husid.size() && husid[k] < target) ++k;
  const double rise = husid[k] - husid[k - 1];
  const double part = rise > 0.0 ? (target - husid[k - 1]) / rise : 0.0;
  return h * (static_cast<double>(k - 1) + part);
}

}  // namespace

double arias_intensity(std::span<const double> a, double interval, double gravity, SquareIntegral rule) {
  double sum = 0.0;
  for (std::size_t k = 1; k < a.size(); ++k) sum += square_integral(a[k - 1], a[k], interval, rule);
  return std::numbers::pi / (2.0 * gravity) * sum;
}

double cumulative_absolute_velocity(std::span<const double> a, double interval) {
  double sum = 0.0;
  for (std::size_t k = 1; k < a.size(); ++k) sum += 0.5 * interval * (std::abs(a[k - 1]) + std::abs(a[k]));
  return sum;
}

double standardised_cav(std::span<const double> a, double interval, double threshold, double window) {
  double total = 0.0, sum = 0.0, most = 0.0, current = 0.0;
  for (std::size_t k = 1; k < a.size(); ++k) {
    const double number = std::floor((static_cast<double>(k) - 0.5) * interval / window);
    if (number != current) {
      total += most >= threshold ? sum : 0.0;
      sum = most = 0.0;
      current = number;
    }
    sum += 0.5 * interval * (std::abs(a[k - 1]) + std::abs(a[k]));
    most = std::max({most, std::abs(a[k - 1]), std::abs(a[k])});
  }
  return total + (most >= threshold ? sum : 0.0);
}

double rms_acceleration(std::span<const double> a, double interval) {
  if (a.size() < 2) return 0.0;
  double sum = 0.0;
  for (std::size_t k = 1; k < a.size(); ++k) {
    sum += square_integral(a[k - 1], a[k], interval, SquareIntegral::trapezoid);
  }
  return std::sqrt(sum / (interval * static_cast<double>(a.size() - 1)));
}

SignificantDuration significant_duration(std::span<const double> a, double interval, double from, double to) {
  const std::vector<double> husid = husid_curve(a, interval);
  if (husid.size() < 2 || husid.back() == 0.0) return {};
  return {time_of_share(husid, interval, from), time_of_share(husid, interval, to)};
}

std::vector<double> husid(std::span<const double> a, double interval) {
  std::vector<double> curve = husid_curve(a, interval);
  const double whole = curve.empty() ? 0.0 : curve.back();
  for (double& value : curve) value = whole > 0.0 ? value / whole : 0.0;
  return curve;
}

double uniform_duration(std::span<const double> a, double interval, double threshold) {
  const auto reached = std::count_if(a.begin(), a.end(), [&](double x) { return std::abs(x) >= threshold; });
  return interval * static_cast<double>(reached);
}

double bracketed_duration(std::span<const double> a, double interval, double threshold) {
  std::size_t first = a.size(), last = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (std::abs(a[k]) < threshold) continue;
    first = std::min(first, k);
    last = k;
  }
  return first < a.size() ? interval * static_cast<double>(last - first) : 0.0;
}

}  // namespace dougong::seismic
