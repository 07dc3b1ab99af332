#include "engine/model.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "engine/bonds/bonds.h"
#include "engine/bonds/joints.h"

namespace dougong::engine {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void require_positive(double value, const std::string& owner, const char* quantity) {
  if (!(value > 0.0) || !std::isfinite(value))
    throw std::invalid_argument(owner + ": " + quantity + " must be positive and finite, found " +
                                std::to_string(value));
}

void require_not_negative(double value, const std::string& owner, const char* quantity) {
  if (!(value >= 0.0) || !std::isfinite(value))
    throw std::invalid_argument(owner + ": " + quantity + " must not be negative, found " +
                                std::to_string(value));
}

const Material& checked_material(const Scene& scene, std::size_t index, const std::string& owner) {
  if (index >= scene.materials.size())
    throw std::invalid_argument(owner + ": there is no material number " + std::to_string(index));
  const Material& m = scene.materials[index];
  require_positive(m.density, owner, "density");
  require_positive(m.young_modulus, owner, "Young's modulus");
  require_not_negative(m.friction_coefficient, owner, "friction coefficient");
  require_not_negative(m.damping_ratio, owner, "damping ratio");
  return m;
}

void require_finite(Vec2 p, double angle, const std::string& owner) {
  if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(angle))
    throw std::invalid_argument(owner + ": position and angle must be finite");
}

void add_common(Model& model, const Scene& scene, const std::string& name, const Shape& shape,
                std::size_t material) {
  model.names.push_back(name);
  model.shapes.push_back(shape);
  model.materials.push_back(checked_material(scene, material, name));
  model.material_index.push_back(material);
  model.bounding_radius.push_back(bounding_radius(shape));
  model.minimum_width.push_back(minimum_width(shape));
  if (!(model.minimum_width.back() > 0.0)) throw std::invalid_argument(name + ": size must be positive");
  const auto owner = static_cast<Index>(model.names.size() - 1);
  for (Collider& collider : colliders_of(shape, owner)) model.colliders.push_back(std::move(collider));
}

void add_body(Model& model, const Scene& scene, const Body& body) {
  require_finite(body.position, body.angle, body.name);
  if (std::holds_alternative<HalfPlane>(body.shape))
    throw std::invalid_argument(body.name + ": a half-plane has no mass; only terrain can be one");
  add_common(model, scene, body.name, body.shape, body.material);
  const Material& material = model.materials.back();
  require_positive(body.thickness, body.name, "thickness");
  MassProperties properties = mass_properties(body.shape, material.density, body.thickness);
  if (body.mass) {
    require_positive(*body.mass, body.name, "mass");
    properties.inertia *= *body.mass / properties.mass;
    properties.mass = *body.mass;
  }
  if (body.inertia) {
    require_positive(*body.inertia, body.name, "moment of inertia");
    properties.inertia = *body.inertia;
  }
  model.thickness.push_back(body.thickness);
  model.touchable.push_back(body.collides);
  model.mass.push_back(properties.mass);
  model.inertia.push_back(properties.inertia);
}

void add_terrain(Model& model, const Scene& scene, const Terrain& terrain) {
  require_finite(terrain.position, terrain.angle, terrain.name);
  add_common(model, scene, terrain.name, terrain.shape, terrain.material);
  model.touchable.push_back(true);
  model.thickness.push_back(infinity);
  model.mass.push_back(infinity);
  model.inertia.push_back(infinity);
  model.terrain_position.push_back(terrain.position - model.origin);
  model.terrain_angle.push_back(terrain.angle);
  model.motions.push_back(terrain.motion);
}

void require_rocking_restitution(const std::optional<double>& ratio, const std::string& owner) {
  if (ratio && !(*ratio > 0.0 && *ratio <= 1.0))
    throw std::invalid_argument(owner + ": rocking restitution must lie in (0, 1], found " +
                                std::to_string(*ratio));
}

// The couple that takes the rest of the spin is given by the dashpots.
void require_dashpot(const PairRule& rule, const std::string& owner) {
  if (rule.rocking_restitution && rule.damping_ratio == 0.0)
    throw std::invalid_argument(owner + ": a rocking restitution needs a damping ratio above 0 (1 or 2)");
}

