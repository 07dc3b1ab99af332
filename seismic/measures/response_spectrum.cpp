#include "seismic/measures/response_spectrum.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "seismic/constants.h"
#include "seismic/measures/continuous_peaks.h"
#include "seismic/measures/peak_kernels.h"

namespace dougong::seismic {
namespace {

constexpr double steps_per_period = 10.0;  // fewer, and the interpolant's error in PSa exceeds some 3 %

std::vector<PeakOscillator> oscillators_of(std::span<const double> periods, double damping_ratio,
                                           double interval) {
  std::vector<PeakOscillator> out;
  out.reserve(periods.size());
  for (const double period : periods)
    out.push_back({scaled_oscillator_step({period, damping_ratio}, interval), 2.0 * damping_ratio});
  return out;
}

// The linear interpolant at `parts` points of every step.
std::vector<double> subdivided(std::span<const double> a, int parts) {
  std::vector<double> out;
  if (a.empty()) return out;
  out.reserve((a.size() - 1) * static_cast<std::size_t>(parts) + 1);
  out.push_back(a[0]);
  for (std::size_t k = 1; k < a.size(); ++k) {
    const double rise = (a[k] - a[k - 1]) / parts;
    for (int i = 1; i < parts; ++i) out.push_back(a[k - 1] + i * rise);
    out.push_back(a[k]);
  }
  return out;
}

std::vector<OscillatorPeaks> peaks_at_samples(std::span<const double> a, double interval,
                                              std::span<const double> periods, double damping_ratio,
                                              void (*find)(const PeakCall&)) {
  const auto oscillators = oscillators_of(periods, damping_ratio, interval);
  std::vector<OscillatorPeaks> peaks(periods.size());
  find({a.data(), a.size(), oscillators.data(), oscillators.size(), peaks.data()});
  return peaks;
}

std::vector<OscillatorPeaks> peaks_of(std::span<const double> a, double interval,
                                      std::span<const double> periods, const SpectrumOptions& options) {
  if (options.within_steps) {
    std::vector<OscillatorPeaks> peaks;
    for (const double period : periods)
      peaks.push_back(continuous_peaks(a, interval, {period, options.damping_ratio}));
    return peaks;
  }
  const auto find = best_peak_kernel().all;
  if (options.subdivisions <= 1) return peaks_at_samples(a, interval, periods, options.damping_ratio, find);
  return peaks_at_samples(subdivided(a, options.subdivisions), interval / options.subdivisions, periods,
                          options.damping_ratio, find);
}

}  // namespace

std::vector<SpectralPoint> response_spectrum(std::span<const double> acceleration, double interval,
                                             std::span<const double> periods,
                                             const SpectrumOptions& options) {
  const auto peaks = peaks_of(acceleration, interval, periods, options);
  std::vector<SpectralPoint> spectrum;
  spectrum.reserve(periods.size());
  for (std::size_t i = 0; i < periods.size(); ++i) {
    const double w = two_pi / periods[i];
    const OscillatorPeaks& p = peaks[i];
    spectrum.push_back({periods[i], p.displacement / (w * w), p.velocity / w, p.acceleration,
                        p.displacement / w, p.displacement});
  }
  return spectrum;
}

SpectralPoint spectral_point(std::span<const double> acceleration, double interval, double period,
                             const SpectrumOptions& options) {
  return response_spectrum(acceleration, interval, std::span(&period, 1), options).front();
}

std::vector<double> pseudo_accelerations(std::span<const double> acceleration, double interval,
                                         std::span<const double> periods, double damping_ratio) {
  std::vector<double> psa;
  psa.reserve(periods.size());
  for (const OscillatorPeaks& peaks :
       peaks_at_samples(acceleration, interval, periods, damping_ratio, best_peak_kernel().displacement))
    psa.push_back(peaks.displacement);
  return psa;
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

}  // namespace dougong::seismic
