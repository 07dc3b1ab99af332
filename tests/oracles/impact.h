// A free impact on a linear spring and dashpot whose force is never tensile, integrated numerically:
// what the closed form of the restitution is checked with. Dimensionless: w = 1, speed 1.
#pragma once

namespace dougong::oracles {

inline double restitution_by_integration(double damping_ratio, double dt = 1e-4) {
  const auto acceleration = [&](double x, double v) { return -x - 2.0 * damping_ratio * v; };
  double x = 0.0, v = 1.0;  // overlap and its rate
  while (true) {
    const double k1 = acceleration(x, v), x2 = x + 0.5 * dt * v, v2 = v + 0.5 * dt * k1;
    const double k2 = acceleration(x2, v2), x3 = x + 0.5 * dt * v2, v3 = v + 0.5 * dt * k2;
    const double k3 = acceleration(x3, v3), x4 = x + dt * v3, v4 = v + dt * k3;
    const double k4 = acceleration(x4, v4);
    x += dt / 6.0 * (v + 2.0 * (v2 + v3) + v4);
    v += dt / 6.0 * (k1 + 2.0 * (k2 + k3) + k4);
    if (v < 0.0 && x + 2.0 * damping_ratio * v <= 0.0) return -v;
  }
}

}  // namespace dougong::oracles
