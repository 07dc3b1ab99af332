#include "seismic/measures/fourier_spectrum.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "seismic/constants.h"
#include "seismic/numerics/fourier.h"

namespace dougong::seismic {
namespace {

double konno_ohmachi_weight(double ratio, double bandwidth) {
  const double x = bandwidth * std::log10(ratio);
  if (std::abs(x) < 1e-9) return 1.0;
  const double sinc = std::sin(x) / x;
  return sinc * sinc * sinc * sinc;
}

}  // namespace

double fourier_amplitude(std::span<const double> a, double interval, double frequency) {
  const double turn = two_pi * std::fmod(frequency * interval, 1.0);
  double real = 0.0, imaginary = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const double phase = turn * static_cast<double>(k);
    real += a[k] * std::cos(phase);
    imaginary -= a[k] * std::sin(phase);
  }
  return interval * std::hypot(real, imaginary);
}

FourierSpectrum fourier_spectrum(std::span<const double> a, double interval, double longest_step) {
  const auto least = static_cast<std::size_t>(std::ceil(1.0 / (longest_step * interval)));
  std::vector<std::complex<double>> x(a.begin(), a.end());
  x.resize(next_power_of_two(std::max({a.size(), least, std::size_t{2}})));
  fourier_transform(x);
  FourierSpectrum out{1.0 / (static_cast<double>(x.size()) * interval), {}};
  for (std::size_t m = 0; m <= x.size() / 2; ++m) out.amplitude.push_back(interval * std::abs(x[m]));
  return out;
}

std::vector<double> konno_ohmachi(const FourierSpectrum& spectrum, std::span<const double> centres,
                                  double bandwidth) {
  std::vector<double> smooth;
  for (const double centre : centres) {
    double sum = 0.0, weights = 0.0;
    for (std::size_t m = 1; m < spectrum.amplitude.size(); ++m) {
      const double ratio = static_cast<double>(m) * spectrum.frequency_step / centre;
      const double weight = konno_ohmachi_weight(ratio, bandwidth);
      sum += weight * spectrum.amplitude[m];
      weights += weight;
    }
    smooth.push_back(weights > 0.0 ? sum / weights : 0.0);
  }
  return smooth;
}

double mean_period(std::span<const double> a, double interval, double lowest, double highest) {
  const FourierSpectrum spectrum = fourier_spectrum(a, interval);
  double weighted = 0.0, sum = 0.0;
  for (std::size_t m = 1; m < spectrum.amplitude.size(); ++m) {
    const double f = static_cast<double>(m) * spectrum.frequency_step;
    if (f < lowest || f > highest) continue;
    const double square = spectrum.amplitude[m] * spectrum.amplitude[m];
    weighted += square / f;
    sum += square;
  }
  return sum > 0.0 ? weighted / sum : 0.0;
}

}  // namespace dougong::seismic
