// Forces that are applied at the centroids and keep their direction: F_i = lambda p_i.
//
//   p_i  Body::applied_force, N
//   lambda = factor - relief W,   W = sum p_i . r_i,   r from the model's origin, J
//   U = -factor W + relief W^2 / 2
// With relief 0 the load is dead. With relief c (1/J) it is a spring through which the loads are pulled in
// their proportions: they fall off as the bodies give way, so that a falling branch can be followed. W is
// the displacement that the loads work on (Riks, Int. J. Solids Struct. 15 (1979) 529-551, calls for such a
// control of the path).
#pragma once

#include "engine/fields/field_terms.h"
#include "engine/frame.h"

namespace dougong::engine {

/// Throws std::invalid_argument, naming the body or the constant, for forces and factors that are not finite
/// and a relief that is negative.
AppliedForces applied_forces(const Scene& scene);

/// W of the loads at these poses (J).
double applied_work(const AppliedForces& loads, std::span<const Frame> frames);

inline double applied_multiplier(const AppliedForces& loads, std::span<const Frame> frames) {
  return loads.relief == 0.0 ? loads.factor : loads.factor - loads.relief * applied_work(loads, frames);
}

void add_applied_forces(const AppliedForces& loads, std::span<const Frame> frames, std::span<Vec2> forces);

double applied_energy(const AppliedForces& loads, std::span<const Frame> frames);

/// The spring's only eigenvalue of M^-1 K (rad2/s2).
double applied_stiffness(const AppliedForces& loads, std::span<const double> mass);

}  // namespace dougong::engine
