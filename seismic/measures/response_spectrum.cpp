#include "seismic/measures/response_spectrum.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "seismic/constants.h"

namespace dougong::seismic {
namespace {

constexpr double steps_per_period = 10.0;  // fewer, and the interpolant's error in PSa exceeds some 3 %

struct Peaks {
  double u = 0.0, v = 0.0, absolute = 0.0;
};

Peaks peak_response(std::span<const double> a, double interval, const Oscillator& oscillator,
                    int subdivisions) {
  const OscillatorStep c = oscillator_step(oscillator, interval / subdivisions);
  const double w = two_pi / oscillator.period, damping = 2.0 * oscillator.damping_ratio * w;
  Peaks peaks;
  double u = 0.0, v = 0.0;
  for (std::size_t k = 1; k < a.size(); ++k) {
    const double rise = (a[k] - a[k - 1]) / subdivisions;
    for (int i = 0; i < subdivisions; ++i) {
      const double a0 = a[k - 1] + i * rise, a1 = i + 1 == subdivisions ? a[k] : a0 + rise;
      const double next = c.uu * u + c.uv * v + c.ua * a0 + c.ub * a1;
      v = c.vu * u + c.vv * v + c.va * a0 + c.vb * a1;
      u = next;
      peaks.u = std::max(peaks.u, std::abs(u));
      peaks.v = std::max(peaks.v, std::abs(v));
      peaks.absolute = std::max(peaks.absolute, std::abs(damping * v + w * w * u));
    }
  }
  return peaks;
}

}  // namespace

SpectralPoint spectral_point(std::span<const double> acceleration, double interval, double period,
                             const SpectrumOptions& options) {
  const Peaks peaks = peak_response(acceleration, interval, {period, options.damping_ratio},
                                    std::max(1, options.subdivisions));
  const double w = two_pi / period;
  return {period, peaks.u, peaks.v, peaks.absolute, w * peaks.u, w * w * peaks.u};
}

std::vector<SpectralPoint> response_spectrum(std::span<const double> acceleration, double interval,
                                             std::span<const double> periods,
                                             const SpectrumOptions& options) {
  std::vector<SpectralPoint> spectrum;
  spectrum.reserve(periods.size());
  for (const double period : periods) {
    spectrum.push_back(spectral_point(acceleration, interval, period, options));
  }
  return spectrum;
}

std::vector<double> log_spaced_periods(double from, double to, std::size_t count) {
  std::vector<double> periods(count);
  const double ratio = std::log(to / from);
  for (std::size_t i = 0; i < count; ++i) {
    periods[i] = from * std::exp(ratio * static_cast<double>(i) / static_cast<double>(count - 1));
  }
  if (count > 1) periods.back() = to;
  return periods;
}

std::vector<std::string> spectrum_warnings(std::span<const double> periods, double interval) {
  std::vector<std::string> warnings;
  if (periods.empty()) return warnings;
  const double reliable = steps_per_period * interval;
  const auto [shortest, longest] = std::minmax_element(periods.begin(), periods.end());
  // The comparison forgives rounding: T = 0.1 s is exactly ten steps of 0.01 s.
  if (*shortest < reliable * (1.0 - 1e-9)) {
    warnings.push_back(
        fmt::format("spectrum: periods below {:.4g} s have fewer than {:g} samples of this record "
                    "(step {:.4g} s) and are not reliable",
                    reliable, steps_per_period, interval));
  }
  if (*longest < reliable * (1.0 - 1e-9)) {
    warnings.push_back(
        fmt::format("spectrum: the record's step of {:.4g} s is coarser than needed for any of the "
                    "periods asked for (at most {:.4g} s)",
                    interval, *longest / steps_per_period));
  }
  return warnings;
}

double housner_intensity(std::span<const double> acceleration, double interval, double damping_ratio,
                         double step) {
  constexpr double from = 0.1, to = 2.5;  // s, by definition
  const int intervals = std::max(1, static_cast<int>(std::lround((to - from) / step)));
  double sum = 0.0;
  for (int i = 0; i <= intervals; ++i) {
    const double period = from + (to - from) * i / intervals;
    const double weight = i == 0 || i == intervals ? 0.5 : 1.0;
    sum += weight * spectral_point(acceleration, interval, period, {damping_ratio, 1}).pseudo_velocity;
  }
  return sum * (to - from) / intervals;
}

}  // namespace dougong::seismic
