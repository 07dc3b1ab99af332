#include "seismic/measures/rotated.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "seismic/constants.h"
#include "seismic/measures/oscillator.h"

namespace dougong::seismic {
namespace {

constexpr std::size_t angles = 180;  // whole degrees; the other half turn repeats them with the other sign
constexpr std::size_t look_again = 256;

struct Directions {
  std::array<double, angles> cosine, sine;
};

const Directions& directions() {
  static const Directions table = [] {
    Directions d{};
    for (std::size_t i = 0; i < angles; ++i) {
      const double angle = std::numbers::pi * static_cast<double>(i) / 180.0;
      d.cosine[i] = i == 90 ? 0.0 : std::cos(angle);
      d.sine[i] = std::sin(angle);
    }
    return d;
  }();
  return table;
}

// The greatest |x| in every direction. A point nearer to the origin than the least of them adds to none.
std::array<double, angles> peaks_by_angle(std::span<const double> first, std::span<const double> second) {
  const Directions& d = directions();
  std::array<double, angles> peaks{};
  double least = 0.0;
  const std::size_t samples = std::min(first.size(), second.size());
  for (std::size_t k = 0, added = 0; k < samples; ++k) {
    const double x = first[k], y = second[k];
    if (x * x + y * y <= least * least) continue;
    for (std::size_t i = 0; i < angles; ++i) {
      const double size = std::abs(x * d.cosine[i] + y * d.sine[i]);
      peaks[i] = peaks[i] < size ? size : peaks[i];
    }
    if (++added % look_again == 0) least = *std::min_element(peaks.begin(), peaks.end());
  }
  return peaks;
}

RotatedPeaks scaled(RotatedPeaks p, double factor) {
  for (double* value : {&p.rotd00, &p.rotd50, &p.rotd100, &p.first, &p.second, &p.geometric_mean})
    *value *= factor;
  return p;
}

}  // namespace

RotatedPeaks rotated_peaks(std::span<const double> first, std::span<const double> second) {
  std::array<double, angles> peaks = peaks_by_angle(first, second);
  RotatedPeaks out;
  out.first = peaks[0], out.second = peaks[angles / 2];
  out.geometric_mean = std::sqrt(out.first * out.second);
  out.angle100 = static_cast<double>(std::max_element(peaks.begin(), peaks.end()) - peaks.begin());
  std::sort(peaks.begin(), peaks.end());
  out.rotd00 = peaks.front(), out.rotd100 = peaks.back();
  out.rotd50 = 0.5 * (peaks[angles / 2 - 1] + peaks[angles / 2]);
  return out;
}

std::vector<RotatedPeaks> rotated_spectrum(std::span<const double> first, std::span<const double> second,
                                           double interval, std::span<const double> periods,
                                           double damping_ratio) {
  std::vector<RotatedPeaks> spectrum;
  for (const double period : periods) {
    const Oscillator oscillator{period, damping_ratio};
    const auto u = oscillator_response(first, interval, oscillator).displacement;
    const auto v = oscillator_response(second, interval, oscillator).displacement;
    const double w = two_pi / period;
    spectrum.push_back(scaled(rotated_peaks(u, v), w * w));
  }
  return spectrum;
}

std::vector<double> rotated(std::span<const double> first, std::span<const double> second, double angle) {
  const double turn = std::numbers::pi * angle / 180.0, c = std::cos(turn), s = std::sin(turn);
  std::vector<double> out(std::min(first.size(), second.size()));
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = first[k] * c + second[k] * s;
  return out;
}

}  // namespace dougong::seismic
