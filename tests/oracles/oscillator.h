// x'' + c x' + w^2 x = 0 from x(0) = 1, x'(0) = 0, exactly and as each integrator's own recursion has it.
#pragma once

#include <cmath>

namespace dougong::oracles {

struct Motion {
  double x = 1.0, v = 0.0;
};

inline Motion damped_oscillator(double w, double c, double t) {
  const double d = 0.5 * c, wd = std::sqrt(w * w - d * d);
  const double e = std::exp(-d * t), cosine = std::cos(wd * t), sine = std::sin(wd * t);
  return {e * (cosine + d / wd * sine), -e * (w * w / wd) * sine};
}

// Undamped steps as linear maps of (x, v): Hairer, Lubich and Wanner, Geometric Numerical Integration, I.1.
inline Motion symplectic_euler_map(Motion m, double w, double h) {
  const double v = m.v - h * w * w * m.x;
  return {m.x + h * v, v};
}
inline Motion velocity_verlet_map(Motion m, double w, double h) {
  const double a = 1.0 - 0.5 * w * w * h * h;
  return {a * m.x + h * m.v, a * m.v - w * w * h * (1.0 - 0.25 * w * w * h * h) * m.x};
}
inline Motion leapfrog_map(Motion m, double w, double h) {
  const double middle = m.x + 0.5 * h * m.v, v = m.v - h * w * w * middle;
  return {middle + 0.5 * h * v, v};
}
inline Motion explicit_euler_map(Motion m, double w, double h) {
  return {m.x + h * m.v, m.v - h * w * w * m.x};
}
/// The exponential series of the oscillator's matrix, cut after h^3 and after h^4.
inline Motion rk3_map(Motion m, double w, double h) {
  const double z = w * w * h * h;
  const double c = 1.0 - z / 2.0, s = h * (1.0 - z / 6.0);
  return {c * m.x + s * m.v, c * m.v - w * w * s * m.x};
}
inline Motion rk4_map(Motion m, double w, double h) {
  const double z = w * w * h * h;
  const double c = 1.0 - z / 2.0 + z * z / 24.0, s = h * (1.0 - z / 6.0);
  return {c * m.x + s * m.v, c * m.v - w * w * s * m.x};
}

template <class Map>
Motion after_steps(Map map, double w, double h, int steps) {
  Motion m;
  for (int i = 0; i < steps; ++i) m = map(m, w, h);
  return m;
}

}  // namespace dougong::oracles
