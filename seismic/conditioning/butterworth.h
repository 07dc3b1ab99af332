// Butterworth filter in second-order sections, forward and backward: no shift of phase.
//
//   prototype poles  s_k = exp(i pi (2k + n + 1)/(2n)), k = 0 .. n-1      n  order
//   low pass   s -> s/wc,  high pass  s -> wc/s,  band pass  s -> (s^2 + w0^2)/(B s)
//   bilinear   s = 2 (1 - z^-1)/(1 + z^-1),  w = 2 tan(pi f h): the corners fall where they are asked for
//
// A band pass of order n has 2n poles. The gain at a corner is 1/sqrt(2) a pass, so 1/2 (-6 dB) of both.
// Sections, because one polynomial of order 8 with a corner at 0.1 Hz is numerically poor.
// Sources: Butterworth 1930; Oppenheim & Schafer, Discrete-Time Signal Processing, ch. 7.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace dougong::seismic {

/// y[k] = b0 x[k] + b1 x[k-1] + b2 x[k-2] - a1 y[k-1] - a2 y[k-2].
struct Section {
  double b0 = 1.0, b1 = 0.0, b2 = 0.0;
  double a1 = 0.0, a2 = 0.0;
};

struct Band {
  std::optional<double> high_pass;  // Hz, lower corner
  std::optional<double> low_pass;   // Hz, upper corner
  int order = 4;                    // of the prototype; 1 to 12
};

/// The sections of one pass for samples `interval` apart. Throws std::invalid_argument for another order or
/// corners that are not 0 < high pass < low pass < Nyquist.
std::vector<Section> butterworth(const Band& band, double interval);

/// |H(f)| of one pass.
double gain(std::span<const Section> sections, double frequency, double interval);

/// One pass in the direction of time from rest (zero state), in place.
void filter_forward(std::span<const Section> sections, std::vector<double>& samples);

/// Forward, then backward, both from rest: the gain is that of one pass squared, the phase is zero.
void filter_both_ways(std::span<const Section> sections, std::vector<double>& samples);

}  // namespace dougong::seismic
