// The exact response of a damped oscillator to base acceleration that is linear between samples.
//
//   u'' + 2 zeta w u' + w^2 u = -a(t),   u, u' relative to the base,  w = 2 pi / T
//
// One step maps (u, u', a[k], a[k+1]) to (u, u') at its end by constant coefficients (Nigam & Jennings,
// Bull. Seism. Soc. Am. 59, 1969, 909-922). They are taken from the exponential of the augmented system
// (u, u', a, a'), by Taylor series with scaling and squaring: the closed forms of the paper lose digits
// as w h becomes small, this does not, and critical or heavy damping needs no other formula.
#pragma once

#include <span>
#include <vector>

namespace dougong::seismic {

struct Oscillator {
  double period = 1.0;  // s
  double damping_ratio = 0.05;
};

/// u[k+1] = uu u + uv v + ua a[k] + ub a[k+1], and so for v.
struct OscillatorStep {
  double uu, uv, ua, ub;
  double vu, vv, va, vb;
};

OscillatorStep oscillator_step(const Oscillator& oscillator, double interval);
/// The same of U = w^2 u and V = w u' (both m/s2), whose coefficients are all of order one.
OscillatorStep scaled_oscillator_step(const Oscillator& oscillator, double interval);

struct OscillatorHistory {
  std::vector<double> displacement;           // m, relative
  std::vector<double> velocity;               // m/s, relative
  std::vector<double> absolute_acceleration;  // m/s2, -(2 zeta w u' + w^2 u)
};

/// From rest.
OscillatorHistory oscillator_response(std::span<const double> acceleration, double interval,
                                      const Oscillator& oscillator);

}  // namespace dougong::seismic
