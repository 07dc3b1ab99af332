#include "structures/compose.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "structures/layouts/layout.h"
#include "structures/layouts/parts.h"

namespace dougong::structures {
namespace {

using engine::Vec2;

std::string print_length(double value) {
  return print_value(value, Dimension::length);
}

std::vector<std::size_t> all_blocks(const Building& building) {
  std::vector<std::size_t> all(building.scene.bodies.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  return all;
}

void move(Building& building, Vec2 shift) {
  for (engine::Body& body : building.scene.bodies) body.position += shift;
  for (engine::Terrain& terrain : building.scene.terrains) terrain.position += shift;
  for (engine::Bond& bond : building.scene.bonds) bond.start += shift, bond.end += shift;
  for (Storey& storey : building.storeys) storey.base += shift.y;
}

void require_same_contact(const Building& a, const Building& b, const std::string& section) {
  const double first = a.scene.contact.resting_damping_ratio, second = b.scene.contact.resting_damping_ratio;
  if (first != second)
    throw LayoutError(section + ".resting_damping_ratio", "that of both, " + print_number(first),
                      print_number(second));
}

/// Appends materials, blocks and what holds them; `owner_of` says what a terrain of the second has become.
template <class OwnerOf>
void append(engine::Scene& scene, engine::Scene second, OwnerOf owner_of) {
  const std::size_t materials = scene.materials.size(), bodies = scene.bodies.size();
  const auto renamed = [&](engine::Owner owner) {
    return owner.terrain ? owner_of(owner.index) : engine::Owner{false, bodies + owner.index};
  };
  for (engine::Material& material : second.materials) scene.materials.push_back(std::move(material));
  for (engine::MaterialPair& pair : second.material_pairs) {
    pair.a += materials, pair.b += materials;
    scene.material_pairs.push_back(pair);
  }
  for (engine::Body& body : second.bodies) {
    body.material += materials;
    scene.bodies.push_back(std::move(body));
  }
  for (engine::Joint& joint : second.joints) {
    joint.a = renamed(joint.a), joint.b = renamed(joint.b);
    scene.joints.push_back(std::move(joint));
  }
  for (engine::Bond& bond : second.bonds) {
    bond.a = renamed(bond.a), bond.b = renamed(bond.b);
    scene.bonds.push_back(std::move(bond));
  }
}

void add_parameters(Building& building, const Building& second, const std::string& section) {
  building.parameters[section + ".name"] = second.layout;
  for (const auto& [name, value] : second.parameters) building.parameters[section + "." + name] = value;
}

// --- on ------------------------------------------------------------------------------------------------

/// The level's upper face under a place.
struct Face {
  std::size_t block;
  double left, right, y;  // m
};

Face face_at(const Building& building, const Place& place) {
  const Storey& storey = building.storeys[place.level - 1];
  Face face{0, 0.0, 0.0, -std::numeric_limits<double>::infinity()};
  for (const std::size_t i : storey.level_blocks) {
    const engine::Body& body = building.scene.bodies[i];
    const auto* polygon = std::get_if<engine::ConvexPolygon>(&body.shape);
    if (!polygon) continue;
    for (std::size_t k = 0; k < polygon->size(); ++k) {
      const Vec2 right = body.position + engine::rotated(polygon->vertex(k), body.angle);
      const Vec2 left = body.position + engine::rotated(polygon->vertex(k + 1), body.angle);
      const bool upper_face = right.x > left.x && std::abs(right.y - left.y) < 1e-9;
      if (upper_face && left.x <= place.x && place.x <= right.x && left.y > face.y)
        face = {i, left.x, right.x, left.y};
    }
  }
  return face;
}

Bounds feet_of(const Building& building) {
  Bounds feet;
  for (std::size_t i = 0; i < building.scene.bodies.size(); ++i) {
    const Bounds box = bounds_of(building, i);
    if (box.low.y > 1e-6) continue;
    feet.low.x = std::min(feet.low.x, box.low.x);
    feet.high.x = std::max(feet.high.x, box.high.x);
  }
  return feet;
}

void require_standing(const Building& below, const Building& item, const Place& place) {
  if (place.level < 1 || place.level > below.storeys.size())
    throw LayoutError("on.level", fmt::format("a level from 1 to {}", below.storeys.size()),
                      fmt::format("{}", place.level));
  if (item.scene.terrains.size() > 1)
    throw LayoutError("on.name", "a layout without abutments of its own", "\"" + item.layout + "\"");
  if (const auto it = item.parameters.find("isolation"); it != item.parameters.end() && it->second != "none")
    throw LayoutError("on.isolation", "none for what stands on a floor", it->second);
}

Face carrying_face(const Building& below, const Building& item, const Place& place) {
  const Face face = face_at(below, place);
  const Bounds feet = feet_of(item);
  const double left = place.x + feet.low.x, right = place.x + feet.high.x;
  if (face.right > face.left && face.left <= left + 1e-9 && right <= face.right + 1e-9) return face;
  throw LayoutError(
      "on.place",
      fmt::format("a place where one block of level {} has an upper face for feet from {} to {}", place.level,
                  print_length(left), print_length(right)),
      face.right > face.left
          ? fmt::format("one from {} to {}", print_length(face.left), print_length(face.right))
          : print_length(place.x));
}

}  // namespace

Building on(Building below, Building item, const Place& place) {
  require_standing(below, item, place);
  require_same_contact(below, item, "on");
  const Face face = carrying_face(below, item, place);
  move(item, {place.x, face.y});
  // Anchors in the ground's frame become anchors in the frame of the block that carries the item.
  const Vec2 from_block = item.scene.terrains.front().position - below.scene.bodies[face.block].position;
  for (engine::Joint& joint : item.scene.joints) {
    if (joint.a.terrain) joint.anchor_a += from_block;
    if (joint.b.terrain) joint.anchor_b += from_block;
  }
  const std::size_t first = below.scene.bodies.size();
  append(below.scene, item.scene, [&](std::size_t) { return block(face.block); });
  for (std::size_t i = first; i < below.scene.bodies.size(); ++i) {
    below.scene.bodies[i].name = "on." + below.scene.bodies[i].name;
    below.storeys[place.level - 1].storey_blocks.push_back(i);
  }
  add_parameters(below, item, "on");
  return below;
}

// --- beside --------------------------------------------------------------------------------------------

namespace {

/// The first terrain from one x to another; what is held by it stays where it is.
void give_ground(Building& building, double left, double right) {
  engine::Terrain& terrain = building.scene.terrains.front();
  const Vec2 moved = Vec2{0.5 * (left + right), terrain.position.y} - terrain.position;
  terrain.shape = engine::make_rectangle(right - left, ground_depth);
  terrain.position += moved;
  for (engine::Joint& joint : building.scene.joints) {
    if (joint.a.terrain && joint.a.index == 0) joint.anchor_a = joint.anchor_a - moved;
    if (joint.b.terrain && joint.b.index == 0) joint.anchor_b = joint.anchor_b - moved;
  }
}

double half_ground(const Building& building) {
  double half = 0.0;
  for (const Vec2 v : std::get<engine::ConvexPolygon>(building.scene.terrains.front().shape).vertices())
    half = std::max(half, v.x);
  return half;
}

void name_with(Building& building, const std::string& prefix) {
  for (engine::Body& body : building.scene.bodies) body.name = prefix + body.name;
  for (engine::Terrain& terrain : building.scene.terrains) terrain.name = prefix + terrain.name;
  for (engine::Joint& joint : building.scene.joints) joint.name = prefix + joint.name;
  for (engine::Bond& bond : building.scene.bonds) bond.name = prefix + bond.name;
  for (Storey& storey : building.storeys) storey.name = prefix + storey.name;
}

}  // namespace

Building beside(Building left, Building right, double gap) {
  if (!(gap >= 0.0)) throw LayoutError("beside.gap", "at least 0 m", print_length(gap));
  require_same_contact(left, right, "beside");
  const double edge = bounds_of(left, all_blocks(left)).high.x, middle = edge + 0.5 * gap;
  const double shift = edge + gap - bounds_of(right, all_blocks(right)).low.x;
  const double end = std::max(shift + half_ground(right), middle + 0.1);
  move(right, {shift, 0.0});
  give_ground(left, -half_ground(left), middle);
  give_ground(right, middle, end);
  name_with(left, "A.");
  name_with(right, "B.");

  const std::size_t blocks = left.scene.bodies.size(), terrains = left.scene.terrains.size();
  for (engine::Terrain& terrain : right.scene.terrains) {
    terrain.material += left.scene.materials.size();
    left.scene.terrains.push_back(std::move(terrain));
  }
  append(left.scene, right.scene, [&](std::size_t terrain) {
    return engine::Owner{true, terrains + terrain};
  });
  right.storeys.front().stands_on_ground = true;
  for (Storey& storey : right.storeys) {
    for (auto* list : {&storey.level_blocks, &storey.storey_blocks})
      for (std::size_t& i : *list) i += blocks;
    left.storeys.push_back(std::move(storey));
  }
  add_parameters(left, right, "beside");
  return left;
}

}  // namespace dougong::structures
