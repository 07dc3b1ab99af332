#include "structures/layouts/isolation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "structures/layouts/parts.h"
#include "structures/separation.h"

namespace dougong::structures {
namespace {

using enum Dimension;
using engine::Vec2;

constexpr double travel = 2.0;  // m, from the raft's sides to where its springs are held

void lift(Building& building, double height) {
  const Vec2 up{0.0, height};
  for (engine::Body& body : building.scene.bodies) body.position += up;
  for (std::size_t t = 1; t < building.scene.terrains.size(); ++t) building.scene.terrains[t].position += up;
  for (engine::Bond& bond : building.scene.bonds) bond.start += up, bond.end += up;
  for (Storey& storey : building.storeys) storey.base += height;
}

double total_mass(const Building& building) {
  double mass = 0.0;
  for (std::size_t i = 0; i < building.scene.bodies.size(); ++i) mass += mass_of(building, i);
  return mass;
}

/// From left to right of what stands on the ground.
Bounds footprint(const Building& building) {
  Bounds all;
  const auto add = [&](const auto& thing) {
    const PlacedShape shape = place(thing.shape, thing.position, thing.angle);
    if (shape.low.y > 1e-6) return;
    all.low.x = std::min(all.low.x, shape.low.x);
    all.high.x = std::max(all.high.x, shape.high.x);
  };
  std::ranges::for_each(building.scene.bodies, add);
  for (std::size_t t = 1; t < building.scene.terrains.size(); ++t) add(building.scene.terrains[t]);
  return all;
}

/// The raft and the ground get materials of their own, so that what lies between them is theirs alone.
std::size_t add_raft(Building& building, const ParameterValues& values, const Bounds& feet) {
  engine::Material raft = building.scene.materials.front(), surface = raft;
  raft.name = "raft", surface.name = "sliding surface";
  const Stock stock{add_material(building, raft), values("thickness")};
  building.scene.terrains.front().material = add_material(building, surface);
  building.scene.material_pairs.push_back(
      {stock.material, building.scene.terrains.front().material,
       values.is("isolation", "linear") ? 0.0 : values("isolation_friction")});
  const double overhang = values("raft_overhang");
  const double width = feet.high.x - feet.low.x + 2.0 * overhang;
  return add_rectangle(building, stock, "raft", 0.5 * (feet.low.x + feet.high.x), 0.0, width,
                       values("raft_thickness"));
}

/// What was held by the ground is held by the raft.
void move_to_raft(Building& building, std::size_t raft) {
  const Vec2 shift = building.scene.terrains.front().position - building.scene.bodies[raft].position +
                     Vec2{0.0, bounds_of(building, raft).high.y};
  const auto is_ground = [](const engine::Owner& owner) { return owner.terrain && owner.index == 0; };
  for (engine::Joint& joint : building.scene.joints) {
    if (is_ground(joint.a)) joint.a = block(raft), joint.anchor_a += shift;
    if (is_ground(joint.b)) joint.b = block(raft), joint.anchor_b += shift;
  }
  for (engine::Bond& bond : building.scene.bonds) {
    if (is_ground(bond.a)) bond.a = block(raft);
    if (is_ground(bond.b)) bond.b = block(raft);
  }
}

/// Abutments that belonged to the ground are blocks that never part from the raft.
void found_abutments(Building& building, const ParameterValues& values, std::size_t raft, Storey& storey) {
  auto& terrains = building.scene.terrains;
  for (std::size_t t = 1; t < terrains.size(); ++t) {
    engine::Body abutment;
    abutment.name = terrains[t].name;
    abutment.shape = terrains[t].shape;
    abutment.position = terrains[t].position;
    abutment.material = terrains[t].material;
    abutment.thickness = values("thickness");
    building.scene.bodies.push_back(std::move(abutment));
    const std::size_t index = building.scene.bodies.size() - 1;
    connect(building, block(raft), block(index), {});
    storey.storey_blocks.push_back(index);
  }
  terrains.resize(1);
}

void add_springs(Building& building, const ParameterValues& values, std::size_t raft, double mass) {
  const bool linear = values.is("isolation", "linear");
  const double omega = 2.0 * std::numbers::pi / values("isolation_period");
  const double stiffness =
      linear ? mass * omega * omega : mass * engine::standard_gravity / values("pendulum_radius");
  const double damping = linear ? 2.0 * values("isolation_damping") * mass * omega : 0.0;
  const Bounds box = bounds_of(building, raft);
  const double y = building.scene.bodies[raft].position.y;
  const auto add = [&](const char* name, double side, double anchor) {
    engine::Joint spring = joint_at(building, name, engine::JointKind::spring, ground(), block(raft),
                                    {anchor, y}, {side, y}, 0.5 * stiffness);
    spring.damping = 0.5 * damping;
    building.scene.joints.push_back(std::move(spring));
  };
  add("isolator.left", box.low.x, box.low.x - travel);
  add("isolator.right", box.high.x, box.high.x + travel);
}

}  // namespace

std::vector<Parameter> isolation_parameters() {
  return {
      choice("isolation", {"none", "linear", "friction-pendulum", "sliding"},
             "what the whole building stands on"),
      {"isolation_period", time, 2.5, 0.05, 100, "of the building as a rigid body on linear isolators"},
      {"isolation_damping", ratio, 0.15, 0.0, 2.0, "damping ratio of linear isolators at that period"},
      {"pendulum_radius", length, 1.55, 0.01, 1e3, "of the concave surface of friction pendulums"},
      {"isolation_friction", ratio, 0.05, 0.0, 10.0, "of friction pendulums and sliding isolators"},
      {"raft_thickness", length, 0.4, 0.01, 20, "of the raft on isolators, which is as wide as the building"},
      {"raft_overhang", length, 0.3, 0.0, 20, "of the raft beyond what stands on it"},
  };
}

Building isolated(Building building, const ParameterValues& values) {
  if (values.is("isolation", "none")) return building;
  const Bounds feet = footprint(building);
  const double thickness = values("raft_thickness"), overhang = values("raft_overhang");
  require_on_ground(values, feet.low.x - overhang, feet.high.x + overhang);
  lift(building, thickness);
  const std::size_t raft = add_raft(building, values, feet);
  move_to_raft(building, raft);
  Storey storey{"raft", 0.0, thickness, {raft}, {raft}};
  storey.is_base = true;
  found_abutments(building, values, raft, storey);
  if (!values.is("isolation", "sliding")) add_springs(building, values, raft, total_mass(building));
  building.storeys.insert(building.storeys.begin(), std::move(storey));
  return building;
}

}  // namespace dougong::structures
