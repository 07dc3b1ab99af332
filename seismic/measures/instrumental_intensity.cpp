#include "seismic/measures/instrumental_intensity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>

#include "seismic/conditioning/butterworth.h"
#include "seismic/conditioning/taper.h"
#include "seismic/measures/integrate.h"
#include "seismic/measures/peaks.h"
#include "seismic/numerics/fourier.h"

namespace dougong::seismic {
namespace {

constexpr double gal = 0.01;      // m/s2
constexpr double jma_hold = 0.3;  // s in all
constexpr double minus_infinity = -std::numeric_limits<double>::infinity();

std::vector<double> without_mean(std::vector<double> a) {
  const double offset = mean(a);
  for (double& value : a) value -= offset;
  return a;
}

std::vector<double> jma_filtered(const std::vector<double>& a, double interval) {
  const std::vector<double> centred = without_mean(a);
  std::vector<std::complex<double>> x(centred.begin(), centred.end());
  const std::size_t size = next_power_of_two(std::max<std::size_t>(2, x.size()));
  x.resize(size);
  fourier_transform(x);
  for (std::size_t m = 0; m <= size / 2; ++m) {
    const double gain = jma_filter_gain(static_cast<double>(m) / (static_cast<double>(size) * interval));
    x[m] *= gain;
    if (m > 0 && m < size / 2) x[size - m] *= gain;
  }
  inverse_fourier_transform(x);
  std::vector<double> out(a.size());
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = x[k].real();
  return out;
}

std::vector<double> vector_sum(const Components& components) {
  std::size_t samples = 0;
  for (const auto& component : components) samples = std::max(samples, component.size());
  std::vector<double> out(samples, 0.0);
  for (const auto& component : components)
    for (std::size_t k = 0; k < component.size(); ++k) out[k] = std::hypot(out[k], component[k]);
  return out;
}

// The level that is reached for `time` in all.
double level_held(std::vector<double> values, double interval, double time) {
  const auto count = static_cast<std::size_t>(std::max(1LL, std::llround(time / interval)));
  if (values.size() < count) return 0.0;
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(count) - 1;
  std::nth_element(values.begin(), nth, values.end(), std::greater<>());
  return *nth;
}

std::vector<double> band_passed(const std::vector<double>& a, double interval) {
  constexpr double low = 0.1, high = 10.0;  // Hz
  constexpr double pad_time = 30.0;         // s, 1.5 order/(2 low)
  Band band{low, {}, 4};
  if (high < 0.9 * 0.5 / interval) band.low_pass = high;
  const auto pad = static_cast<std::size_t>(std::ceil(pad_time / interval));
  std::vector<double> x = padded(without_mean(a), pad, pad);
  filter_both_ways(butterworth(band, interval), x);
  return x;
}

}  // namespace

double jma_filter_gain(double f) {
  if (f <= 0.0) return 0.0;
  const double y = f * f / 100.0;
  const double high =
      1.0 + y * (.694 + y * (.241 + y * (.0557 + y * (.009664 + y * (.00134 + y * .000155)))));
  return std::sqrt((1.0 - std::exp(-std::pow(f / 0.5, 3))) / (f * high));
}

std::string jma_class(double intensity) {
  struct Class {
    double below;
    const char* name;
  };
  constexpr std::array<Class, 9> classes = {{{0.5, "0"},
                                             {1.5, "1"},
                                             {2.5, "2"},
                                             {3.5, "3"},
                                             {4.5, "4"},
                                             {5.0, "5-"},
                                             {5.5, "5+"},
                                             {6.0, "6-"},
                                             {6.5, "6+"}}};
  for (const Class& c : classes) {
    if (intensity < c.below) return c.name;
  }
  return "7";
}

JmaIntensity jma_intensity(const Components& components, double interval) {
  Components filtered;
  for (const auto& component : components) filtered.push_back(jma_filtered(component, interval));
  JmaIntensity out;
  out.level = level_held(vector_sum(filtered), interval, jma_hold);
  out.value = out.level > 0.0 ? 2.0 * std::log10(out.level / gal) + 0.94 : minus_infinity;
  const double hundredths = std::round(100.0 * out.value);
  out.reported = out.level > 0.0 ? std::max(0.0, std::floor(hundredths / 10.0) / 10.0) : 0.0;
  out.scale = jma_class(out.reported);
  return out;
}

ChinaIntensity china_intensity(double pga, double pgv) {
  ChinaIntensity out{pga, pgv, minus_infinity, minus_infinity, 1.0};
  if (pga <= 0.0 || pgv <= 0.0) return out;
  out.by_acceleration = 3.17 * std::log10(pga) + 6.59;
  out.by_velocity = 3.00 * std::log10(pgv) + 9.77;
  const bool strong = out.by_acceleration >= 6.0 && out.by_velocity >= 6.0;
  out.value = std::clamp(strong ? out.by_velocity : 0.5 * (out.by_acceleration + out.by_velocity), 1.0, 12.0);
  return out;
}

ChinaIntensity china_intensity(const Components& components, double interval) {
  Components accelerations, velocities;
  for (const auto& component : components) {
    accelerations.push_back(band_passed(component, interval));
    velocities.push_back(integrate(accelerations.back(), interval).velocity);
  }
  return china_intensity(peak(vector_sum(accelerations), interval).value,
                         peak(vector_sum(velocities), interval).value);
}

double mmi_by_acceleration(double pga) {
  if (pga <= 0.0) return 1.0;
  const double lg = std::log10(pga / gal);
  return std::clamp(lg < 1.57 ? 1.78 + 1.55 * lg : -1.60 + 3.70 * lg, 1.0, 10.0);
}

double mmi_by_velocity(double pgv) {
  if (pgv <= 0.0) return 1.0;
  const double lg = std::log10(pgv / 0.01);
  return std::clamp(lg <= 0.53 ? 3.78 + 1.47 * lg : 2.89 + 3.16 * lg, 1.0, 10.0);
}

}  // namespace dougong::seismic
