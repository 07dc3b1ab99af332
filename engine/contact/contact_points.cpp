#include "engine/contact/contact_points.h"

#include <algorithm>
#include <cmath>

namespace dougong::engine {
namespace {

PointGeometry corner_edge_geometry(const ContactPoints& points, std::size_t i, const Frame& corner,
                                   const Frame& edge) {
  const Vec2 normal = edge.turned_to_world(points.edge_normal[i]);
  const Vec2 arm = corner.turned_to_world(points.corner[i]);
  const Vec2 edge_arm = edge.turned_to_world(points.edge_point[i]);
  const Vec2 between = corner.position() - edge.position();
  const Vec2 d = between + arm - edge_arm;
  const double rho = points.radius[i];
  PointGeometry g;
  g.normal = normal;
  g.overlap = rho - dot(normal, d);
  g.slip = dot(turned(normal), d) - rho * (corner.angle - edge.angle) - points.history[i].anchor;
  g.arm_corner = arm - rho * normal;
  g.arm_edge = between + g.arm_corner;
  return g;
}

PointGeometry round_geometry(const ContactPoints& points, std::size_t i, const Frame& corner, const Frame& edge) {
  const PointHistory& past = points.history[i];
  const Vec2 edge_arm = edge.turned_to_world(points.edge_point[i]);
  const Vec2 between = corner.position() - edge.position();
  const Vec2 d = between + corner.turned_to_world(points.corner[i]) - edge_arm;
  const double distance = norm(d);
  PointGeometry g;
  g.normal = distance > 0.0 ? (1.0 / distance) * d : past.direction;
  g.overlap = points.radius[i] - distance;
  const double other = points.other_radius[i];
  // Rate of slip: D phi' - (D - r_o) theta_corner' - r_o theta_edge', D the distance of the centres.
  g.slip = distance * cross(past.direction, g.normal) - (distance - other) * (corner.angle - past.angle_corner) -
           other * (edge.angle - past.angle_edge) - past.anchor;
  g.arm_edge = edge_arm + other * g.normal;
  g.arm_corner = g.arm_edge - between;
  return g;
}

struct PointRates {
  double overlap = 0.0, slip = 0.0;  // m/s
};

PointRates rates_of(const PointGeometry& g, const Frame& corner, const Frame& edge) {
  const Vec2 u = corner.velocity() - edge.velocity() + corner.spin * turned(g.arm_corner) -
                 edge.spin * turned(g.arm_edge);
  return {-dot(g.normal, u), dot(turned(g.normal), u)};
}

// An open point follows its slip, so that it is relaxed when it touches again.
void commit_history(ContactPoints& points, std::size_t i, const PointGeometry& g, double normal, const Frame& corner,
                    const Frame& edge) {
  const PointStiffness& law = points.stiffness[i];
  PointHistory& past = points.history[i];
  const double kept = returned_slip(g.slip, law.tangential, law.friction * normal);
  if (points.kind[i] == FeatureKind::round) {
    past = {-kept, g.normal, corner.angle, edge.angle};
  } else {
    past.anchor += g.slip - kept;
  }
}

}  // namespace

void ContactPoints::resize(std::size_t n) {
  kind.resize(n);
  corner_body.resize(n), edge_body.resize(n);
  corner.resize(n), edge_point.resize(n), edge_normal.resize(n);
  radius.resize(n), other_radius.resize(n);
  stiffness.resize(n), inverse_width.resize(n), history.resize(n);
}

void ContactPoints::set(std::size_t i, const Feature& f, const PointStiffness& law, double width) {
  kind[i] = f.kind;
  corner_body[i] = f.corner_body, edge_body[i] = f.edge_body;
  corner[i] = f.corner, edge_point[i] = f.edge_point, edge_normal[i] = f.edge_normal;
  radius[i] = f.radius, other_radius[i] = f.other_radius;
  stiffness[i] = law;
  inverse_width[i] = 1.0 / width;
}

PointGeometry geometry_of(const ContactPoints& points, std::size_t i, std::span<const Frame> frames) {
  const Frame &corner = frames[points.corner_body[i]], &edge = frames[points.edge_body[i]];
  return points.kind[i] == FeatureKind::corner_edge ? corner_edge_geometry(points, i, corner, edge)
                                                    : round_geometry(points, i, corner, edge);
}

ContactTotals contact_forces(ContactPoints& points, std::span<const Frame> frames, bool commit,
                             std::span<PointLoad> loads) {
  ContactTotals totals;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PointGeometry g = geometry_of(points, i, frames);
    PointLoad& load = loads[i];
    load = {};
    if (g.overlap <= 0.0) {
      if (commit) commit_history(points, i, g, 0.0, frames[points.corner_body[i]], frames[points.edge_body[i]]);
      continue;
    }
    const Frame &corner = frames[points.corner_body[i]], &edge = frames[points.edge_body[i]];
    const PointStiffness& law = points.stiffness[i];
    const PointRates rate = rates_of(g, corner, edge);
    const double normal = normal_force(law.normal, law.normal_damping, g.overlap, rate.overlap);
    const double limit = law.friction * normal;
    const double wanted = law.tangential * g.slip + law.tangential_damping * rate.slip;
    const double tangential = -friction_force(wanted, limit);
    const Vec2 force = normal * g.normal + tangential * turned(g.normal);
    load = {force.x, force.y, cross(g.arm_corner, force), -cross(g.arm_edge, force)};

    const bool slips = std::abs(wanted) > limit;
    const double viscous = slips ? 0.0 : law.tangential_damping * rate.slip * rate.slip;
    totals.damping_power += (normal - law.normal * g.overlap) * rate.overlap + viscous;
    totals.tangential_power += -tangential * rate.slip - viscous;
    if (!commit) continue;
    commit_history(points, i, g, normal, corner, edge);
    const double ratio = g.overlap * points.inverse_width[i];
    if (ratio > totals.deepest_ratio) totals.deepest_ratio = ratio, totals.deepest_point = i;
  }
  return totals;
}

StoredEnergy stored_energy(const ContactPoints& points, std::span<const Frame> frames) {
  StoredEnergy energy;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PointGeometry g = geometry_of(points, i, frames);
    if (g.overlap <= 0.0) continue;
    const PointStiffness& law = points.stiffness[i];
    const double slip = returned_slip(g.slip, law.tangential, law.friction * law.normal * g.overlap);
    energy.normal += 0.5 * law.normal * g.overlap * g.overlap;
    energy.tangential += 0.5 * law.tangential * slip * slip;
  }
  return energy;
}

}  // namespace dougong::engine
