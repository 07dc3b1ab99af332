// A rigid block of half sizes b, h on a slope, static = kinetic friction, low enough not to tip (Coulomb).
#pragma once

#include <cmath>

namespace dougong::oracles {

struct Incline {
  double slope, friction, b, h, g;

  bool sticks() const { return std::tan(slope) <= friction; }
  double acceleration() const { return sticks() ? 0.0 : g * (std::sin(slope) - friction * std::cos(slope)); }
  double slid(double t) const { return 0.5 * acceleration() * t * t; }
  double friction_over_weight() const { return sticks() ? std::sin(slope) : friction * std::cos(slope); }
  /// Moments about the centroid: the friction at the base turns the block against the normal forces.
  double uphill_share() const { return 0.5 - 0.5 * h / b * (sticks() ? std::tan(slope) : friction); }
};

}  // namespace dougong::oracles
