#include "structures/layouts/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "engine/material_presets.h"
#include "structures/separation.h"

namespace dougong::structures {

using enum Dimension;

namespace {

Parameter material_choice() {
  std::vector<std::string> words{"own"};
  for (const engine::MaterialPreset& known : engine::material_presets()) words.push_back(known.material.name);
  return choice("material", std::move(words),
                "a preset that the next values come from; own: those of this layout");
}

}  // namespace

std::vector<Parameter> material_parameters(const engine::Material& standard, double thickness) {
  return {
      material_choice(),
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
      {"thickness", length, thickness, 1e-3, 1e3, "out-of-plane thickness of the blocks"},
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
  if (!values.is("material", "own")) material = preset(values.word("material"));
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

engine::Material preset(std::string_view name) {
  return engine::find_material_preset(name)->material;
}

std::size_t add_material(Building& building, engine::Material material) {
  building.scene.materials.push_back(std::move(material));
  return building.scene.materials.size() - 1;
}

namespace {

std::size_t add_block(Building& building, const Stock& stock, const std::string& name, engine::Shape shape,
                      engine::Vec2 position) {
  engine::Body block;
  block.name = name;
  block.shape = std::move(shape);
  block.position = position;
  block.material = stock.material;
  block.thickness = stock.thickness;
  building.scene.bodies.push_back(std::move(block));
  return building.scene.bodies.size() - 1;
}

}  // namespace

Parameter bearing_modulus_parameter() {
  return {"bearing_modulus",
          pressure,
          0.37e9,
          1e5,
          1e12,
          "Young's modulus of caps and brackets, which are pressed across the grain"};
}

std::size_t add_bearing_timber(Building& building, const ParameterValues& values) {
  engine::Material timber = building.scene.materials.front();
  timber.name += " across the grain";
  timber.young_modulus = values("bearing_modulus");
  return add_material(building, std::move(timber));
}

std::size_t add_rectangle(Building& building, const Stock& stock, const std::string& name, double centre,
                          double bottom, double width, double height) {
  return add_block(building, stock, name, engine::make_rectangle(width, height),
                   {centre, bottom + 0.5 * height});
}

std::size_t add_outline(Building& building, const Stock& stock, const std::string& name,
                        const std::vector<engine::Vec2>& outline) {
  const engine::PlacedPolygon placed = engine::make_polygon(outline);
  return add_block(building, stock, name, placed.polygon, placed.centroid);
}

std::vector<std::size_t> add_bar(Building& building, const Stock& stock, const std::string& name,
                                 engine::Vec2 from, engine::Vec2 to, double depth, std::size_t blocks) {
  const engine::Vec2 along = to - from;
  const engine::Vec2 side = (0.5 * depth / engine::norm(along)) * engine::turned(along);
  const auto joint = [&](std::size_t k) {
    return from + (static_cast<double>(k) / static_cast<double>(blocks)) * along;
  };
  std::vector<std::size_t> bar;
  for (std::size_t k = 0; k < blocks; ++k)
    bar.push_back(add_outline(building, stock, fmt::format("{}.{}", name, k + 1),
                              {joint(k) - side, joint(k + 1) - side, joint(k + 1) + side, joint(k) + side}));
  return bar;
}

// --- what holds blocks together ----------------------------------------------------------------------

double endless_if_zero(double strength) {
  return strength > 0.0 ? strength : std::numeric_limits<double>::infinity();
}

engine::Owner block(std::size_t index) {
  return {false, index};
}

engine::Owner ground() {
  return {true, 0};
}

namespace {

struct Piece {
  PlacedShape shape;
  engine::Vec2 centre;  // m
  const engine::Material* material;
  const std::string* name;
};

template <class Thing>
Piece piece_of(const Thing& thing, const Building& building) {
  return {place(thing.shape, thing.position, thing.angle), thing.position,
          &building.scene.materials[thing.material], &thing.name};
}

Piece piece(const Building& building, engine::Owner owner) {
  return owner.terrain ? piece_of(building.scene.terrains[owner.index], building)
                       : piece_of(building.scene.bodies[owner.index], building);
}

double shear_modulus(const engine::Material& m) {
  return 0.5 * m.young_modulus / (1.0 + m.poisson_ratio);
}

/// Depth from the centroid to the face; terrain does not deform.
double depth(engine::Owner owner, const Piece& p, const Separation& between) {
  return owner.terrain ? 0.0 : std::abs(engine::dot(between.normal, between.from - p.centre));
}

void give_stiffness(engine::Bond& bond, const Piece& a, const Piece& b, const Separation& between,
                    const Connection& c) {
  const engine::Material &ma = *a.material, &mb = *b.material;
  const engine::Material& softer = ma.young_modulus < mb.young_modulus ? ma : mb;
  const double da = depth(bond.a, a, between), db = depth(bond.b, b, between);
  const double t = 0.5 * c.joint_thickness * static_cast<double>(!bond.a.terrain + !bond.b.terrain);
  const double mortar_shear = 0.5 * c.joint_modulus / (1.0 + softer.poisson_ratio);
  const double normal =
      da / ma.young_modulus + db / mb.young_modulus - t / softer.young_modulus + t / c.joint_modulus;
  const double shear =
      da / shear_modulus(ma) + db / shear_modulus(mb) - t / shear_modulus(softer) + t / mortar_shear;
  bond.normal_stiffness = c.stiffness_factor / normal;
  bond.shear_stiffness = c.stiffness_factor * c.shear_coefficient / shear;
}

bool near(const Bounds& a, const Bounds& b, double reach) {
  return a.low.x <= b.high.x + reach && b.low.x <= a.high.x + reach && a.low.y <= b.high.y + reach &&
         b.low.y <= a.high.y + reach;
}

}  // namespace

bool connect(Building& building, engine::Owner a, engine::Owner b, const Connection& connection, double reach,
             double least) {
  const Piece pa = piece(building, a), pb = piece(building, b);
  const Separation between = separation(pa.shape, pb.shape, 1e-6);
  if (between.gap > reach || !between.facing || engine::norm(between.to - between.from) < least) return false;
  engine::Bond bond = connection.law;
  bond.name = *pa.name + " / " + *pb.name;
  bond.a = a, bond.b = b;
  bond.start = between.from, bond.end = between.to;
  give_stiffness(bond, pa, pb, between, connection);
  building.scene.bonds.push_back(std::move(bond));
  return true;
}

void connect_chain(Building& building, const std::vector<std::size_t>& chain, const Connection& connection) {
  for (std::size_t i = 0; i + 1 < chain.size(); ++i)
    connect(building, block(chain[i]), block(chain[i + 1]), connection);
}

void connect_touching(Building& building, const std::vector<std::size_t>& blocks,
                      const Connection& connection, double reach, double least) {
  std::vector<Bounds> bounds;
  for (const std::size_t i : blocks) bounds.push_back(bounds_of(building, i));
  std::vector<std::size_t> order(blocks.size()), open;
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return bounds[k].low.y; });
  for (const std::size_t k : order) {
    std::erase_if(open, [&](std::size_t j) { return bounds[j].high.y < bounds[k].low.y - reach; });
    if (bounds[k].low.y <= reach) connect(building, ground(), block(blocks[k]), connection, reach, least);
    for (const std::size_t j : open)
      if (near(bounds[j], bounds[k], reach))
        connect(building, block(blocks[j]), block(blocks[k]), connection, reach, least);
    open.push_back(k);
  }
}

Bounds bounds_of(const Building& building, std::size_t index) {
  const engine::Body& body = building.scene.bodies[index];
  const PlacedShape shape = place(body.shape, body.position, body.angle);
  return {shape.low, shape.high};
}

Bounds bounds_of(const Building& building, const std::vector<std::size_t>& blocks) {
  Bounds all;
  for (const std::size_t i : blocks) {
    const Bounds one = bounds_of(building, i);
    all.low = {std::min(all.low.x, one.low.x), std::min(all.low.y, one.low.y)};
    all.high = {std::max(all.high.x, one.high.x), std::max(all.high.y, one.high.y)};
  }
  return all;
}

double mass_of(const Building& building, std::size_t index) {
  const engine::Body& body = building.scene.bodies[index];
  if (body.mass) return *body.mass;
  return engine::mass_properties(body.shape, building.scene.materials[body.material].density, body.thickness)
      .mass;
}

engine::Joint joint_at(const Building& building, const std::string& name, engine::JointKind kind,
                       engine::Owner a, engine::Owner b, engine::Vec2 at_a, engine::Vec2 at_b,
                       double stiffness) {
  const auto local = [&](engine::Owner owner, engine::Vec2 at) {
    const auto in_frame = [&](const auto& thing) {
      return engine::rotated(at - thing.position, -thing.angle);
    };
    return owner.terrain ? in_frame(building.scene.terrains[owner.index])
                         : in_frame(building.scene.bodies[owner.index]);
  };
  engine::Joint joint;
  joint.name = name;
  joint.kind = kind;
  joint.a = a, joint.b = b;
  joint.anchor_a = local(a, at_a), joint.anchor_b = local(b, at_b);
  joint.stiffness = stiffness;
  return joint;
}

void require(bool good, const ParameterValues& values, const std::string& subject,
             const std::string& expected, Dimension dimension) {
  if (!good) throw LayoutError(subject, expected, print_value(values(subject), dimension));
}

void require_on_ground(const ParameterValues& values, double left, double right) {
  const double needed = 2.0 * std::max(std::abs(left), std::abs(right));
  // A millionth of slack: a width typed with all its digits is meant to fit exactly.
  if (values("ground_width") * (1.0 + 1e-6) >= needed) return;
  throw LayoutError("ground_width", "at least the width of what stands on it, " + print_value(needed, length),
                    print_value(values("ground_width"), length));
}

}  // namespace dougong::structures
