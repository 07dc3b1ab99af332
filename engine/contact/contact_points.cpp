#include "engine/contact/contact_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dougong::engine {
namespace {

// The part of a corner-edge geometry that tells whether the point touches at all.
struct Approach {
  Vec2 normal, arm;  // arm: from the corner body's centroid to the corner
  Vec2 reach;        // from the edge body's centroid to the corner
  double overlap;
};

inline Approach approach_of(const ContactPoints& points, std::size_t i, const Frame& corner,
                            const Frame& edge) {
  Approach a;
  a.normal = edge.turned_to_world(points.edge_normal[i]);
  a.arm = corner.turned_to_world(points.corner[i]);
  a.reach = corner.position() - edge.position() + a.arm;
  a.overlap = points.radius[i] + points.edge_offset[i].x - dot(a.normal, a.reach);
  return a;
}

inline PointGeometry corner_edge_geometry(const ContactPoints& points, std::size_t i, const Approach& a,
                                          const Frame& corner, const Frame& edge) {
  const double rho = points.radius[i];
  const PointHistory& past = points.history[i];
  PointGeometry g;
  g.normal = a.normal;
  g.overlap = a.overlap;
  g.arm_corner = a.arm - rho * a.normal;
  g.arm_edge = a.reach - rho * a.normal;
  g.position = dot(turned(a.normal), a.reach) - points.edge_offset[i].y - rho * (corner.angle - edge.angle);
  g.slip = past.open ? 0.0 : g.position - past.anchor;
  return g;
}

PointGeometry round_geometry(const ContactPoints& points, std::size_t i, const Frame& corner,
                             const Frame& edge) {
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
  const double slipped = distance * cross(past.direction, g.normal) -
                         (distance - other) * (corner.angle - past.angle_corner) -
                         other * (edge.angle - past.angle_edge);
  g.position = slipped;
  g.slip = past.open ? 0.0 : slipped - past.anchor;
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

// Round contacts measure their position from the last committed poses.
inline double rebased_position(ContactPoints& points, std::size_t i, const PointGeometry& g,
                               const Frame& corner, const Frame& edge) {
  if (points.kind[i] == FeatureKind::corner_edge) return g.position;
  PointHistory& history = points.history[i];
  history.direction = g.normal;
  history.angle_corner = corner.angle, history.angle_edge = edge.angle;
  return 0.0;
}

// What the forces of a point do and did, for the work between two committed poses.
struct PointForces {
  double dashpot = 0.0, viscous = 0.0, friction = 0.0;  // N, as in PointPast
  double slip = 0.0;                                    // m, that the spring keeps
};

// The work since the last commit; then Coulomb's return: the anchor follows what the friction cannot hold.
inline void commit_point(ContactPoints& points, std::size_t i, const PointGeometry& g, const PointForces& f,
                         const Frame& corner, const Frame& edge, ContactTotals& totals) {
  PointPast& past = points.past[i];
  const double closed = g.overlap - past.overlap, slid = g.position - past.position;
  totals.damping_work += 0.5 * (past.dashpot + f.dashpot) * closed + 0.5 * (past.viscous + f.viscous) * slid;
  totals.tangential_work += 0.5 * (past.friction + f.friction) * slid;
  const double position = rebased_position(points, i, g, corner, edge);
  past = {g.overlap, position, f.dashpot, f.viscous, f.friction};
  points.history[i].open = !(g.overlap > 0.0);
  points.history[i].anchor = position - f.slip;
}

}  // namespace

void ContactPoints::resize(std::size_t n, bool with_rocking) {
  kind.resize(n);
  corner_body.resize(n), edge_body.resize(n);
  corner.resize(n), edge_point.resize(n), edge_normal.resize(n), edge_offset.resize(n);
  radius.resize(n), other_radius.resize(n);
  stiffness.resize(n), bearing.resize(n), inverse_width.resize(n), history.resize(n), past.resize(n);
  rocking.resize(with_rocking ? n : 0);
}

void ContactPoints::set(std::size_t i, const Feature& f, const BearingLength& length,
                        const PointStiffness& law, double width) {
  kind[i] = f.kind;
  corner_body[i] = f.corner_body, edge_body[i] = f.edge_body;
  corner[i] = f.corner, edge_point[i] = f.edge_point, edge_normal[i] = f.edge_normal;
  edge_offset[i] = {dot(f.edge_normal, f.edge_point), dot(turned(f.edge_normal), f.edge_point)};
  radius[i] = f.radius, other_radius[i] = f.other_radius;
  stiffness[i] = law, bearing[i] = length;
  inverse_width[i] = 1.0 / width;
}

void ContactPoints::start(std::size_t i, std::span<const Frame> frames) {
  history[i] = {}, past[i] = {};
  const PointGeometry g = geometry_of(*this, i, frames);
  past[i].overlap = g.overlap;
  past[i].position = rebased_position(*this, i, g, frames[corner_body[i]], frames[edge_body[i]]);
}

PointGeometry geometry_of(const ContactPoints& points, std::size_t i, std::span<const Frame> frames) {
  const Frame &corner = frames[points.corner_body[i]], &edge = frames[points.edge_body[i]];
  if (points.kind[i] == FeatureKind::round) return round_geometry(points, i, corner, edge);
  return corner_edge_geometry(points, i, approach_of(points, i, corner, edge), corner, edge);
}

namespace {

inline double damping_share(const ContactPoints& points, std::size_t i) {
  return points.history[i].resting ? points.stiffness[i].resting : 1.0;
}

}  // namespace

PointStiffness law_at(const ContactPoints& points, std::size_t i, const PointGeometry& g) {
  const PointStiffness& law = points.stiffness[i];
  return scaled(law, bearing_share(points.bearing[i], g.position).factor, damping_share(points, i));
}

double overlap_rate(const PointGeometry& g, const Frame& corner, const Frame& edge) {
  return rates_of(g, corner, edge).overlap;
}

namespace {

// What the forces of a pose count for in the step before and after it, where the point closed since the last
// pose or is about to open (contact_forces).
struct PoseWeights {
  double spring = 1.0, dashpot = 1.0;
};

// tau/h: part of the step before in which the point was closed.
inline PoseWeights closing_weights(double overlap, double rate, double step) {
  const double closed = rate * step > overlap ? overlap / (rate * step) : 1.0;
  return {0.5 + 0.5 * closed, 0.5 + closed};
}

// Of a point that will open before the step is over.
inline double opening_weight(double overlap, double rate, double step) {
  return overlap + rate * step < 0.0 ? 0.5 - 0.5 * overlap / (rate * step) : 1.0;
}

// Forces along the edge, against slip, from a stiffness that follows the position (bearing_length.h).
struct EndForces {
  double normal = 0.0, tangential = 0.0;  // N, from the energy of each spring
};

inline EndForces end_forces(const PointStiffness& whole, double slope, double overlap, double slip) {
  return {0.5 * slope * whole.normal * overlap * overlap, 0.5 * slope * whole.tangential * slip * slip};
}

// Force of one touching point; adds its powers to the totals. step = 0: no weighing.
inline PointForces touch(const ContactPoints& points, std::size_t i, const PointGeometry& g,
                         const Frame& corner, const Frame& edge, double step, PointLoad& load,
                         ContactTotals& totals) {
  const PointStiffness& whole = points.stiffness[i];
  const BearingShare share = bearing_share(points.bearing[i], g.position);
  const PointStiffness law = scaled(whole, share.factor, damping_share(points, i));
  const bool was_open = points.history[i].open;
  const PointRates rate = rates_of(g, corner, edge);
  const PoseWeights w =
      was_open && step > 0.0 ? closing_weights(g.overlap, rate.overlap, step) : PoseWeights{};
  double spring = w.spring * law.normal * g.overlap;
  double normal =
      normal_force(w.spring * law.normal, w.dashpot * law.normal_damping, g.overlap, rate.overlap);
  const double limit = law.friction * normal;
  const double damping = w.dashpot * law.tangential_damping;
  const double wanted = law.tangential * g.slip + damping * rate.slip;
  const double last = normal > 0.0 ? opening_weight(g.overlap, rate.overlap, step) : 1.0;
  spring *= last, normal *= last;
  const double slip = returned_slip(g.slip, law.tangential, limit);
  const EndForces end = end_forces(whole, share.slope, g.overlap, slip);
  const double held = last * friction_force(wanted, limit) + end.tangential;
  const double tangential = -held - end.normal;
  const Vec2 force = normal * g.normal + tangential * turned(g.normal);
  load = {force.x, force.y, cross(g.arm_corner, force), -cross(g.arm_edge, force)};

  const double viscous = std::abs(wanted) > limit ? 0.0 : last * damping * rate.slip;
  const PointForces f{normal - spring, viscous, held - viscous, slip};
  totals.damping_power += f.dashpot * rate.overlap + f.viscous * rate.slip;
  totals.tangential_power += f.friction * rate.slip;
  return f;
}

// A point at rest: it bears, and its dashpot adds next to nothing.
bool is_calm(const ContactPoints& points, std::size_t i) {
  constexpr double next_to_nothing = 0.05;
  const PointPast& past = points.past[i];
  const double spring = points.stiffness[i].normal * past.overlap;
  return spring > 0.0 && std::abs(past.dashpot) <= next_to_nothing * spring;
}

// Both points of a pair, after a commit at `time`. They come to rest when both have been calm for some
// periods of their springs, so that no landing ends in between; a point that opens rouses both. Returns
// whether they have been roused.
bool follow_rest(ContactPoints& points, std::size_t first, double time) {
  constexpr double relaxations = 10.0;
  PointHistory &a = points.history[first], &b = points.history[first + 1];
  const bool rested = a.resting || b.resting;
  if (a.open || b.open || a.resting != b.resting) {
    a.resting = b.resting = false;
    a.calm_since = std::numeric_limits<double>::infinity();
    return rested;
  }
  if (rested) return false;
  if (!is_calm(points, first) || !is_calm(points, first + 1)) {
    a.calm_since = std::numeric_limits<double>::infinity();
    return false;
  }
  a.calm_since = std::min(a.calm_since, time);
  const PointStiffness& law = points.stiffness[first];
  a.resting = b.resting = (time - a.calm_since) * law.normal >= relaxations * law.normal_damping;
  return false;
}

}  // namespace

void put_to_rest(ContactPoints& points) {
  for (std::size_t i = 0; i + 1 < points.size(); i += 2) {
    PointHistory &a = points.history[i], &b = points.history[i + 1];
    a.resting = b.resting = !a.open && !b.open;
    a.calm_since = std::numeric_limits<double>::infinity();
  }
}

ContactTotals contact_forces(ContactPoints& points, std::span<const Frame> frames, bool commit,
                             std::span<PointLoad> loads, double time, double step) {
  ContactTotals totals;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Frame &corner = frames[points.corner_body[i]], &edge = frames[points.edge_body[i]];
    PointGeometry g;
    if (points.kind[i] == FeatureKind::corner_edge) {
      const Approach a = approach_of(points, i, corner, edge);
      if (commit || a.overlap > 0.0) g = corner_edge_geometry(points, i, a, corner, edge);
    } else {
      g = round_geometry(points, i, corner, edge);
    }
    PointForces f;
    if (g.overlap > 0.0)
      f = touch(points, i, g, corner, edge, step, loads[i], totals);
    else
      loads[i] = {};
    if (!commit) continue;
    commit_point(points, i, g, f, corner, edge, totals);
    const double ratio = g.overlap * points.inverse_width[i];
    if (ratio > totals.deepest_ratio) totals.deepest_ratio = ratio, totals.deepest_point = i;
    if (i % 2 == 1) totals.roused |= follow_rest(points, i - 1, time);
  }
  add_rocking_couples(points, frames, commit, loads, totals);
  return totals;
}

