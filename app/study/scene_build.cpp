#include "app/study/scene_build.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/study/scene_ignored.h"
#include "app/study/scene_keys.h"
#include "engine/material_presets.h"
#include "engine/shape_distance.h"
#include "structures/nearest_name.h"

namespace dougong::app {
namespace {

using engine::Owner;
using engine::Vec2;

/// A shape in its centroid frame, and where that frame is.
struct PlacedShape {
  engine::Shape shape;
  Vec2 position;
  double angle = 0.0;
};

/// Thrown by what makes shapes: the key that is wrong, and why.
struct ShapeTrouble {
  std::string key;
  std::string message;
};

std::vector<std::string> given_sizes(const ShapeChoice& choice) {
  std::vector<std::string> given;
  if (choice.radius) given.emplace_back("radius");
  if (choice.width) given.emplace_back("width");
  if (choice.height) given.emplace_back("height");
  if (choice.depth) given.emplace_back("depth");
  if (!choice.corners.empty()) given.emplace_back("corners");
  if (!choice.parts.empty()) given.emplace_back("parts");
  return given;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

/// Exactly the sizes that belong to the shape: a size that would be ignored is a misunderstanding.
void check_sizes(const ShapeChoice& choice) {
  const ShapeWord* word = find_shape_word(choice.kind);
  if (!word) throw ShapeTrouble{"shape", "expected a shape"};
  const std::vector<std::string> given = given_sizes(choice);
  for (const std::string& needed : word->needs)
    if (!contains(given, needed))
      throw ShapeTrouble{"shape", fmt::format("a {} needs {}", word->word, fmt::join(word->needs, " and "))};
  for (const std::string& size : given)
    if (!contains(word->needs, size) && !contains(word->allows, size))
      throw ShapeTrouble{size, fmt::format("{} does not belong to a {}", size, word->word)};
}

engine::PlacedPolygon polygon_of(const ShapeChoice& choice) {
  if (choice.kind == "triangle" && choice.corners.size() != 3)
    throw ShapeTrouble{"corners",
                       fmt::format("a triangle has three corners, found {}", choice.corners.size())};
  return engine::make_polygon(choice.corners);
}

PlacedShape in_frame(engine::Shape shape, Vec2 centroid) {
  return {std::move(shape), centroid, 0.0};
}

PlacedShape make_own_shape(const ShapeChoice& choice);

engine::Part make_part(const PartChoice& choice) {
  const ShapeChoice& shape = choice.shape;
  const PlacedShape own = make_own_shape(shape);
  engine::Part part;
  if (const auto* circle = std::get_if<engine::Circle>(&own.shape)) part.shape = *circle;
  if (const auto* polygon = std::get_if<engine::ConvexPolygon>(&own.shape)) part.shape = *polygon;
  part.position = shape.position + engine::rotated(own.position, shape.angle);
  part.angle = shape.angle;
  return part;
}

PlacedShape make_compound_shape(const ShapeChoice& choice) {
  std::vector<engine::Part> parts;
  for (const PartChoice& part : choice.parts) parts.push_back(make_part(part));
  engine::PlacedCompound placed = engine::make_compound(std::move(parts));
  return in_frame(std::move(placed.compound), placed.centroid);
}

PlacedShape make_ground_shape(const ShapeChoice& choice) {
  constexpr double usual_depth = 1.0;  // m
  engine::PlacedCompound placed =
      engine::make_polyline_ground(choice.corners, choice.depth.value_or(usual_depth));
  return in_frame(std::move(placed.compound), placed.centroid);
}

/// In the frame of the choice: its position and angle are left out.
PlacedShape make_own_shape(const ShapeChoice& choice) {
  check_sizes(choice);
  if (choice.kind == "circle") return in_frame(engine::make_circle(*choice.radius), {});
  if (choice.kind == "rectangle") return in_frame(engine::make_rectangle(*choice.width, *choice.height), {});
  if (choice.kind == "half-plane") return in_frame(engine::HalfPlane{}, {});
  if (choice.kind == "compound") return make_compound_shape(choice);
  if (choice.kind == "polyline") return make_ground_shape(choice);
  engine::PlacedPolygon placed = polygon_of(choice);
  return in_frame(std::move(placed.polygon), placed.centroid);
}

std::string key_of_sizes(const ShapeChoice& choice) {
  const ShapeWord* word = find_shape_word(choice.kind);
  return word && !word->needs.empty() ? word->needs.front() : "shape";
}

PlacedShape make_shape(const ShapeChoice& choice) {
  try {
    PlacedShape placed = make_own_shape(choice);
    placed.position = choice.position + engine::rotated(placed.position, choice.angle);
    placed.angle = choice.angle;
    return placed;
  } catch (const std::invalid_argument& error) {
    throw ShapeTrouble{key_of_sizes(choice), error.what()};
  }
}

double damping_ratio_of(const std::optional<double>& damping_ratio, const std::optional<double>& restitution,
                        double standard) {
  if (restitution) return engine::damping_ratio_for_restitution(*restitution);
  return damping_ratio.value_or(standard);
}

/// What a material starts from: the preset that is named, that of its own name, or concrete.
const engine::MaterialPreset* preset_of(const MaterialChoice& choice) {
  if (!choice.preset.empty()) return engine::find_material_preset(choice.preset);
  const engine::MaterialPreset* own = engine::find_material_preset(choice.name);
  return own ? own : engine::find_material_preset("concrete");
}

engine::Material material_of(const MaterialChoice& choice) {
  const engine::MaterialPreset* preset = preset_of(choice);
  engine::Material m = preset ? preset->material : engine::Material{};
  m.name = choice.name;
  m.density = choice.density.value_or(m.density);
  m.young_modulus = choice.young_modulus.value_or(m.young_modulus);
  m.poisson_ratio = choice.poisson_ratio.value_or(m.poisson_ratio);
  m.friction_coefficient = choice.friction.value_or(m.friction_coefficient);
  m.damping_ratio = damping_ratio_of(choice.damping_ratio, choice.restitution, m.damping_ratio);
  m.rocking_restitution = choice.rocking_restitution;
  return m;
}

std::vector<std::string> preset_names() {
  std::vector<std::string> names;
  for (const engine::MaterialPreset& preset : engine::material_presets())
    names.push_back(preset.material.name);
  return names;
}

Vec2 into_frame(Vec2 point, Vec2 position, double angle) {
  return engine::rotated(point - position, -angle);
}

class Builder {
 public:
  explicit Builder(const SceneDescription& description) : d_(description) {}

  BuiltScene build() {
    out_.scene.materials.clear();
    out_.scene.gravity = d_.head.gravity.value_or(Vec2{});
    out_.scene.fields = d_.fields;
    out_.scene.contact = d_.contact;
    each("materials", d_.materials, [&](const MaterialChoice& m) { add_material(m); });
    each("body", d_.bodies, [&](const BodyChoice& b) { add_body(b); });
    each("terrain", d_.terrains, [&](const TerrainChoice& t) { add_terrain(t); });
    each("material_pair", d_.material_pairs, [&](const MaterialPairChoice& p) { add_pair(p); });
    each("joint", d_.joints, [&](const JointChoice& j) { add_joint(j); });
    each("bond", d_.bonds, [&](const BondChoice& b) { add_bond(b); });
    check_rest();
    for (SceneProblem& problem : ignored_keys(d_)) out_.problems.push_back(std::move(problem));
    if (out_.scene.materials.empty()) out_.scene.materials.emplace_back();
    return std::move(out_);
  }

 private:
  template <class Choice, class Add>
  void each(const std::string& section, const std::vector<Choice>& choices, Add add) {
    section_ = section;
    for (index_ = 0; index_ < choices.size(); ++index_) add(choices[index_]);
  }

  void fail(const std::string& key, const std::string& message) {
    out_.problems.push_back({section_, index_, key, message});
  }

  // --- materials -----------------------------------------------------------------------------------

  void add_material(const MaterialChoice& choice) {
    if (choice.damping_ratio && choice.restitution)
      fail("restitution", "damping_ratio and restitution exclude each other");
    if (!preset_of(choice)) fail("preset", unknown("preset", choice.preset, preset_names()));
    out_.scene.materials.push_back(material_of(choice));
  }

  /// Of the scene, or a preset that becomes one of the scene.
  std::size_t material_index(const std::string& name, const std::string& key) {
    auto& materials = out_.scene.materials;
    const auto it = std::ranges::find(materials, name, &engine::Material::name);
    if (it != materials.end()) return static_cast<std::size_t>(it - materials.begin());
    if (const engine::MaterialPreset* preset = engine::find_material_preset(name)) {
      materials.push_back(preset->material);
      return materials.size() - 1;
    }
    fail(key, unknown_material(name));
    return 0;
  }

  std::string unknown_material(const std::string& name) const {
    std::vector<std::string> known = preset_names();
    for (const engine::Material& m : out_.scene.materials)
      if (!contains(known, m.name)) known.push_back(m.name);
    return unknown("material", name, known);
  }

  static std::string unknown(const std::string& kind, const std::string& name,
                             const std::vector<std::string>& known) {
    const std::string nearest = structures::nearest_name(name, known);
    if (!nearest.empty())
      return fmt::format("there is no {} \"{}\"; did you mean \"{}\"?", kind, name, nearest);
    constexpr std::size_t listed = 12;
    const std::vector<std::string> some(
        known.begin(), known.begin() + static_cast<std::ptrdiff_t>(std::min(listed, known.size())));
    return fmt::format("there is no {} \"{}\"; there are {}{}", kind, name, fmt::join(some, ", "),
                       known.size() > listed ? " ..." : "");
  }

  void add_pair(const MaterialPairChoice& choice) {
    if (choice.damping_ratio && choice.restitution)
      fail("restitution", "damping_ratio and restitution exclude each other");
    engine::MaterialPair pair{material_index(choice.a, "a"), material_index(choice.b, "b"), choice.friction,
                              choice.damping_ratio, choice.rocking_restitution};
    if (choice.restitution) pair.damping_ratio = engine::damping_ratio_for_restitution(*choice.restitution);
    out_.scene.material_pairs.push_back(pair);
  }

  // --- bodies and terrains -------------------------------------------------------------------------

  PlacedShape shape_or_problem(const ShapeChoice& choice) {
    try {
      return make_shape(choice);
    } catch (const ShapeTrouble& trouble) {
      fail(trouble.key, trouble.message);
      return {engine::Circle{1.0}, {}, 0.0};
    }
  }

  void note_name(const std::string& name, Owner owner) {
    const auto [it, fresh] = owners_.emplace(name, owner);
    if (!fresh)
      fail("name",
           fmt::format("there already is a {} \"{}\"", it->second.terrain ? "terrain" : "body", name));
    names_.push_back(name);
  }

  void add_body(const BodyChoice& choice) {
    note_name(choice.name, {false, index_});
    PlacedShape placed = shape_or_problem(choice.shape);
    engine::Body body;
    body.name = choice.name;
    body.shape = std::move(placed.shape);
    body.position = placed.position;
    body.angle = placed.angle;
    body.velocity = choice.velocity;
    body.spin = choice.spin;
    body.material = material_index(choice.material, "material");
    body.thickness = choice.thickness;
    body.mass = choice.mass;
    body.inertia = choice.inertia;
    body.charge = choice.charge;
    body.linear_drag = choice.linear_drag;
    body.quadratic_drag = choice.quadratic_drag;
    body.applied_force = choice.force;
    body.collides = choice.collides;
    out_.scene.bodies.push_back(std::move(body));
  }

  void add_terrain(const TerrainChoice& choice) {
    note_name(choice.name, {true, index_});
    PlacedShape placed = shape_or_problem(choice.shape);
    engine::Terrain terrain;
    terrain.name = choice.name;
    terrain.shape = std::move(placed.shape);
    terrain.position = placed.position;
    terrain.angle = placed.angle;
    terrain.material = material_index(choice.material, "material");
    out_.scene.terrains.push_back(std::move(terrain));
    if (choice.motion) check_motion(*choice.motion);
  }

  void check_motion(const MotionChoice& m) {
    const int kinds =
        (m.source.empty() ? 0 : 1) + (m.table.empty() ? 0 : 1) + (m.harmonic ? 1 : 0) + (m.velocity ? 1 : 0);
    if (kinds != 1)
      fail("motion", fmt::format("expected exactly one of record, table, harmonic and velocity, found {}",
                                 kinds == 0 ? "none" : std::to_string(kinds)));
    if (m.record.pga && m.record.scale) fail("motion", "pga and scale exclude each other");
    if (m.harmonic && !(m.harmonic->frequency > 0.0)) fail("motion", "a harmonic motion needs a frequency");
  }

  // --- what connects -------------------------------------------------------------------------------

  Owner owner_named(const std::string& name, const std::string& key) {
    const auto it = owners_.find(name);
    if (it != owners_.end()) return it->second;
    fail(key,
         name.empty() ? "expected the name of a body or terrain" : unknown("body or terrain", name, names_));
    return {};
  }

  template <class Choice>
  std::pair<Owner, Owner> both_owners(const Choice& choice) {
    const Owner a = owner_named(choice.a, "a"), b = owner_named(choice.b, "b");
    const bool known = owners_.contains(choice.a) && owners_.contains(choice.b);
    if (known && choice.a == choice.b) fail("b", "a and b are the same");
    if (known && a.terrain && b.terrain) fail("b", "a and b are both terrain");
    return {a, b};
  }

  Vec2 anchor(const std::optional<Vec2>& own, const std::optional<Vec2>& at, Owner owner) const {
    if (own) return *own;
    const auto& s = out_.scene;
    const std::size_t count = owner.terrain ? s.terrains.size() : s.bodies.size();
    if (!at || owner.index >= count) return {};
    if (owner.terrain)
      return into_frame(*at, s.terrains[owner.index].position, s.terrains[owner.index].angle);
    return into_frame(*at, s.bodies[owner.index].position, s.bodies[owner.index].angle);
  }

  static engine::JointKind joint_kind(const std::string& word) {
    if (word == "weld") return engine::JointKind::weld;
    if (word == "distance") return engine::JointKind::distance;
    if (word == "spring") return engine::JointKind::spring;
    return engine::JointKind::pin;
  }

  void check_joint(const JointChoice& choice) {
    if (choice.kind.empty()) fail("kind", "expected one of pin, weld, distance, spring");
    if (choice.at && (choice.anchor_a || choice.anchor_b))
      fail("at", "at and anchor_a, anchor_b exclude each other");
    if (choice.at && (choice.kind == "distance" || choice.kind == "spring"))
      fail("at", fmt::format("a {} has two different anchors: give anchor_a and anchor_b", choice.kind));
    if (choice.damping && choice.damping_ratio)
      fail("damping", "damping and damping_ratio exclude each other");
    if (!choice.at && !(choice.anchor_a && choice.anchor_b))
      fail("at", "expected at, or anchor_a and anchor_b");
    if (choice.kind == "spring" && !choice.stiffness) fail("stiffness", "a spring needs its stiffness");
  }

  /// N/m, of a block between its two ends: E times thickness. Terrain is as stiff as the body needs.
  double own_stiffness(Owner owner, double thickness) const {
    const auto& s = out_.scene;
    const std::size_t material =
        owner.terrain ? s.terrains[owner.index].material : s.bodies[owner.index].material;
    return s.materials[material].young_modulus * thickness;
  }

  /// The two in series, as where they touch.
  double usual_stiffness(Owner a, Owner b) const {
    const auto& bodies = out_.scene.bodies;
    const double t = std::min(a.terrain ? INFINITY : bodies[a.index].thickness,
                              b.terrain ? INFINITY : bodies[b.index].thickness);
    return 1.0 / (1.0 / own_stiffness(a, t) + 1.0 / own_stiffness(b, t));
  }

  /// N m/rad, of a face as wide as the slimmer of the two: k w2/12.
  double usual_rotational_stiffness(Owner a, Owner b, double stiffness) const {
    const auto width = [&](Owner o) {
      return o.terrain ? INFINITY : engine::minimum_width(out_.scene.bodies[o.index].shape);
    };
    const double w = std::min(width(a), width(b));
    return stiffness * w * w / 12.0;
  }

  void stiffen(const JointChoice& choice, engine::Joint& joint) const {
    if (!owners_.contains(choice.a) || !owners_.contains(choice.b) || (joint.a.terrain && joint.b.terrain))
      return;
    joint.stiffness = choice.stiffness.value_or(usual_stiffness(joint.a, joint.b));
    if (joint.kind == engine::JointKind::weld)
      joint.rotational_stiffness =
          choice.rotational_stiffness.value_or(usual_rotational_stiffness(joint.a, joint.b, joint.stiffness));
  }

  Vec2 in_scene(Owner owner, Vec2 anchor) const {
    const auto& s = out_.scene;
    const auto placed = [&](const auto& thing) {
      return thing.position + engine::rotated(anchor, thing.angle);
    };
    return owner.terrain ? placed(s.terrains[owner.index]) : placed(s.bodies[owner.index]);
  }

  /// A pin whose anchors start apart would snap together.
  void check_anchors(const JointChoice& choice, const engine::Joint& joint) {
    constexpr double slack = 1e-6;  // m
    const bool axial = joint.kind == engine::JointKind::distance || joint.kind == engine::JointKind::spring;
    if (axial || !owners_.contains(choice.a) || !owners_.contains(choice.b)) return;
    const double apart = engine::norm(in_scene(joint.a, joint.anchor_a) - in_scene(joint.b, joint.anchor_b));
    if (!choice.at && apart > slack)
      fail("anchor_b", fmt::format("the anchors of a {} must be at one place, found them {:.3g} m apart",
                                   choice.kind, apart));
  }

  void add_joint(const JointChoice& choice) {
    check_joint(choice);
    engine::Joint joint;
    joint.name = choice.name;
    joint.kind = joint_kind(choice.kind);
    std::tie(joint.a, joint.b) = both_owners(choice);
    joint.anchor_a = anchor(choice.anchor_a, choice.at, joint.a);
    joint.anchor_b = anchor(choice.anchor_b, choice.at, joint.b);
    check_anchors(choice, joint);
    stiffen(choice, joint);
    joint.damping = choice.damping;
    joint.damping_ratio = choice.damping_ratio.value_or(joint.damping_ratio);
    joint.rest_length = choice.rest_length;
    out_.scene.joints.push_back(joint);
  }

  double distance_from(Owner owner, Vec2 point) const {
    const auto outside = [&](const auto& thing) {
      return engine::distance_outside(thing.shape, into_frame(point, thing.position, thing.angle));
    };
    return owner.terrain ? outside(out_.scene.terrains[owner.index])
                         : outside(out_.scene.bodies[owner.index]);
  }

  /// A joint of mortar may be thick; what lies further away is not bonded by this face.
  void check_face(const BondChoice& choice, const engine::Bond& bond) {
    if (!owners_.contains(choice.a) || !owners_.contains(choice.b)) return;
    constexpr double thickest = 0.25;  // of the slimmer one's width
    double width = INFINITY;
    for (const Owner owner : {bond.a, bond.b})
      if (!owner.terrain)
        width = std::min(width, engine::minimum_width(out_.scene.bodies[owner.index].shape));
    const auto check = [&](const char* key, Vec2 end, const std::string& name, Owner owner) {
      const double apart = distance_from(owner, end);
      if (apart > thickest * width)
        fail(key, fmt::format("expected on the face of {}, found {:.3g} m from it", name, apart));
    };
    check("start", bond.start, choice.a, bond.a), check("start", bond.start, choice.b, bond.b);
    check("end", bond.end, choice.a, bond.a), check("end", bond.end, choice.b, bond.b);
  }

  void add_bond(const BondChoice& choice) {
    engine::Bond bond;
    bond.name = choice.name;
    std::tie(bond.a, bond.b) = both_owners(choice);
    if (choice.start == choice.end) fail("end", "the ends of the bonded face are the same point");
    bond.start = choice.start, bond.end = choice.end;
    check_face(choice, bond);
    bond.normal_stiffness = choice.normal_stiffness;
    bond.shear_stiffness = choice.shear_stiffness;
    bond.tensile_strength = choice.tensile_strength.value_or(bond.tensile_strength);
    bond.cohesion = choice.cohesion.value_or(bond.cohesion);
    bond.friction_coefficient = choice.friction;
    bond.fracture_energy = choice.fracture_energy;
    bond.yield_strength = choice.yield_strength.value_or(bond.yield_strength);
    bond.compressive_strength = choice.compressive_strength.value_or(bond.compressive_strength);
    bond.damping_ratio = choice.damping_ratio;
    out_.scene.bonds.push_back(bond);
  }

  // --- the rest ------------------------------------------------------------------------------------

  void check_rest() {
    index_ = 0;
    section_ = "output";
    for (const std::string& name : d_.output.bodies) {
      const auto it = owners_.find(name);
      if (it == owners_.end() || it->second.terrain) fail("bodies", unknown("body", name, names_));
    }
    section_ = "solve";
    if (d_.solve.step && d_.solve.step_fraction)
      fail("step_fraction", "step and step_fraction exclude each other");
    section_ = "";
    if (d_.bodies.empty()) fail("body", "expected at least one [[body]]");
  }

  const SceneDescription& d_;
  BuiltScene out_;
  std::string section_;
  std::size_t index_ = 0;
  std::map<std::string, Owner> owners_;
  std::vector<std::string> names_;
};

}  // namespace

BuiltScene build_scene(const SceneDescription& description) {
  return Builder(description).build();
}

}  // namespace dougong::app
