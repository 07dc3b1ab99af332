#include "app/study/building_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "app/study/scene_build.h"
#include "app/study/scene_file.h"
#include "structures/nearest_name.h"

namespace dougong::app {
namespace {

using engine::Vec2;

// --- written out -----------------------------------------------------------------------------------------

/// Two materials of one name get numbers.
std::vector<std::string> material_names(const engine::Scene& scene) {
  std::vector<std::string> names;
  for (const engine::Material& material : scene.materials) {
    std::string name = material.name;
    for (int n = 2; std::ranges::find(names, name) != names.end(); ++n)
      name = fmt::format("{} {}", material.name, n);
    names.push_back(std::move(name));
  }
  return names;
}

MaterialChoice choice_of(const engine::Material& m, const std::string& name) {
  MaterialChoice choice;
  choice.name = name;
  choice.density = m.density;
  choice.young_modulus = m.young_modulus;
  choice.poisson_ratio = m.poisson_ratio;
  choice.friction = m.friction_coefficient;
  choice.damping_ratio = m.damping_ratio;
  choice.rocking_restitution = m.rocking_restitution;
  return choice;
}

MaterialPairChoice choice_of(const engine::MaterialPair& pair, const std::vector<std::string>& names) {
  MaterialPairChoice choice;
  choice.a = names[pair.a], choice.b = names[pair.b];
  choice.friction = pair.friction_coefficient;
  choice.damping_ratio = pair.damping_ratio;
  choice.rocking_restitution = pair.rocking_restitution;
  return choice;
}

template <class Thing>
ShapeChoice shape_of(const Thing& thing) {
  ShapeChoice choice;
  choice.position = thing.position;
  choice.angle = thing.angle;
  if (const auto* circle = std::get_if<engine::Circle>(&thing.shape)) {
    choice.kind = "circle";
    choice.radius = circle->radius;
  } else if (std::holds_alternative<engine::HalfPlane>(thing.shape)) {
    choice.kind = "half-plane";
  } else {
    choice.kind = "polygon";
    choice.corners = std::get<engine::ConvexPolygon>(thing.shape).vertices();
  }
  return choice;
}

BodyChoice choice_of(const engine::Body& body, const std::vector<std::string>& names) {
  BodyChoice choice;
  choice.name = body.name;
  choice.shape = shape_of(body);
  choice.material = names[body.material];
  choice.mass = body.mass;
  choice.inertia = body.inertia;
  choice.thickness = body.thickness;
  choice.collides = body.collides;
  return choice;
}

const std::string& name_of(const engine::Scene& scene, engine::Owner owner) {
  return owner.terrain ? scene.terrains[owner.index].name : scene.bodies[owner.index].name;
}

JointChoice choice_of(const engine::Joint& joint, const engine::Scene& scene) {
  JointChoice choice;
  choice.name = joint.name;
  const char* kinds[] = {"pin", "weld", "distance", "spring"};
  choice.kind = kinds[static_cast<int>(joint.kind)];
  choice.a = name_of(scene, joint.a), choice.b = name_of(scene, joint.b);
  choice.anchor_a = joint.anchor_a, choice.anchor_b = joint.anchor_b;
  choice.stiffness = joint.stiffness;
  if (joint.kind == engine::JointKind::weld) choice.rotational_stiffness = joint.rotational_stiffness;
  choice.damping = joint.damping;
  if (!joint.damping && joint.damping_ratio > 0.0) choice.damping_ratio = joint.damping_ratio;
  choice.rest_length = joint.rest_length;
  return choice;
}

std::optional<double> unless_endless(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

BondChoice choice_of(const engine::Bond& bond, const engine::Scene& scene) {
  BondChoice choice;
  choice.name = bond.name;
  choice.a = name_of(scene, bond.a), choice.b = name_of(scene, bond.b);
  choice.start = bond.start, choice.end = bond.end;
  choice.normal_stiffness = bond.normal_stiffness, choice.shear_stiffness = bond.shear_stiffness;
  choice.tensile_strength = unless_endless(bond.tensile_strength);
  choice.cohesion = unless_endless(bond.cohesion);
  choice.yield_strength = unless_endless(bond.yield_strength);
  choice.compressive_strength = unless_endless(bond.compressive_strength);
  if (choice.cohesion) choice.friction = bond.friction_coefficient;
  choice.fracture_energy = bond.fracture_energy;
  choice.damping_ratio = bond.damping_ratio;
  return choice;
}

StoreyChoice choice_of(const structures::Storey& storey, const engine::Scene& scene) {
  StoreyChoice choice{storey.name, storey.base, storey.height, {}, {}, storey.stands_on_ground};
  for (const std::size_t i : storey.level_blocks) choice.level.push_back(scene.bodies[i].name);
  for (const std::size_t i : storey.storey_blocks)
    if (std::ranges::find(storey.level_blocks, i) == storey.level_blocks.end())
      choice.blocks.push_back(scene.bodies[i].name);
  return choice;
}

// --- read back -------------------------------------------------------------------------------------------

class Finder {
 public:
  explicit Finder(const SceneDescription& d) {
    for (const BodyChoice& body : d.bodies) names_.push_back(body.name);
  }

  void add(const std::vector<std::string>& names, const std::string& storey, const char* key,
           std::vector<std::size_t>& blocks) {
    for (const std::string& name : names) {
      const auto it = std::ranges::find(names_, name);
      if (it == names_.end()) {
        const std::string nearest = structures::nearest_name(name, names_);
        fail(fmt::format("storey.{} of {}: there is no body \"{}\"{}", key, storey, name,
                         nearest.empty() ? "" : fmt::format("; did you mean \"{}\"?", nearest)));
        continue;
      }
      const auto i = static_cast<std::size_t>(it - names_.begin());
      if (!taken_.insert(i).second)
        fail(fmt::format("storey.{} of {}: body {} is in a storey already", key, storey, name));
      blocks.push_back(i);
    }
  }

  void fail(std::string message) { messages_.push_back(std::move(message)); }
  const std::vector<std::string>& messages() const { return messages_; }

 private:
  std::vector<std::string> names_;
  std::set<std::size_t> taken_;
  std::vector<std::string> messages_;
};

structures::Storey storey_of(const StoreyChoice& choice, Finder& finder) {
  structures::Storey storey{choice.name, choice.base, choice.height, {}, {}, choice.on_ground};
  finder.add(choice.level, choice.name, "level", storey.level_blocks);
  storey.storey_blocks = storey.level_blocks;
  finder.add(choice.blocks, choice.name, "blocks", storey.storey_blocks);
  return storey;
}

void refuse_motion(const SceneDescription& d, Finder& finder) {
  if (d.storeys.empty()) finder.fail("expected [[storey]] with the names of their blocks, found none");
  if (d.terrains.empty()) finder.fail("expected a [[terrain]] to stand on, found none");
  for (const TerrainChoice& terrain : d.terrains)
    if (terrain.motion)
      finder.fail(fmt::format("terrain {} has a motion: the scenario's record moves it", terrain.name));
  const auto refuse_parts = [&](const char* kind, const std::string& name, const ShapeChoice& shape) {
    if (shape.kind == "compound" || shape.kind == "polyline")
      finder.fail(fmt::format("{} {}: expected a circle, a convex polygon or a half-plane, found a {}", kind,
                              name, shape.kind));
  };
  for (const TerrainChoice& terrain : d.terrains) refuse_parts("terrain", terrain.name, terrain.shape);
  for (const BodyChoice& body : d.bodies) refuse_parts("body", body.name, body.shape);
  for (const BodyChoice& body : d.bodies)
    if (body.velocity.x != 0.0 || body.velocity.y != 0.0 || body.spin != 0.0)
      finder.fail(fmt::format("body {} moves at the start: expected a building at rest", body.name));
}

}  // namespace

SceneDescription description_of(const structures::Building& building) {
  const engine::Scene& scene = building.scene;
  const std::vector<std::string> names = material_names(scene);
  SceneDescription d;
  d.head.title = building.layout;
  for (std::size_t i = 0; i < names.size(); ++i)
    d.materials.push_back(choice_of(scene.materials[i], names[i]));
  for (const engine::MaterialPair& pair : scene.material_pairs)
    d.material_pairs.push_back(choice_of(pair, names));
  for (const engine::Body& body : scene.bodies) d.bodies.push_back(choice_of(body, names));
  for (const engine::Terrain& terrain : scene.terrains)
    d.terrains.push_back({terrain.name, shape_of(terrain), names[terrain.material], std::nullopt});
  for (const engine::Joint& joint : scene.joints) d.joints.push_back(choice_of(joint, scene));
  for (const engine::Bond& bond : scene.bonds) d.bonds.push_back(choice_of(bond, scene));
  for (const structures::Storey& storey : building.storeys) d.storeys.push_back(choice_of(storey, scene));
  d.contact = scene.contact;
  d.solve.settle = true;
  return d;
}

structures::Building building_of(const SceneDescription& description, const std::string& source) {
  Finder finder(description);
  refuse_motion(description, finder);
  structures::Building building;
  building.layout = description.head.title.empty() ? source : description.head.title;
  building.scene = build_scene(description).scene;
  for (const StoreyChoice& choice : description.storeys)
    building.storeys.push_back(storey_of(choice, finder));
  if (finder.messages().empty()) return building;
  std::vector<LocatedMessage> located;
  for (const std::string& message : finder.messages()) located.push_back({source, message});
  throw ScenarioError(std::move(located));
}

structures::Building load_building(const std::filesystem::path& path) {
  return building_of(load_scene(path), path.string());
}

}  // namespace dougong::app
