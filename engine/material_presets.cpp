#include "engine/material_presets.h"

#include <algorithm>
#include <vector>

namespace dougong::engine {
namespace {

Material material(const char* name, double density, double young_modulus, double poisson_ratio,
                  double friction, double damping_ratio) {
  return {name, density, young_modulus, poisson_ratio, friction, damping_ratio};
}

// Blocks of buildings keep the plastic impact of engine/material.h; what bounces has a restitution.
std::vector<MaterialPreset> make_table() {
  const double plastic = Material{}.damping_ratio;
  return {
      {Material{},
       "C20/25: EN 1992-1-1:2004, table 3.1 and 3.1.3; density EN 1991-1-1, table A.1; friction of a smooth "
       "joint, EN 1992-1-1, 6.2.5"},
      {material("brick", 1900, 6e9, 0.15, 0.7, plastic),
       "handbook values for clay brick: E 3 to 12 GPa, friction of bed joints 0.6 to 0.8"},
      {material("stone", 2600, 40e9, 0.25, 0.65, plastic),
       "handbook values between limestone and granite; friction of dry sawn joints 30 to 35 degrees, Barton "
       "& Choubey, Rock Mechanics 10 (1977) 1-54"},
      {material("timber", 420, 11e9, 0.35, 0.4, plastic),
       "softwood along the grain: EN 338:2016, class C24, means; friction of wood on wood 0.25 to 0.5"},
      {material("steel", 7850, 210e9, 0.3, 0.6, damping_ratio_for_restitution(0.6)),
       "EN 1993-1-1:2005, 3.2.6; density EN 1991-1-1, table A.4; friction dry 0.5 to 0.8; restitution at "
       "walking speed, Johnson, Contact Mechanics (1985), 11.5"},
      {material("rubber", 1100, 5e6, 0.48, 0.9, damping_ratio_for_restitution(0.7)),
       "handbook values for natural rubber; Poisson's ratio kept below 1/2"},
      {material("glass", 2500, 70e9, 0.2, 0.9, damping_ratio_for_restitution(0.9)),
       "soda-lime glass: EN 572-1:2012, table 1; friction when clean 0.9 to 1.0"},
      {material("ptfe", 2200, 0.5e9, 0.46, 0.06, plastic),
       "handbook values for polytetrafluoroethylene; friction slow and dry 0.04 to 0.10"},
  };
}

}  // namespace

std::span<const MaterialPreset> material_presets() {
  static const std::vector<MaterialPreset> table = make_table();
  return table;
}

const MaterialPreset* find_material_preset(std::string_view name) {
  const auto presets = material_presets();
  const auto it = std::ranges::find(
      presets, name, [](const MaterialPreset& p) -> std::string_view { return p.material.name; });
  return it == presets.end() ? nullptr : &*it;
}

}  // namespace dougong::engine
