#include "seismic/numerics/fourier.h"

#include <gsl/gsl_fft_complex.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

#include "seismic/constants.h"

namespace dougong::seismic {
namespace {

using Complex = std::complex<double>;

double* as_packed(std::vector<Complex>& x) {
  return reinterpret_cast<double*>(x.data());
}

// exp(i pi alpha n^2) with the turns reduced first: n^2 alpha / 2 is a large number of them.
Complex chirp(double alpha, std::size_t n) {
  const long double square = static_cast<long double>(n) * static_cast<long double>(n);
  const double turns = static_cast<double>(std::fmod(0.5L * static_cast<long double>(alpha) * square, 1.0L));
  return {std::cos(two_pi * turns), std::sin(two_pi * turns)};
}

// y[k] = sum_m X[m] exp(2 pi i alpha m k), by m k = (m^2 + k^2 - (k - m)^2)/2: a convolution of chirps.
std::vector<Complex> chirp_transform(const std::vector<Complex>& spectrum, double alpha, std::size_t count) {
  const std::size_t terms = spectrum.size(), size = next_power_of_two(terms + count);
  std::vector<Complex> x(size), kernel(size);
  for (std::size_t m = 0; m < terms; ++m) x[m] = spectrum[m] * chirp(alpha, m);
  for (std::size_t k = 0; k < count; ++k) kernel[k] = std::conj(chirp(alpha, k));
  for (std::size_t m = 1; m < terms; ++m) kernel[size - m] = std::conj(chirp(alpha, m));
  fourier_transform(x);
  fourier_transform(kernel);
  for (std::size_t i = 0; i < size; ++i) x[i] *= kernel[i];
  inverse_fourier_transform(x);
  x.resize(count);
  for (std::size_t k = 0; k < count; ++k) x[k] *= chirp(alpha, k);
  return x;
}

}  // namespace

std::size_t next_power_of_two(std::size_t n) {
  return std::bit_ceil(n);
}

void fourier_transform(std::vector<Complex>& x) {
  assert(std::has_single_bit(x.size()));
  gsl_fft_complex_radix2_forward(as_packed(x), 1, x.size());
}

void inverse_fourier_transform(std::vector<Complex>& x) {
  assert(std::has_single_bit(x.size()));
  gsl_fft_complex_radix2_inverse(as_packed(x), 1, x.size());
}

std::vector<double> trigonometric_samples(std::span<const double> samples, double ratio, std::size_t count,
                                          double cutoff) {
  const std::size_t n = samples.size(), half = n / 2;
  std::vector<Complex> spectrum(samples.begin(), samples.end());
  fourier_transform(spectrum);
  spectrum.resize(half + 1);
  // A real signal: twice the positive frequencies, but the mean and the Nyquist term once.
  for (std::size_t m = 0; m <= half; ++m) {
    const bool once = m == 0 || m == half;
    const bool kept = static_cast<double>(m) <= cutoff * static_cast<double>(n);
    spectrum[m] *= kept ? (once ? 1.0 : 2.0) / static_cast<double>(n) : 0.0;
  }
  const auto waves = chirp_transform(spectrum, ratio / static_cast<double>(n), count);
  std::vector<double> out(count);
  std::transform(waves.begin(), waves.end(), out.begin(), [](Complex wave) { return wave.real(); });
  return out;
}

}  // namespace dougong::seismic
