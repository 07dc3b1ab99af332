// Motion against drag. Linear: v' = -k v + g.  Quadratic, along one line: v' = g - k v|v|.
// Any textbook of mechanics, e.g. Taylor, Classical Mechanics (2005), ch. 2.
#pragma once

#include <cmath>

namespace dougong::oracles {

/// Thrown from the origin; k = c/m (1/s).
struct DraggedProjectile {
  double vx, vy, k, g;

  double x(double t) const { return vx / k * -std::expm1(-k * t); }
  double y(double t) const { return -g * t / k - (vy + g / k) / k * std::expm1(-k * t); }
  double speed_x(double t) const { return vx * std::exp(-k * t); }
  double speed_y(double t) const { return (vy + g / k) * std::exp(-k * t) - g / k; }
};

/// Coasting against k v|v|, k = c2/m (1/m).
inline double coasted(double v, double k, double t) {
  return std::log1p(k * v * t) / k;
}
/// Fallen from rest against k v|v|.
inline double fallen(double g, double k, double t) {
  return std::log(std::cosh(std::sqrt(g * k) * t)) / k;
}

}  // namespace dougong::oracles
