// A uniform electric field: F = q E, U = -q E . r, r from the model's origin.
#pragma once

#include "engine/fields/field_terms.h"
#include "engine/frame.h"

namespace dougong::engine {

inline UniformField uniform_electric(const Scene& scene) {
  UniformField field{scene.fields.electric_field, {}, {}};
  for (std::uint32_t i = 0; i < scene.bodies.size(); ++i) {
    if (scene.bodies[i].charge == 0.0) continue;
    field.bodies.push_back(i);
    field.charge.push_back(scene.bodies[i].charge);
  }
  return field;
}

inline void add_uniform_forces(const UniformField& field, std::span<Vec2> forces) {
  for (std::size_t k = 0; k < field.bodies.size(); ++k)
    forces[field.bodies[k]] += field.charge[k] * field.field;
}

inline double uniform_energy(const UniformField& field, std::span<const Frame> frames) {
  double energy = 0.0;
  for (std::size_t k = 0; k < field.bodies.size(); ++k)
    energy -= field.charge[k] * dot(field.field, frames[field.bodies[k]].position());
  return energy;
}

}  // namespace dougong::engine
