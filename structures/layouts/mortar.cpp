#include "structures/layouts/mortar.h"

namespace dougong::structures {

using enum Dimension;

std::vector<Parameter> mortar_parameters() {
  return {
      {"mortar_thickness", length, 0.01, 0.0, 0.1, "of mortared joints, part of the bricks' sizes"},
      {"mortar_modulus", pressure, 0.5e9, 1e5, 1e12, "Young's modulus of the mortar"},
      {"tensile_strength", pressure, 0.15e6, 0.0, 1e9, "of a mortared joint"},
      {"cohesion", pressure, 0.25e6, 0.0, 1e9, "shear strength of a mortared joint without normal stress"},
      {"fracture_energy", fracture_energy, 10.0, 0.0, 1e6,
       "of a mortared joint in tension; 0: it breaks at once"},
      {"compressive_strength", pressure, 0.0, 0.0, 1e10,
       "of the masonry across a mortared joint; 0: endless"},
  };
}

Connection mortar_of(const ParameterValues& values) {
  Connection mortar;
  mortar.law.tensile_strength = values("tensile_strength");
  mortar.law.cohesion = values("cohesion");
  mortar.law.friction_coefficient = values("friction");
  mortar.law.fracture_energy = values("tensile_strength") > 0.0 ? values("fracture_energy") : 0.0;
  mortar.law.compressive_strength = endless_if_zero(values("compressive_strength"));
  mortar.shear_coefficient = rectangle_shear;
  mortar.joint_thickness = values("mortar_thickness");
  mortar.joint_modulus = values("mortar_modulus");
  return mortar;
}

void lay_in_mortar(Building& building, const ParameterValues& values, double head_joint) {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < building.scene.bodies.size(); ++i) all.push_back(i);
  connect_touching(building, all, mortar_of(values), head_joint + 1e-6);
}

void require_mortar(const ParameterValues& values, double unit) {
  require(values("mortar_thickness") <= 0.5 * unit, values, "mortar_thickness",
          "at most half the height of a course, " + print_value(0.5 * unit, length));
}

}  // namespace dougong::structures