namespace {

// Whether the spring, as it was committed, holds all that friction can.
bool slides(const PointStiffness& law, const PointGeometry& g, const PointRates& rate) {
  constexpr double rounding = 1e-9;
  const double limit = law.friction * normal_force(law.normal, law.normal_damping, g.overlap, rate.overlap);
  return limit > 0.0 && law.tangential * std::abs(g.slip) >= (1.0 - rounding) * limit;
}

}  // namespace

void contact_events(const ContactPoints& points, std::span<const Frame> frames, bool at_start,
                    std::span<double> values) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PointGeometry g = geometry_of(points, i, frames);
    const PointRates rate = rates_of(g, frames[points.corner_body[i]], frames[points.edge_body[i]]);
    values[2 * i] = g.overlap;
    const bool watched = !at_start || slides(law_at(points, i, g), g, rate);
    values[2 * i + 1] = watched ? rate.slip : std::numeric_limits<double>::quiet_NaN();
  }
}

StoredEnergy stored_energy(const ContactPoints& points, std::span<const Frame> frames) {
  StoredEnergy energy;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PointGeometry g = geometry_of(points, i, frames);
    if (g.overlap <= 0.0) continue;
    const PointStiffness law = law_at(points, i, g);
    const double slip = returned_slip(g.slip, law.tangential, law.friction * law.normal * g.overlap);
    energy.normal += 0.5 * law.normal * g.overlap * g.overlap;
    energy.tangential += 0.5 * law.tangential * slip * slip;
  }
  return energy;
}

}  // namespace dougong::engine
