// Fourier amplitude of a motion, smoothed, and the mean period.
//
//   |A(f)| = h |sum_k a[k] exp(-2 pi i f k h)|                    m/s, the integral over the samples
//   Konno & Ohmachi, BSSA 88 (1998) 228-241:  mean of |A| with weights
//     W(f, fc) = [sin(b lg(f/fc)) / (b lg(f/fc))]^4,  b the bandwidth (40: narrow, 20: wide), 1 at f = fc
//   Tm = sum(C^2/f)/sum(C^2), 0.25 Hz <= f <= 20 Hz, in steps of at most 0.05 Hz   s
//     Rathje, Abrahamson & Bray, J. Geotech. Geoenviron. Eng. 124 (1998) 150-159; C = |A|
#pragma once

#include <span>
#include <vector>

namespace dougong::seismic {

/// At any frequency (Hz), by the sum itself.
double fourier_amplitude(std::span<const double> acceleration, double interval, double frequency);

/// At multiples of `frequency_step` from 0 to Nyquist, the record followed by zeros to a power of two
/// samples.
struct FourierSpectrum {
  double frequency_step = 0.0;    // Hz
  std::vector<double> amplitude;  // m/s
};
/// The step is at most `longest_step` Hz.
FourierSpectrum fourier_spectrum(std::span<const double> acceleration, double interval,
                                 double longest_step = 0.05);

/// Smoothed at the centres (Hz, above 0); the mean (f = 0) takes no part.
std::vector<double> konno_ohmachi(const FourierSpectrum& spectrum, std::span<const double> centres,
                                  double bandwidth = 40.0);

/// Zero for a record without energy in the band.
double mean_period(std::span<const double> acceleration, double interval, double lowest = 0.25,
                   double highest = 20.0);

}  // namespace dougong::seismic
