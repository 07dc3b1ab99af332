// A projectile without drag (any textbook of mechanics).
#pragma once

namespace dougong::oracles {

struct Projectile {
  double x0, y0, vx, vy, spin, g;

  double x(double t) const { return x0 + vx * t; }
  double y(double t) const { return y0 + vy * t - 0.5 * g * t * t; }
  double speed_up(double t) const { return vy - g * t; }
  double angle(double t) const { return spin * t; }
  /// What kick-then-drift Euler of step dt adds to y: each step falls g dt^2/2 too far.
  double symplectic_euler_offset(double t, double dt) const { return -0.5 * g * t * dt; }
};

}  // namespace dougong::oracles
