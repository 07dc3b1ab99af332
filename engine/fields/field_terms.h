// The fields of a scene, compiled: what acts at a distance or with the air, as arrays. What a scene lacks
// is not there, and neutral bodies do not appear.
//
//   pair field   U = K w_i w_j / sqrt(r^2 + softening^2)   gravitation: K = -G, w = mass (gravitation.h)
//                                                          electrostatic: K = k, w = charge (coulomb.h)
//   uniform      F = q E                                   (uniform_electric.h)
//   applied      F = (factor - relief W) p                 (applied_force.h)
//   drag         F = -(c + c2 |v|) v                       (drag.h)
//
// All act at the centroids; none exerts a torque.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/scene.h"

namespace dougong::engine {

/// One law of inverse distance among the bodies that carry its weight.
struct PairField {
  const char* name = "";
  double strength = 0.0;           // K
  double softening_squared = 0.0;  // m2
  double opening_angle = 0.0;      // -, 0: direct sum
  std::vector<std::uint32_t> bodies;
  std::vector<double> weight;  // of `bodies`: kg or C
};

struct UniformField {
  Vec2 field;  // V/m
  std::vector<std::uint32_t> bodies;
  std::vector<double> charge;  // C
};

struct AppliedForces {
  double factor = 1.0;  // -
  double relief = 0.0;  // 1/J
  std::vector<std::uint32_t> bodies;
  std::vector<Vec2> force;  // N
};

struct DragField {
  std::vector<std::uint32_t> bodies;
  std::vector<double> linear, quadratic;  // N s/m, N s2/m2
};

struct FieldTerms {
  std::vector<PairField> pairs;
  UniformField uniform;
  AppliedForces applied;
  DragField drag;
  bool empty() const {
    return pairs.empty() && uniform.bodies.empty() && applied.bodies.empty() && drag.bodies.empty();
  }
};

/// Throws std::invalid_argument, naming the body or the constant, for charges and applied forces that
/// are not finite and for constants or drag that are negative or not finite.
FieldTerms compile_fields(const Scene& scene, std::span<const double> mass);

}  // namespace dougong::engine
