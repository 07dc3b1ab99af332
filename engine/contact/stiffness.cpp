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

double normal_stiffness(const Model& model, const Manifold& manifold, Index a, Index b) {
  if (model.contact.point_stiffness) return *model.contact.point_stiffness;
  const double thickness = std::min(model.thickness[a], model.thickness[b]);
  if (manifold.length == 0.0)
    return std::numbers::pi / 4.0 * thickness / (plane_flexibility(model, a) + plane_flexibility(model, b));
  const double per_area =
      1.0 / (flexibility(model, a, manifold.depth_a) + flexibility(model, b, manifold.depth_b));
  return per_area * thickness * 0.5 * std::max(manifold.length, nominal_length(model, a, b));
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

}  // namespace

double nominal_length(const Model& model, Index a, Index b) {
  return 0.5 * std::min(model.minimum_width[a], model.minimum_width[b]);
}

PointStiffness point_stiffness(const Model& model, std::span<const Frame> frames, const Manifold& manifold,
                               const Feature& feature, Index a, Index b) {
  const Placement p = placement_of(frames, feature);
  const Index corner = feature.corner_body, edge = feature.edge_body;
  const PairRule& rule = model.rule(a, b);
  PointStiffness s;
  s.normal = normal_stiffness(model, manifold, a, b);
  s.tangential = s.normal * tangential_ratio(model, a, b);
  const double mn = felt_mass(model, corner, edge, p.arm_corner, p.arm_edge, p.normal);
  const double mt = felt_mass(model, corner, edge, p.arm_corner, p.arm_edge, turned(p.normal));
  s.normal_damping = 2.0 * rule.damping_ratio * std::sqrt(s.normal * mn);
  s.tangential_damping = 2.0 * rule.damping_ratio * std::sqrt(s.tangential * mt);
  s.friction = rule.friction_coefficient;
  return s;
}

}  // namespace dougong::engine
