// All fields of a model at once: forces, energy, and how stiff and how damping they are now.
//
// Adding a field: its file, its line in FieldTerms and compile_fields, and one line in each function here.
#pragma once

#include "engine/fields/applied_force.h"
#include "engine/fields/drag.h"
#include "engine/fields/pair_field.h"
#include "engine/fields/uniform_electric.h"

namespace dougong::engine {

/// Adds the forces at the centroids (N); returns the power that drag takes (W).
double add_field_forces(const FieldTerms& fields, std::span<const Frame> frames, Tree& scratch,
                        std::span<Vec2> forces);

/// Potential energy of the pair fields, the uniform field and the applied forces (J).
double field_energy(const FieldTerms& fields, std::span<const Frame> frames);

/// Bounds on the eigenvalues of M^-1 K (rad2/s2) and M^-1 C (1/s) of the fields, at these places and speeds:
/// estimates, since a close passage raises the first at any time.
struct FieldRates {
  double stiffness = 0.0, damping = 0.0;
};
FieldRates field_rates(const FieldTerms& fields, std::span<const double> mass, std::span<const Frame> frames);

}  // namespace dougong::engine
