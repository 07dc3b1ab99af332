#include "structures/layouts/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dougong::structures {

using enum Dimension;

std::vector<Parameter> material_parameters(const engine::Material& standard) {
  return {
      {"young_modulus", pressure, standard.young_modulus, 1e5, 1e12, "Young's modulus of blocks and ground"},
      {"density", density, standard.density, 1.0, 25e3, "density of the blocks"},
      {"friction", ratio, standard.friction_coefficient, 0.0, 10.0,
       "coefficient of friction, static and sliding"},
      {"damping_ratio", ratio, standard.damping_ratio, 0.0, 10.0,
       "damping of a contact point over its critical damping; 1: a corner lands without rebound"},
      {"resting_damping_ratio", ratio, engine::ContactOptions{}.resting_damping_ratio, 0.0, 10.0,
       "damping of a face that rests on both its ends, if less than damping_ratio"},
      {"restitution", ratio, 0.0, 0.0, 1.0,
       "coefficient of restitution of a contact point, instead of damping_ratio; 0: damping_ratio holds"},
      {"rocking_restitution", ratio, 0.0, 0.0, 1.0,
       "measured spin after over before a rocking impact; 0: what the contact law gives (Housner's)"},
      {"thickness", length, 1.0, 1e-3, 1e3, "out-of-plane thickness of the blocks"},
  };
}

Parameter ground_width_parameter(double standard) {
  return {"ground_width", length, standard, 0.1, 1e4, "width of the ground, centred at x = 0"};
}

std::vector<Parameter> joined(std::vector<Parameter> first, const std::vector<Parameter>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

Building on_ground(const std::string& material_name, const ParameterValues& values) {
  Building building;
  engine::Material& material = building.scene.materials.front();
  material.name = material_name;
  material.young_modulus = values("young_modulus");
  material.density = values("density");
  material.friction_coefficient = values("friction");
  const double restitution = values("restitution");
  material.damping_ratio =
      restitution > 0.0 ? engine::damping_ratio_for_restitution(restitution) : values("damping_ratio");
  building.scene.contact.resting_damping_ratio = values("resting_damping_ratio");
  if (values("rocking_restitution") > 0.0) material.rocking_restitution = values("rocking_restitution");

  engine::Terrain ground;
  ground.name = "ground";
  ground.shape = engine::make_rectangle(values("ground_width"), ground_depth);
  ground.position = {0.0, -0.5 * ground_depth};
  building.scene.terrains.push_back(std::move(ground));
  return building;
}

namespace {

std::size_t add_block(Building& building, const ParameterValues& values, const std::string& name,
                      engine::Shape shape, engine::Vec2 position) {
  engine::Body block;
  block.name = name;
  block.shape = std::move(shape);
  block.position = position;
  block.thickness = values("thickness");
  building.scene.bodies.push_back(std::move(block));
  return building.scene.bodies.size() - 1;
}

}  // namespace

std::size_t add_rectangle(Building& building, const ParameterValues& values, const std::string& name,
                          double centre, double bottom, double width, double height) {
  return add_block(building, values, name, engine::make_rectangle(width, height),
                   {centre, bottom + 0.5 * height});
}

std::size_t add_outline(Building& building, const ParameterValues& values, const std::string& name,
                        const std::vector<engine::Vec2>& outline) {
  const engine::PlacedPolygon placed = engine::make_polygon(outline);
  return add_block(building, values, name, placed.polygon, placed.centroid);
}

void require_on_ground(const ParameterValues& values, double left, double right) {
  const double needed = 2.0 * std::max(std::abs(left), std::abs(right));
  // A millionth of slack: a width typed with all its digits is meant to fit exactly.
  if (values("ground_width") * (1.0 + 1e-6) >= needed) return;
  throw LayoutError("ground_width", "at least the width of what stands on it, " + print_value(needed, length),
                    print_value(values("ground_width"), length));
}

}  // namespace dougong::structures
