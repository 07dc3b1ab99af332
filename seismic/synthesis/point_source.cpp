#include "seismic/synthesis/point_source.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "seismic/constants.h"
#include "seismic/numerics/fourier.h"
#include "seismic/synthesis/random.h"

namespace dougong::seismic {
namespace {

using std::numbers::pi;

using Nodes = std::vector<std::pair<double, double>>;

// Linear between the nodes, flat outside.
double interpolated(const Nodes& table, double x) {
  if (x <= table.front().first) return table.front().second;
  for (std::size_t i = 1; i < table.size(); ++i) {
    if (x > table[i].first) continue;
    const auto [x0, y0] = table[i - 1];
    const auto [x1, y1] = table[i];
    return y0 + (y1 - y0) * (x - x0) / (x1 - x0);
  }
  return table.back().second;
}

Nodes over_log(Nodes table) {
  for (auto& [frequency, amplification] : table) frequency = std::log(frequency);
  return table;
}

// Frequency (Hz), amplification.
double site_amplification(SiteTable site, double frequency) {
  static const Nodes rock =
      over_log({{.01, 1.00},    {.015, 1.01},   {.021, 1.02},  {.031, 1.02},   {.045, 1.04},
                {.065, 1.06},   {.095, 1.09},   {.138, 1.13},  {.2, 1.18},     {.291, 1.25},
                {.423, 1.32},   {.615, 1.41},   {.894, 1.51},  {1.301, 1.64},  {1.892, 1.80},
                {2.751, 1.99},  {4.0, 2.18},    {5.817, 2.38}, {8.459, 2.56},  {12.301, 2.75},
                {17.889, 2.95}, {26.014, 3.17}, {37.83, 3.42}, {55.012, 3.68}, {80.0, 3.96}});
  static const Nodes japan = over_log({{.11, 1.39},
                                       {.22, 1.62},
                                       {.41, 1.84},
                                       {.64, 1.92},
                                       {.80, 1.97},
                                       {.99, 2.05},
                                       {1.23, 2.13},
                                       {1.53, 2.28},
                                       {1.90, 2.44},
                                       {2.37, 2.60},
                                       {2.94, 2.78},
                                       {3.66, 3.10},
                                       {4.55, 3.23},
                                       {5.66, 3.43},
                                       {7.04, 3.66},
                                       {8.75, 3.71},
                                       {10.9, 3.55},
                                       {13.5, 3.03}});
  static const Nodes california = over_log({{.10, 1.45},
                                            {.24, 1.87},
                                            {.45, 2.17},
                                            {.79, 2.48},
                                            {1.38, 2.91},
                                            {1.93, 3.20},
                                            {2.85, 3.36},
                                            {4.03, 3.35},
                                            {6.34, 3.13},
                                            {12.54, 2.95},
                                            {21.23, 2.99},
                                            {33.39, 3.11},
                                            {82.0, 3.23}});
  const Nodes& table = site == SiteTable::japan_500        ? japan
                       : site == SiteTable::california_500 ? california
                                                           : rock;
  return interpolated(table, std::log(frequency));
}

// The formulas are in cgs, bars and kilometres.
constexpr double dyne_cm = 1e-7;  // N m
constexpr double bar = 1e-5;      // bar in a Pa

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

double seismic_moment(double magnitude) {
  return std::pow(10.0, 1.5 * magnitude + 16.05) * dyne_cm;
}

double moment_magnitude(double moment) {
  return (std::log10(moment / dyne_cm) - 16.05) / 1.5;
}

// Boore & Thompson, active crust: effective distance (km), seconds; 0.156 s/km beyond.
double path_duration(double distance) {
  static const Nodes table = {{0.0, 0.0},    {7.0, 2.4},    {45.0, 8.4},
                              {125.0, 10.9}, {175.0, 17.4}, {270.0, 34.2}};
  const double km = distance * 1e-3;
  return interpolated(table, km) + 0.156 * std::max(0.0, km - 270.0);
}

double corner_frequency(const Region& region, double moment, double stress_drop) {
  return 4.9e6 * region.shear_velocity * 1e-3 * std::cbrt(stress_drop * bar / (moment / dyne_cm));
}

double corner_frequency(const PointSource& source, const Region& region) {
  return corner_frequency(region, seismic_moment(source.magnitude), source.stress_drop);
}

double source_amplitude(const Region& region, double moment, double f) {
  const double density = region.density * 1e-3, velocity = region.shear_velocity * 1e-3;
  const double constant = 0.55 * 0.707 * 2.0 * 1e-20 / (4.0 * pi * density * std::pow(velocity, 3));
  const double w = two_pi * f;
  return constant * (moment / dyne_cm) * w * w * 0.01;  // cm/s -> m/s
}

double at_the_site(double source, const Region& region, double distance, double f) {
  const double km = distance * 1e-3;
  const double q = region.q0 * std::pow(std::max(f, 0.1), region.q_exponent);
  const double path = spreading(region, km) * std::exp(-pi * f * km / (q * region.shear_velocity * 1e-3));
  const double site =
      region.site_factor * site_amplification(region.site, f) * std::exp(-pi * region.kappa * f);
  const double low = std::pow(region.low_cut / f, 4);
  return source * path * site / std::sqrt(1.0 + low * low);
}

double fourier_amplitude(const PointSource& source, const Region& region, double f) {
  const double ratio = f / corner_frequency(source, region);
  const double shaped = source_amplitude(region, seismic_moment(source.magnitude), f) / (1.0 + ratio * ratio);
  return at_the_site(shaped, region, source.distance, f);
}

double motion_duration(const PointSource& source, const Region& region) {
  return 1.0 / corner_frequency(source, region) + path_duration(source.distance);
}

double envelope(double time, double end) {
  constexpr double peak_at = 0.2, left = 0.05;
  const double b = -peak_at * std::log(left) / (1.0 + peak_at * (std::log(peak_at) - 1.0));
  const double x = time / (peak_at * end);
  return time <= 0.0 ? 0.0 : std::pow(x * std::exp(1.0 - x), b);
}

void add_shaped_noise(std::vector<double>& motion, const std::function<double(double)>& amplitude,
                      double duration, double onset, double interval, std::uint64_t seed,
                      std::uint64_t stream) {
  const double end = 2.0 * duration;
  const auto window = static_cast<std::size_t>(std::ceil(1.5 * end / interval));  // until it is all but over
  const std::size_t size = next_power_of_two(2 * window);
  auto x = unit_noise(window, size, interval, end, seed, stream);
  const double df = 1.0 / (static_cast<double>(size) * interval);
  x[0] = 0.0;
  for (std::size_t m = 1; m <= size / 2; ++m) {
    x[m] *= amplitude(static_cast<double>(m) * df) / interval;
    if (m < size / 2) x[size - m] = std::conj(x[m]);
  }
  x[size / 2] = x[size / 2].real();
  inverse_fourier_transform(x);
  const auto first = static_cast<std::size_t>(std::llround(onset / interval));
  for (std::size_t k = 0; k < size - window / 2 && first + k < motion.size(); ++k)
    motion[first + k] += x[k].real();
}

std::vector<double> simulate(const PointSource& source, const Region& region, double interval,
                             std::size_t count, std::uint64_t seed, std::uint64_t stream) {
  std::vector<double> motion(count, 0.0);
  add_shaped_noise(
      motion, [&](double f) { return fourier_amplitude(source, region, f); }, motion_duration(source, region),
      source.onset, interval, seed, stream);
  return motion;
}

}  // namespace dougong::seismic
