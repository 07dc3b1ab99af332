// Discrete Fourier transforms of power-of-two length, and trigonometric interpolation at any step.
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace dougong::seismic {

std::size_t next_power_of_two(std::size_t n);

/// X[m] = sum_k x[k] exp(-2 pi i k m / N), in place; N a power of two.
void fourier_transform(std::vector<std::complex<double>>& x);
/// x[k] = 1/N sum_m X[m] exp(+2 pi i k m / N), in place.
void inverse_fourier_transform(std::vector<std::complex<double>>& x);

/// The trigonometric polynomial through the N (power of two) samples, at t = k ratio sample steps,
/// k = 0 .. count-1; frequencies above `cutoff` cycles a sample are left out. The Nyquist term enters as
/// its cosine. The ratio may be any positive number: the sum over frequencies is a chirp transform
/// (Bluestein 1970), O(N log N).
std::vector<double> trigonometric_samples(std::span<const double> samples, double ratio, std::size_t count,
                                          double cutoff = 0.5);

}  // namespace dougong::seismic
