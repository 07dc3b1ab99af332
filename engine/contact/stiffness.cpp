#include "engine/contact/stiffness.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dougong::engine {
namespace {

double flexibility(const Model& model, Index body, double depth) {
  return model.is_terrain(body) ? 0.0 : depth / model.materials[body].young_modulus;
}

double plane_flexibility(const Model& model, Index body) {
  if (model.is_terrain(body)) return 0.0;
  const Material& m = model.materials[body];
  return (1.0 - m.poisson_ratio * m.poisson_ratio) / m.young_modulus;
}

double normal_stiffness(const Model& model, const Manifold& manifold, double length, Index a, Index b) {
  if (model.contact.point_stiffness) return *model.contact.point_stiffness;
  const double thickness = std::min(model.thickness[a], model.thickness[b]);
  if (manifold.length == 0.0)
    return std::numbers::pi / 4.0 * thickness / (plane_flexibility(model, a) + plane_flexibility(model, b));
  const double per_area =
      1.0 / (flexibility(model, a, manifold.depth_a) + flexibility(model, b, manifold.depth_b));
  return per_area * thickness * 0.5 * length;
}

double tangential_ratio(const Model& model, Index a, Index b) {
  if (model.contact.tangential_ratio) return *model.contact.tangential_ratio;
  const Index body = model.is_terrain(a) ? b : a;
  return 0.5 / (1.0 + model.materials[body].poisson_ratio);
}

double felt_mass(const Model& model, Index a, Index b, Vec2 arm_a, Vec2 arm_b, Vec2 direction) {
  const double ra = cross(arm_a, direction), rb = cross(arm_b, direction);
  return 1.0 / (1.0 / model.mass[a] + 1.0 / model.mass[b] + ra * ra / model.inertia[a] +
                rb * rb / model.inertia[b]);
}

struct Placement {
  Vec2 normal, arm_corner, arm_edge;
};

Placement placement_of(std::span<const Frame> frames, const Feature& f) {
  const Frame &corner = frames[f.corner_body], &edge = frames[f.edge_body];
  Vec2 point = corner.to_world(f.corner);
  Vec2 normal = edge.turned_to_world(f.edge_normal);
  if (f.kind == FeatureKind::round) {
    const Vec2 d = point - edge.to_world(f.edge_point);
    const double distance = norm(d);
    normal = distance > 0.0 ? (1.0 / distance) * d : Vec2{0.0, 1.0};
  }
  point -= (f.radius - f.other_radius) * normal;
  return {normal, point - corner.position(), point - edge.position()};
}

// Where two corners meet, less than half a width long, the material beside the contact bears too. At a seam
// the next piece of the face bears instead.
double nominal_length(const Model& model, const Manifold& manifold, Index a, Index b) {
  return manifold.at_seam ? 0.0 : 0.5 * std::min(model.minimum_width[a], model.minimum_width[b]);
}

// The law of a point stands for a length of contact and grows with it until the next look. The dashpot grows
// as much, not as the root of the stiffness: from next to nothing, where two corners just meet, it would come
// to many times its due. So the law stands at least for the way that a pair goes between two looks there,
// over the smaller width (contact_set.cpp).
constexpr double least_reference = 4e-4;

// Of the corner along the edge, from the edge's point (m).
double position_along(const Feature& f, Vec2 in_edge_body) {
  return dot(turned(f.edge_normal), in_edge_body - f.edge_point);
}

}  // namespace

BearingLength bearing_of(const Model& model, std::span<const Frame> frames, const Manifold& manifold,
                         const Feature& f) {
  const double nominal = nominal_length(model, manifold, f.corner_body, f.edge_body);
  const double least =
      least_reference * std::min(model.minimum_width[f.corner_body], model.minimum_width[f.edge_body]);
  BearingLength b{f.facing, f.edge_length, nominal, 1.0};
  const double length = contact_length(
      b, position_along(f, frames[f.edge_body].to_local(frames[f.corner_body].to_world(f.corner))));
  if (model.contact.point_stiffness || length <= 0.0) b.facing = 0.0;
  b.per_reference =
      1.0 / bearing_length(b.facing != 0.0 ? std::max(length, least) : manifold.length, nominal);
  return b;
}

PointStiffness point_stiffness(const Model& model, std::span<const Frame> frames, const Manifold& manifold,
                               const Feature& feature, double length, BodyPair bodies,
                               std::optional<double> most_damping) {
  const auto [a, b] = bodies;
  const Placement p = placement_of(frames, feature);
  const Index corner = feature.corner_body, edge = feature.edge_body;
  const PairRule& rule = model.rule(a, b);
  PointStiffness s;
  s.normal = normal_stiffness(model, manifold, length, a, b);
  s.tangential = s.normal * tangential_ratio(model, a, b);
  const double mn = felt_mass(model, corner, edge, p.arm_corner, p.arm_edge, p.normal);
  const double mt = felt_mass(model, corner, edge, p.arm_corner, p.arm_edge, turned(p.normal));
  const double ratio = std::min(rule.damping_ratio, most_damping.value_or(rule.damping_ratio));
  s.normal_damping = 2.0 * ratio * std::sqrt(s.normal * mn);
  s.tangential_damping = 2.0 * ratio * std::sqrt(s.tangential * mt);
  s.friction = rule.friction_coefficient;
  const double at_rest = std::min(ratio, model.contact.resting_damping_ratio);
  s.resting = ratio > 0.0 ? at_rest / ratio : 1.0;
  return s;
}

}  // namespace dougong::engine
