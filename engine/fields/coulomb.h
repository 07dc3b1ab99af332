// Electrostatic forces between charged bodies: U = k q_i q_j / sqrt(r^2 + softening^2).
//
//   k  Coulomb's constant, N m2/C2    q  charge, C: like charges repel
// No magnetic forces and no radiation. Jackson, Classical Electrodynamics, 3rd ed. (1999), eq. 1.2.
#pragma once

#include "engine/fields/field_terms.h"

namespace dougong::engine {

inline PairField coulomb(const Scene& scene) {
  PairField field{"electrostatic",
                  scene.fields.coulomb_constant,
                  scene.fields.softening * scene.fields.softening,
                  scene.fields.opening_angle,
                  {},
                  {}};
  for (std::uint32_t i = 0; i < scene.bodies.size(); ++i) {
    if (scene.bodies[i].charge == 0.0) continue;
    field.bodies.push_back(i);
    field.weight.push_back(scene.bodies[i].charge);
  }
  return field;
}

}  // namespace dougong::engine
