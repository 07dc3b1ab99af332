// A disc that slides and rolls on a rigid plane, static = kinetic friction (Coulomb). Moment of inertia
// m R^2 / 2: friction turns it twice as fast as it brakes it.
#pragma once

#include <algorithm>
#include <cmath>

namespace dougong::oracles {

/// Let go from rest on a slope.
struct DiscOnSlope {
  double slope, friction, radius, g;

  bool rolls() const { return std::tan(slope) <= 3.0 * friction; }
  double acceleration() const {
    return rolls() ? 2.0 / 3.0 * g * std::sin(slope) : g * (std::sin(slope) - friction * std::cos(slope));
  }
  double spin_rate() const {
    return rolls() ? acceleration() / radius : 2.0 * friction * g * std::cos(slope) / radius;
  }
  double friction_over_weight() const { return rolls() ? std::sin(slope) / 3.0 : friction * std::cos(slope); }
};

/// Thrown along a level floor. `spin` > 0 is that of rolling forwards.
struct ThrownDisc {
  double speed, spin, friction, radius, g;

  double slip() const { return speed - spin * radius; }
  double slides_until() const { return std::abs(slip()) / (3.0 * friction * g); }
  double rolling_speed() const { return speed - slip() / 3.0; }
  double went_while_sliding() const { return 0.5 * (speed + rolling_speed()) * slides_until(); }
};

}  // namespace dougong::oracles
