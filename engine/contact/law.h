// The contact law at one point: a linear spring and dashpot along the normal, never tensile, and an
// elastic spring with Coulomb return along the tangent.
//
//   N = max(0, kn d + cn d')             d overlap (m), d' its rate
//   T = clamp(kt s + ct s', -mu N, mu N) s slip from the spring's anchor (m), s' its rate
//
// T opposes the slip. When |kt s| exceeds mu N the anchor follows, so that the spring never holds more
// than the friction can: a point that sticks has a fixed anchor and does not creep.
// Source: Cundall and Strack, Geotechnique 29 (1979) 47-65.
#pragma once

#include <algorithm>

namespace dougong::engine {

struct PointStiffness {
  double normal = 0.0;              // kn, N/m
  double tangential = 0.0;          // kt, N/m
  double normal_damping = 0.0;      // cn, N s/m
  double tangential_damping = 0.0;  // ct, N s/m
  double friction = 0.0;            // mu, -
  double resting = 1.0;             // -, damping at rest on a whole face over cn and ct
};

/// The same law on a part of the length, with a part of the damping.
inline PointStiffness scaled(const PointStiffness& law, double part, double damping) {
  return {part * law.normal,
          part * law.tangential,
          part * damping * law.normal_damping,
          part * damping * law.tangential_damping,
          law.friction,
          law.resting};
}

inline double normal_force(double stiffness, double damping, double overlap, double overlap_rate) {
  const double force = stiffness * overlap + damping * overlap_rate;
  return overlap > 0.0 && force > 0.0 ? force : 0.0;
}

inline double friction_force(double elastic_and_viscous, double limit) {
  return std::min(std::max(elastic_and_viscous, -limit), limit);
}

/// The slip that the spring keeps once Coulomb's limit has been applied.
inline double returned_slip(double slip, double stiffness, double limit) {
  const double held = friction_force(stiffness * slip, limit);
  return stiffness > 0.0 ? held / stiffness : 0.0;
}

}  // namespace dougong::engine