PairRule rule_of_any_two(const Material& a, const Material& b) {
  PairRule rule{std::min(a.friction_coefficient, b.friction_coefficient),
                0.5 * (a.damping_ratio + b.damping_ratio), a.rocking_restitution};
  if (b.rocking_restitution)
    rule.rocking_restitution = std::min(rule.rocking_restitution.value_or(1.0), *b.rocking_restitution);
  return rule;
}

void set_rule(Model& model, const Scene& scene, const MaterialPair& pair) {
  const std::size_t n = scene.materials.size();
  if (pair.a >= n || pair.b >= n)
    throw std::invalid_argument("pair of materials: there is no material number " +
                                std::to_string(std::max(pair.a, pair.b)));
  const std::string owner = scene.materials[pair.a].name + " on " + scene.materials[pair.b].name;
  for (PairRule* rule : {&model.rules[pair.a * n + pair.b], &model.rules[pair.b * n + pair.a]}) {
    rule->friction_coefficient = pair.friction_coefficient.value_or(rule->friction_coefficient);
    rule->damping_ratio = pair.damping_ratio.value_or(rule->damping_ratio);
    require_not_negative(rule->friction_coefficient, owner, "friction coefficient");
    require_not_negative(rule->damping_ratio, owner, "damping ratio");
    if (pair.rocking_restitution) rule->rocking_restitution = pair.rocking_restitution;
    require_rocking_restitution(rule->rocking_restitution, owner);
  }
}

void add_rules(Model& model, const Scene& scene) {
  model.material_count = scene.materials.size();
  for (const Material& m : scene.materials) require_rocking_restitution(m.rocking_restitution, m.name);
  for (const Material& a : scene.materials)
    for (const Material& b : scene.materials) model.rules.push_back(rule_of_any_two(a, b));
  for (const MaterialPair& pair : scene.material_pairs) set_rule(model, scene, pair);
  for (std::size_t i = 0; i < model.rules.size(); ++i)
    require_dashpot(model.rules[i], scene.materials[i / model.material_count].name + " on " +
                                        scene.materials[i % model.material_count].name);
}

Vec2 mean_position(const std::vector<Body>& bodies) {
  Vec2 sum;
  for (const Body& body : bodies) sum += body.position;
  return bodies.empty() ? Vec2{} : (1.0 / static_cast<double>(bodies.size())) * sum;
}

}  // namespace

bool Model::has_contacts() const {
  const auto count = std::count(touchable.begin(), touchable.end(), true);
  const auto bodies = touchable.begin() + static_cast<std::ptrdiff_t>(body_count);
  return count > 1 && std::count(touchable.begin(), bodies, true) > 0;
}

bool Model::has_rocking_restitution() const {
  return std::any_of(rules.begin(), rules.end(), [](const PairRule& r) { return r.rocking_restitution; });
}

double Model::total_mass() const {
  double sum = 0.0;
  for (std::size_t i = 0; i < body_count; ++i) sum += mass[i];
  return sum;
}

double Model::knot_interval() const {
  double smallest = 0.0;
  for (const auto& motion : motions) {
    const double interval = motion ? motion->knot_interval() : 0.0;
    if (interval > 0.0) smallest = smallest == 0.0 ? interval : std::min(smallest, interval);
  }
  return smallest;
}

Model compile(const Scene& scene) {
  Model model;
  model.body_count = scene.bodies.size();
  model.terrain_count = scene.terrains.size();
  model.origin = mean_position(scene.bodies);
  model.gravity = scene.gravity;
  model.contact = scene.contact;
  add_rules(model, scene);
  for (const Body& body : scene.bodies) add_body(model, scene, body);
  model.fields = compile_fields(scene, model.mass);
  for (const Terrain& terrain : scene.terrains) add_terrain(model, scene, terrain);
  model.joints = compile_joints(scene, model);
  model.bond_points = compile_bonds(scene, model);
  for (const Bond& bond : scene.bonds) model.bond_names.push_back(bond.name);
  return model;
}

}  // namespace dougong::engine
