// A rigid body hung from a pin: I_p theta'' = -m g r sin(theta).
//   T = 4 sqrt(I_p/(m g r)) K(k), k = sin(theta_0/2), K the complete elliptic integral of the first kind.
#pragma once

#include <cmath>
#include <numbers>

namespace dougong::oracles {

/// Rectangle of half sizes b, h hung from a corner.
struct PinnedRectangle {
  double b, h, g, release;  // m, m, m/s2, rad from the rest position

  double radius() const { return std::hypot(b, h); }
  double small_period() const {
    // I_p / m = (b2 + h2)/3 + r2 = 4 r2 / 3
    return 2.0 * std::numbers::pi * std::sqrt(4.0 * radius() / (3.0 * g));
  }
  double period() const {
    return small_period() * 2.0 / std::numbers::pi * std::comp_ellint_1(std::sin(release / 2.0));
  }
  /// Rotation that brings the diagonal through the corner (-b, h) to hang straight down.
  double rest_angle() const { return -(0.5 * std::numbers::pi - std::atan2(h, b)); }
};

}  // namespace dougong::oracles
