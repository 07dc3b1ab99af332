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

#include "engine/lanes.h"

namespace dougong::engine {

template <class R>
struct PointStiffnessOf {
  R normal{};              // kn, N/m
  R tangential{};          // kt, N/m
  R normal_damping{};      // cn, N s/m
  R tangential_damping{};  // ct, N s/m
  R friction{};            // mu, -
  R resting = R{} + 1.0;   // -, damping at rest on a whole face over cn and ct
};
using PointStiffness = PointStiffnessOf<double>;

/// The same law on a part of the length, with a part of the damping.
template <class R>
[[gnu::always_inline]] inline PointStiffnessOf<R> scaled(const PointStiffnessOf<R>& law, R part, R damping) {
  return {part * law.normal,
          part * law.tangential,
          part * damping * law.normal_damping,
          part * damping * law.tangential_damping,
          law.friction,
          law.resting};
}

template <class R>
[[gnu::always_inline]] inline R normal_force(R stiffness, R damping, R overlap, R overlap_rate) {
  const R force = stiffness * overlap + damping * overlap_rate;
  return where_positive(overlap, where_positive(force, force, R{}), R{});
}

template <class R>
[[gnu::always_inline]] inline R friction_force(R elastic_and_viscous, R limit) {
  return lesser(greater(elastic_and_viscous, -limit), limit);
}

/// The slip that the spring keeps once Coulomb's limit has been applied.
template <class R>
[[gnu::always_inline]] inline R returned_slip(R slip, R stiffness, R limit) {
  const R elastic = stiffness * slip;
  const R most = where_less(slip, R{}, -limit, limit) / stiffness;
  return where_positive(stiffness, where_less(limit, magnitude(elastic), most, slip), R{});
}

}  // namespace dougong::engine
