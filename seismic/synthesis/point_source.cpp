#include "seismic/synthesis/point_source.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "seismic/constants.h"
#include "seismic/numerics/fourier.h"
#include "seismic/synthesis/random.h"

namespace dougong::seismic {
namespace {

using std::numbers::pi;

// Linear between the nodes, flat outside.
template <std::size_t N>
double interpolated(const std::array<std::pair<double, double>, N>& table, double x) {
  if (x <= table.front().first) return table.front().second;
  for (std::size_t i = 1; i < N; ++i) {
    if (x > table[i].first) continue;
    const auto [x0, y0] = table[i - 1];
    const auto [x1, y1] = table[i];
    return y0 + (y1 - y0) * (x - x0) / (x1 - x0);
  }
  return table.back().second;
}

// Boore 2016, generic rock of Vs30 760 m/s: amplitude against frequency (Hz), linear in log f.
double site_amplification(double frequency) {
  static const auto table = [] {
    constexpr std::array<double, 25> f = {.01,   .015,   .021,   .031,   .045,   .065,   .095,  .138, .2,
                                          .291,  .423,   .615,   .894,   1.301,  1.892,  2.751, 4.0,  5.817,
                                          8.459, 12.301, 17.889, 26.014, 37.830, 55.012, 80.0};
    constexpr std::array<double, 25> a = {1.00, 1.01, 1.02, 1.02, 1.04, 1.06, 1.09, 1.13, 1.18,
                                          1.25, 1.32, 1.41, 1.51, 1.64, 1.80, 1.99, 2.18, 2.38,
                                          2.56, 2.75, 2.95, 3.17, 3.42, 3.68, 3.96};
    std::array<std::pair<double, double>, 25> out{};
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = {std::log(f[i]), a[i]};
    return out;
  }();
  return interpolated(table, std::log(frequency));
}

// The one place of cgs, bars and kilometres.
struct Cgs {
  double moment;          // dyne cm
  double stress_drop;     // bar
  double shear_velocity;  // km/s
  double density;         // g/cm3
  double distance;        // km
};

Cgs to_cgs(const PointSource& source, const Region& region) {
  return {std::pow(10.0, 1.5 * source.magnitude + 16.05), source.stress_drop * 1e-5,
          region.shear_velocity * 1e-3, region.density * 1e-3, source.distance * 1e-3};
}

double spreading(const Region& region, double distance) {
  double product = 1.0;
  for (std::size_t i = 0; i < region.spreading.size(); ++i) {
    const auto [from, exponent] = region.spreading[i];
    const bool last = i + 1 == region.spreading.size();
    const double to = last ? distance : std::min(distance, region.spreading[i + 1].first);
    if (to > from) product *= std::pow(to / from, exponent);
  }
  return product;
}

// Boore & Thompson, active crust: effective distance (km), seconds; 0.156 s/km beyond.
double path_duration(double distance) {
  constexpr std::array<std::pair<double, double>, 6> table = {
      {{0.0, 0.0}, {7.0, 2.4}, {45.0, 8.4}, {125.0, 10.9}, {175.0, 17.4}, {270.0, 34.2}}};
  return interpolated(table, distance) + 0.156 * std::max(0.0, distance - 270.0);
}

// The share of noise that lies in the spectrum's shape: window, transform, mean square 1.
std::vector<std::complex<double>> unit_noise(std::size_t samples, std::size_t size, double interval,
                                             double end, std::uint64_t seed, std::uint64_t stream) {
  const std::vector<double> noise = gaussian_noise(seed, stream, samples);
  std::vector<std::complex<double>> x(size);
  for (std::size_t k = 0; k < samples; ++k)
    x[k] = noise[k] * envelope(static_cast<double>(k) * interval, end);
  fourier_transform(x);
  double square = 0.0;
  for (std::size_t m = 1; m <= size / 2; ++m) square += std::norm(x[m]);
  const double rms = std::sqrt(square / static_cast<double>(size / 2));
  for (auto& value : x) value /= rms;
  return x;
}

}  // namespace

double corner_frequency(const PointSource& source, const Region& region) {
  const Cgs c = to_cgs(source, region);
  return 4.9e6 * c.shear_velocity * std::cbrt(c.stress_drop / c.moment);
}

double fourier_amplitude(const PointSource& source, const Region& region, double f) {
  const Cgs c = to_cgs(source, region);
  const double constant = 0.55 * 0.707 * 2.0 * 1e-20 / (4.0 * pi * c.density * std::pow(c.shear_velocity, 3));
  const double ratio = f / corner_frequency(source, region), w = two_pi * f;
  const double q = region.q0 * std::pow(std::max(f, 0.1), region.q_exponent);
  const double path = spreading(region, c.distance) * std::exp(-pi * f * c.distance / (q * c.shear_velocity));
  const double site = region.site_factor * site_amplification(f) * std::exp(-pi * region.kappa * f);
  const double low = std::pow(region.low_cut / f, 4);
  const double cgs =
      constant * c.moment * w * w / (1.0 + ratio * ratio) * path * site / std::sqrt(1.0 + low * low);
  return cgs * 0.01;  // cm/s -> m/s
}

double motion_duration(const PointSource& source, const Region& region) {
  return 1.0 / corner_frequency(source, region) + path_duration(source.distance * 1e-3);
}

double envelope(double time, double end) {
  constexpr double peak_at = 0.2, left = 0.05;
  const double b = -peak_at * std::log(left) / (1.0 + peak_at * (std::log(peak_at) - 1.0));
  const double x = time / (peak_at * end);
  return time <= 0.0 ? 0.0 : std::pow(x * std::exp(1.0 - x), b);
}

std::vector<double> simulate(const PointSource& source, const Region& region, double interval,
                             std::size_t count, std::uint64_t seed, std::uint64_t stream) {
  const double end = 2.0 * motion_duration(source, region);
  const auto window = static_cast<std::size_t>(std::ceil(1.5 * end / interval));  // until it is all but over
  const std::size_t size = next_power_of_two(2 * window);
  auto x = unit_noise(window, size, interval, end, seed, stream);
  const double df = 1.0 / (static_cast<double>(size) * interval);
  x[0] = 0.0;
  for (std::size_t m = 1; m <= size / 2; ++m) {
    x[m] *= fourier_amplitude(source, region, static_cast<double>(m) * df) / interval;
    if (m < size / 2) x[size - m] = std::conj(x[m]);
  }
  x[size / 2] = x[size / 2].real();
  inverse_fourier_transform(x);
  std::vector<double> motion(count, 0.0);
  const auto first = static_cast<std::size_t>(std::llround(source.onset / interval));
  for (std::size_t k = 0; k < size - window / 2 && first + k < count; ++k) motion[first + k] = x[k].real();
  return motion;
}

}  // namespace dougong::seismic
