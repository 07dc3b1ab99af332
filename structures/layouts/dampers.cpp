#include "structures/layouts/dampers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "structures/layouts/parts.h"

namespace dougong::structures {
namespace {

using enum Dimension;
using engine::Vec2;

/// One end of a level: a block and its outermost place at mid-height.
struct End {
  engine::Owner owner;
  Vec2 place;  // m
};

End end_of_level(const Building& building, const Storey& storey, double side) {
  const auto outer = [&](std::size_t i) {
    const Bounds box = bounds_of(building, i);
    return side < 0.0 ? -box.low.x : box.high.x;
  };
  const std::size_t i = *std::ranges::max_element(storey.level_blocks, {}, outer);
  const Bounds box = bounds_of(building, i);
  return {block(i), {side * outer(i), 0.5 * (box.low.y + box.high.y)}};
}

/// Of the level below a storey; the ground's ends are plumb under those of the storey's own level.
End end_below(const Building& building, std::size_t storey, double side) {
  if (storey > 0) return end_of_level(building, building.storeys[storey - 1], side);
  return {ground(), {end_of_level(building, building.storeys[0], side).place.x, 0.0}};
}

/// The level's block that is nearest to x.
std::size_t block_at(const Building& building, const Storey& storey, double x) {
  return *std::ranges::min_element(storey.level_blocks, {}, [&](std::size_t i) {
    const Bounds box = bounds_of(building, i);
    return std::max({0.0, box.low.x - x, x - box.high.x});
  });
}

End middle_below(const Building& building, std::size_t storey, double x) {
  if (storey == 0) return {ground(), {x, 0.0}};
  const std::size_t i = block_at(building, building.storeys[storey - 1], x);
  return {block(i), {x, building.scene.bodies[i].position.y}};
}

void add_dashpots(Building& building, const ParameterValues& values) {
  for (std::size_t s = 0; s < building.storeys.size(); ++s) {
    const End foot = end_below(building, s, -1.0), head = end_of_level(building, building.storeys[s], 1.0);
    engine::Joint dashpot =
        joint_at(building, building.storeys[s].name + ".damper", engine::JointKind::spring, foot.owner,
                 head.owner, foot.place, head.place, 0.0);
    dashpot.damping = values("damper_coefficient");
    building.scene.joints.push_back(std::move(dashpot));
  }
}

// --- friction ------------------------------------------------------------------------------------------

constexpr double shoe_length = 0.2, shoe_height = 0.1;  // m

// Nothing touches the shoe: it is held by its bars and by a bond with the level that flows in shear. Its two
// springs along the normal keep it from turning; they are soft enough to leave the weight to the building.
void add_shoe_bond(Building& building, const ParameterValues& values, std::size_t shoe, std::size_t above) {
  const engine::Body& body = building.scene.bodies[shoe];
  const double area = shoe_length * std::min(body.thickness, building.scene.bodies[above].thickness);
  const double y = body.position.y + 0.5 * shoe_height;
  engine::Bond bond;
  bond.name = body.name + " / " + building.scene.bodies[above].name;
  bond.a = block(above), bond.b = block(shoe);
  bond.start = {body.position.x - 0.5 * shoe_length, y};
  bond.end = {body.position.x + 0.5 * shoe_length, y};
  bond.shear_stiffness = 10.0 * values("brace_stiffness") / area;
  bond.normal_stiffness = 0.01 * values("brace_stiffness") / area;
  bond.yield_strength = 1e3 * values("damper_slip_force") / area;  // never reached: it makes the bond ductile
  bond.cohesion = values("damper_slip_force") / area;
  bond.friction_coefficient = 0.0;
  building.scene.bonds.push_back(std::move(bond));
}

void add_friction_damper(Building& building, const ParameterValues& values, const Stock& stock,
                         std::size_t s) {
  const std::string name = building.storeys[s].name;
  const End left = end_below(building, s, -1.0);
  const double middle = 0.5 * (left.place.x + end_below(building, s, 1.0).place.x);
  const End right = middle_below(building, s, middle);
  const double x = 0.5 * (left.place.x + middle);
  const std::size_t above = block_at(building, building.storeys[s], x);
  const double top = bounds_of(building, above).low.y;
  const std::size_t shoe =
      add_rectangle(building, stock, name + ".damper", x, top - shoe_height, shoe_length, shoe_height);
  building.scene.bodies[shoe].collides = false;
  building.storeys[s].storey_blocks.push_back(shoe);
  const auto add_bar_to = [&](const char* side, const End& foot) {
    building.scene.joints.push_back(
        joint_at(building, name + ".brace." + side, engine::JointKind::distance, foot.owner, block(shoe),
                 foot.place, building.scene.bodies[shoe].position, values("brace_stiffness")));
  };
  add_bar_to("left", left);
  add_bar_to("right", right);
  add_shoe_bond(building, values, shoe, above);
}

void add_friction_dampers(Building& building, const ParameterValues& values) {
  const Stock steel{add_material(building, preset("steel")), values("thickness")};
  for (std::size_t s = 0; s < building.storeys.size(); ++s) {
    const double least = 2.0 * shoe_height;
    if (building.storeys[s].height < least)
      throw LayoutError("damper",
                        "storeys of at least " + print_value(least, length) + " for friction dampers",
                        print_value(building.storeys[s].height, length));
    add_friction_damper(building, values, steel, s);
  }
}

// --- tuned mass ----------------------------------------------------------------------------------------

struct Roof {
  std::size_t block;
  double left, right, top;  // m
};

/// The widest level face at the very top.
Roof roof_of(const Building& building) {
  Roof roof{0, 0.0, 0.0, bounds_of(building, building.storeys.back().level_blocks).high.y};
  for (const std::size_t i : building.storeys.back().level_blocks) {
    const engine::Body& body = building.scene.bodies[i];
    const auto* polygon = std::get_if<engine::ConvexPolygon>(&body.shape);
    if (!polygon) continue;
    for (std::size_t k = 0; k < polygon->size(); ++k) {
      const Vec2 a = body.position + engine::rotated(polygon->vertex(k), body.angle);
      const Vec2 b = body.position + engine::rotated(polygon->vertex(k + 1), body.angle);
      if (std::max(roof.top - a.y, roof.top - b.y) > 1e-6 || a.x - b.x <= roof.right - roof.left) continue;
      roof = {i, b.x, a.x, roof.top};
    }
  }
  if (roof.right > roof.left) return roof;
  throw LayoutError("damper", "a roof with a level face at its top for a tuned mass", "none");
}

void add_tuned_mass(Building& building, const ParameterValues& values) {
  const Roof roof = roof_of(building);
  double mass = 0.0;
  for (std::size_t i = 0; i < building.scene.bodies.size(); ++i) mass += mass_of(building, i);
  mass *= values("tuned_mass_ratio");
  engine::Material slick = preset("steel");
  slick.name = "steel on rollers";
  slick.friction_coefficient = 0.0;
  const double face = roof.right - roof.left, width = 0.4 * face, middle = 0.5 * (roof.left + roof.right);
  const Stock stock{add_material(building, slick), values("thickness")};
  const std::size_t body = add_rectangle(building, stock, "tuned.mass", middle, roof.top, width, 0.4 * width);
  building.scene.bodies[body].mass = mass;
  building.storeys.back().storey_blocks.push_back(body);
  const double omega = 2.0 * std::numbers::pi / values("tuned_period");
  const double y = building.scene.bodies[body].position.y;
  for (const auto& [side, anchor, place] : {std::tuple{"left", roof.left, middle - 0.5 * width},
                                            std::tuple{"right", roof.right, middle + 0.5 * width}}) {
    engine::Joint spring =
        joint_at(building, fmt::format("tuned.spring.{}", side), engine::JointKind::spring, block(roof.block),
                 block(body), {anchor, y}, {place, y}, 0.5 * mass * omega * omega);
    spring.damping = values("tuned_damping") * mass * omega;
    building.scene.joints.push_back(std::move(spring));
  }
}

}  // namespace

std::vector<Parameter> damper_parameters() {
  return {
      choice("damper", {"none", "viscous", "friction", "tuned-mass"}, "what takes energy out of its sway"),
      {"damper_coefficient", damping, 1e5, 0.0, 1e12, "of each viscous damper, along its axis"},
      {"damper_slip_force", force, 50e3, 1.0, 1e12, "of each friction damper"},
      {"brace_stiffness", stiffness, 1e8, 1.0, 1e13, "of each bar that holds a friction damper"},
      {"tuned_mass_ratio", ratio, 0.05, 1e-6, 1.0, "the tuned mass over that of the building"},
      {"tuned_period", time, 0.5, 1e-3, 100, "of the tuned mass on its spring"},
      {"tuned_damping", ratio, 0.134, 0.0, 2.0, "damping ratio of the tuned mass on its spring"},
  };
}

Building damped(Building building, const ParameterValues& values) {
  if (values.is("damper", "viscous")) add_dashpots(building, values);
  if (values.is("damper", "friction")) add_friction_dampers(building, values);
  if (values.is("damper", "tuned-mass")) add_tuned_mass(building, values);
  return building;
}

}  // namespace dougong::structures
