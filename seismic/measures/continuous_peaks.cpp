#include "seismic/measures/continuous_peaks.h"

#include <algorithm>
#include <cmath>

#include "seismic/constants.h"

namespace dougong::seismic {
namespace {

constexpr double longest_part = 0.2;  // rad of the oscillator

// A value and its derivative by scaled time w t.
struct Jet {
  double value = 0.0, slope = 0.0;
};

// Greatest magnitude behind the start of a part of length s on the cubic of Hermite.
double cubic_peak(Jet from, Jet to, double s) {
  double most = std::abs(to.value);
  const double rise = (to.value - from.value) / s;
  if (from.slope * to.slope >= 0.0 && from.slope * rise >= 0.0) return most;
  // f = value + s x (slope + x (b + x c)), x in 0..1: f'/s = slope + 2 b x + 3 c x^2.
  const double b = 3.0 * rise - 2.0 * from.slope - to.slope, c = from.slope + to.slope - 2.0 * rise;
  const double root = std::sqrt(std::max(0.0, b * b - 3.0 * c * from.slope));
  const double q = -(b + std::copysign(root, b));
  for (const double x : {q / (3.0 * c), from.slope / q}) {
    if (x > 0.0 && x < 1.0)
      most = std::max(most, std::abs(from.value + s * x * (from.slope + x * (b + x * c))));
  }
  return most;
}

struct Jets {
  Jet displacement, velocity, acceleration;
};

// U' = V, V' = -(a + U + 2 zeta V), and of the absolute acceleration U + 2 zeta V.
Jets jets_of(double u, double v, double a, double twice_damping) {
  const double v_slope = -(a + u + twice_damping * v);
  return {{u, v}, {v, v_slope}, {u + twice_damping * v, v + twice_damping * v_slope}};
}

void widen(OscillatorPeaks& peaks, const Jets& from, const Jets& to, double s) {
  peaks.displacement = std::max(peaks.displacement, cubic_peak(from.displacement, to.displacement, s));
  peaks.velocity = std::max(peaks.velocity, cubic_peak(from.velocity, to.velocity, s));
  peaks.acceleration = std::max(peaks.acceleration, cubic_peak(from.acceleration, to.acceleration, s));
}

}  // namespace

OscillatorPeaks continuous_peaks(std::span<const double> a, double interval, const Oscillator& oscillator) {
  const double s_step = two_pi / oscillator.period * interval;
  const int parts = std::max(1, static_cast<int>(std::ceil(s_step / longest_part)));
  const OscillatorStep c = scaled_oscillator_step(oscillator, interval / parts);
  const double damping = 2.0 * oscillator.damping_ratio;
  OscillatorPeaks peaks;
  double u = 0.0, v = 0.0;
  Jets before = jets_of(0.0, 0.0, a.empty() ? 0.0 : a[0], damping);
  for (std::size_t k = 1; k < a.size(); ++k) {
    const double rise = (a[k] - a[k - 1]) / parts;
    for (int i = 0; i < parts; ++i) {
      const double a0 = a[k - 1] + i * rise, a1 = i + 1 == parts ? a[k] : a0 + rise;
      const double next = (c.uu * u + c.uv * v) + (c.ua * a0 + c.ub * a1);
      v = (c.vu * u + c.vv * v) + (c.va * a0 + c.vb * a1);
      u = next;
      const Jets after = jets_of(u, v, a1, damping);
      widen(peaks, before, after, s_step / parts);
      before = after;
    }
  }
  return peaks;
}

}  // namespace dougong::seismic
