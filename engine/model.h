// A compiled scene: what is fixed during a run, as arrays. Immutable once made, so that threads and
// variants can share it.
//
// Bodies come first (0 .. body_count - 1), terrains after them: one index names either. Positions are
// kept relative to `origin`, so that a scene far from (0, 0) loses no digits to its coordinates.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/bonds/elements.h"
#include "engine/collision/collider.h"
#include "engine/fields/field_terms.h"
#include "engine/scene.h"

namespace dougong::engine {

/// What two materials do where they touch.
struct PairRule {
  double friction_coefficient = 0.0, damping_ratio = 0.0;
  std::optional<double> rocking_restitution = std::nullopt;
};

struct Model {
  std::size_t body_count = 0;
  std::size_t terrain_count = 0;
  std::size_t size() const { return body_count + terrain_count; }
  bool is_terrain(Index i) const { return i >= body_count; }

  Vec2 origin;   // m
  Vec2 gravity;  // m/s2
  ContactOptions contact;
  FieldTerms fields;

  std::vector<std::string> names;
  std::vector<Shape> shapes;
  std::vector<Material> materials;          // one for each body and terrain
  std::vector<std::size_t> material_index;  // of each, into the scene's materials
  std::vector<PairRule> rules;              // square, by two material indices
  std::vector<double> thickness;            // m; of terrain, infinity
  std::vector<double> mass, inertia;        // kg, kg m2; of terrain, infinity
  std::vector<double> bounding_radius;      // m, about the centroid
  std::vector<double> minimum_width;        // m
  std::vector<char> touchable;              // whether it can touch anything
  std::vector<Collider> colliders;          // of all bodies, then of all terrains

  std::vector<JointElement> joints;
  std::vector<BondPoint> bond_points;  // two a bond
  std::vector<std::string> bond_names;

  std::vector<Vec2> terrain_position;  // m, relative to origin, at zero displacement
  std::vector<double> terrain_angle;   // rad
  std::vector<std::shared_ptr<const PrescribedMotion>> motions;  // null: fixed

  const PairRule& rule(Index a, Index b) const {
    return rules[material_index[a] * material_count + material_index[b]];
  }
  std::size_t material_count = 0;
  /// Whether any rule asks for a rocking restitution.
  bool has_rocking_restitution() const;
  /// Whether any two of its bodies and terrains can touch.
  bool has_contacts() const;
  double total_mass() const;
  /// Smallest knot interval of the motions (s); 0 when all are smooth.
  double knot_interval() const;
};

/// Throws std::invalid_argument, naming the body, for a mass, stiffness or size that is not positive
/// and finite, a charge that is not finite, or a material that does not exist.
Model compile(const Scene& scene);

}  // namespace dougong::engine
