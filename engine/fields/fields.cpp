#include "engine/fields/fields.h"

#include <cmath>
#include <stdexcept>

#include "engine/fields/coulomb.h"
#include "engine/fields/gravitation.h"

namespace dougong::engine {
namespace {

void check_constant(double value, const char* name) {
  if (!(value >= 0.0) || !std::isfinite(value))
    throw std::invalid_argument(std::string("fields: the ") + name + " must not be negative, found " +
                                std::to_string(value));
}

void check_constants(const Fields& f) {
  check_constant(f.gravitational_constant, "gravitational constant");
  check_constant(f.coulomb_constant, "Coulomb constant");
  check_constant(f.softening, "softening");
  check_constant(f.opening_angle, "opening angle");
  if (!std::isfinite(f.electric_field.x) || !std::isfinite(f.electric_field.y))
    throw std::invalid_argument("fields: the electric field must be finite");
}

void check_charges(const Scene& scene) {
  for (const Body& body : scene.bodies)
    if (!std::isfinite(body.charge))
      throw std::invalid_argument(body.name + ": charge must be finite, found " +
                                  std::to_string(body.charge));
}

}  // namespace

FieldTerms compile_fields(const Scene& scene, std::span<const double> mass) {
  check_constants(scene.fields);
  check_charges(scene);
  FieldTerms terms;
  if (scene.fields.gravitational_constant > 0.0 && mass.size() > 1)
    terms.pairs.push_back(gravitation(scene.fields, mass));
  if (scene.fields.coulomb_constant > 0.0) {
    PairField field = coulomb(scene);
    if (field.bodies.size() > 1) terms.pairs.push_back(std::move(field));
  }
  if (norm(scene.fields.electric_field) > 0.0) terms.uniform = uniform_electric(scene);
  terms.applied = applied_forces(scene);
  terms.drag = drag(scene);
  return terms;
}

double add_field_forces(const FieldTerms& fields, std::span<const Frame> frames, Tree& scratch,
                        std::span<Vec2> forces) {
  for (const PairField& pair : fields.pairs) add_pair_forces(pair, frames, scratch, forces);
  add_uniform_forces(fields.uniform, forces);
  add_applied_forces(fields.applied, frames, forces);
  return add_drag_forces(fields.drag, frames, forces);
}

double field_energy(const FieldTerms& fields, std::span<const Frame> frames) {
  Tree scratch;
  double energy = uniform_energy(fields.uniform, frames) + applied_energy(fields.applied, frames);
  for (const PairField& pair : fields.pairs) energy += pair_energy(pair, frames, scratch);
  return energy;
}

FieldRates field_rates(const FieldTerms& fields, std::span<const double> mass,
                       std::span<const Frame> frames) {
  Tree scratch;
  FieldRates rates;
  for (const PairField& pair : fields.pairs) rates.stiffness += pair_stiffness(pair, mass, frames, scratch);
  rates.stiffness += applied_stiffness(fields.applied, mass);
  rates.damping = drag_rate(fields.drag, mass, frames);
  return rates;
}

}  // namespace dougong::engine
