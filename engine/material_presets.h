// Materials by name, for scenes that say "steel" and mean a usual one.
//
// Density, Young's modulus and Poisson's ratio at room temperature; friction of the material on itself, dry.
// These are mid values of what the named sources give, for a first model: a real stone, brick or timber
// differs by a factor of two in stiffness. The damping ratio belongs to the contact law (engine/material.h)
// and follows from a coefficient of restitution where one is known.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "engine/material.h"

namespace dougong::engine {

struct MaterialPreset {
  Material material;
  std::string source;  // one line: where the numbers come from
};

/// In the order in which they are listed.
std::span<const MaterialPreset> material_presets();
/// Null when there is none of that name.
const MaterialPreset* find_material_preset(std::string_view name);

}  // namespace dougong::engine
