// Rigid blocks in equilibrium on one or two corners.
#pragma once

#include <cmath>

namespace dougong::oracles {

/// A block of half sizes b, h on corner springs k under gravity g.
struct RestingBlock {
  double mass, stiffness, g;

  double penetration() const { return 0.5 * mass * g / stiffness; }
  double reaction() const { return mass * g; }
  /// Both springs act on the vertical motion: w^2 = 2 k / m.
  double frequency() const { return std::sqrt(2.0 * stiffness / mass); }
  double verlet_step() const { return 2.0 / frequency(); }
  double rk4_step() const { return 2.0 * std::sqrt(2.0) / frequency(); }
};

/// Stiffness of two plates pressed onto each other.
inline double in_series(double k1, double k2) {
  return 1.0 / (1.0 / k1 + 1.0 / k2);
}

/// n equal blocks of half sizes b, h stacked, as a rigid body on its edge.
struct Stack {
  double b, h;
  int count;

  double toppling_tilt() const { return std::atan(b / (count * h)); }
  double toppling_acceleration(double g) const { return g * b / (count * h); }
};

/// Greatest overhang of the k-th block of length L from the top, over the one below: the common centre of
/// the k blocks above is then over the edge.
inline double overhang_limit(double length, int k) {
  return length / (2.0 * k);
}

/// Share of the weight on the loaded corner under a horizontal acceleration a.
inline double loaded_corner_share(double b, double h, double a, double g) {
  return 0.5 + 0.5 * (a / g) * (h / b);
}

}  // namespace dougong::oracles
