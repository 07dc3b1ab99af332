#include "engine/contact/contact_points.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "engine/kernels.h"

namespace dougong::engine {
namespace {

double flag(bool condition) {
  return condition ? 1.0 : 0.0;
}

PoseOf<double> pose_of(const Frame& f) {
  return {f.x, f.y, f.c, f.s, f.vx, f.vy, f.spin, f.angle};
}

PointRatesOf<double> rates_of(const PointGeometry& g, const Frame& corner, const Frame& edge) {
  return point_rates(g, pose_of(corner), pose_of(edge));
}

PointMemoryOf<double> memory_of(const PointHistory& h) {
  return {h.anchor, flag(h.open), flag(h.resting)};
}

// Of one point, and what it does at the poses.
struct PointAction {
  PointGeometry geometry;
  PointRatesOf<double> rate;
  PointForceOf<double> force;
};

PointAction action_of(const ContactPoints& points, std::size_t i, std::span<const Frame> frames,
                      double step) {
  PointAction a;
  a.geometry = geometry_of(points, i, frames);
  a.rate = rates_of(a.geometry, frames[points.corner_body[i]], frames[points.edge_body[i]]);
  a.force = point_force(points.stiffness(i), points.bearing(i), a.geometry, a.rate,
                        memory_of(points.history(i)), step);
  return a;
}

// Round contacts measure their position from the last committed poses.
PointHistory rebased(PointHistory history, const PointGeometry& g, const Frame& corner, const Frame& edge) {
  history.direction = g.normal;
  history.angle_corner = corner.angle, history.angle_edge = edge.angle;
  return history;
}

void commit_round(ContactPoints& points, std::size_t i, const PointAction& a, std::span<const Frame> frames,
                  ContactTotals& totals) {
  const PointWorkOf<double> work = work_since(points.past(i), a.geometry, a.force);
  totals.damping_work += work.damping, totals.tangential_work += work.tangential;
  const PointForceOf<double>& f = a.force;
  points.set_past(i, {a.geometry.overlap, 0.0, f.dashpot, f.viscous, f.friction});
  PointHistory history;
  history.anchor = -f.slip, history.open = !(a.geometry.overlap > 0.0);
  points.set_history(
      i, rebased(history, a.geometry, frames[points.corner_body[i]], frames[points.edge_body[i]]));
  totals.note_depth(a.geometry.overlap * points.inverse_width(i), i);
}

// The only point of its pair.
void add_round(ContactPoints& points, std::size_t i, std::span<const Frame> frames, bool commit,
               std::span<PairLoad> loads, double step, ContactTotals& totals) {
  const PointAction a = action_of(points, i, frames, step);
  const Vec2 force = a.force.force;
  loads[i / 2].add(points.corner_is_b(i), force, cross(a.geometry.arm_corner, force),
                   -cross(a.geometry.arm_edge, force));
  const PointWorkOf<double> power = power_of(a.force, a.rate);
  totals.damping_power += power.damping, totals.tangential_power += power.tangential;
  if (commit) commit_round(points, i, a, frames, totals);
}

void add_rounds(ContactPoints& points, std::size_t block, std::span<const Frame> frames, bool commit,
                std::span<PairLoad> loads, double step, ContactTotals& totals) {
  if (!points.blocks()[block].has_round || points.blocks()[block].asleep) return;
  const std::size_t first = block * PointBlock::size, end = std::min(first + PointBlock::size, points.size());
  for (std::size_t i = first; i < end; ++i)
    if (points.kind[i] == FeatureKind::round) add_round(points, i, frames, commit, loads, step, totals);
}

using B = PointBlock;
constexpr B::Reals B::*columns[] = {&B::corner_x,
                                    &B::corner_y,
                                    &B::normal_x,
                                    &B::normal_y,
                                    &B::offset_x,
                                    &B::offset_y,
                                    &B::radius,
                                    &B::normal,
                                    &B::tangential,
                                    &B::normal_damping,
                                    &B::tangential_damping,
                                    &B::facing,
                                    &B::edge_length,
                                    &B::per_reference,
                                    &B::anchor,
                                    &B::overlap,
                                    &B::position,
                                    &B::dashpot,
                                    &B::viscous,
                                    &B::spent_friction};
constexpr B::PairReals B::*pair_columns[] = {&B::friction, &B::resting_share, &B::nominal, &B::inverse_width,
                                             &B::calm_since};
constexpr B::Flags B::*flag_columns[] = {&B::open, &B::resting, &B::corner_is_b, &B::angular};
static_assert(std::size(columns) * sizeof(B::Reals) + std::size(pair_columns) * sizeof(B::PairReals) +
                      std::size(flag_columns) * sizeof(B::Flags) ==
                  offsetof(B, a),
              "a column is missing");

// Columns `from` and the next of one block become those `to` and the next of another.
template <class Columns>
void copy_points(const Columns& all, const B& source, std::size_t from, B& target, std::size_t to) {
  for (const auto column : all)
    for (const std::size_t k : {0u, 1u}) (target.*column)[to + k] = (source.*column)[from + k];
}

void note_round(PointBlock& b) {
  b.has_round = std::find(b.angular.begin(), b.angular.end(), 0) != b.angular.end();
}

}  // namespace

void ContactPoints::resize(std::size_t n) {
  blocks_.resize((n + PointBlock::size - 1) / PointBlock::size);
  kind.resize(n, FeatureKind::corner_edge);
  corner_body.resize(n, 0), edge_body.resize(n, 0);
  round_.resize(n);
  if (with_rocking_) rocking.resize(n);
}

void ContactPoints::clear(std::size_t i, BodyPair bodies) {
  Feature far_away;
  far_away.corner_body = bodies.a, far_away.edge_body = bodies.b;
  far_away.edge_normal = {0.0, 1.0};
  far_away.radius = PointBlock::far_away;
  const PointStiffness law = stiffness(i);
  const double nominal = bearing(i).nominal, width = 1.0 / inverse_width(i);
  set(i, bodies, far_away, {.nominal = nominal}, {.friction = law.friction, .resting = law.resting}, width);
  set_history(i, {}), set_past(i, {});
  if (!rocking.empty()) rocking[i] = {};
}

void ContactPoints::take_over(const ContactPoints& others, std::size_t from, std::size_t first) {
  const PointBlock& source = others.block(from);
  PointBlock& target = block(first);
  const std::size_t pair = lane(first) / 2, old_pair = lane(from) / 2;
  target.a[pair] = source.a[old_pair], target.b[pair] = source.b[old_pair];
  for (const auto column : pair_columns) (target.*column)[pair] = (source.*column)[old_pair];
  copy_points(columns, source, lane(from), target, lane(first));
  copy_points(flag_columns, source, lane(from), target, lane(first));
  for (const std::size_t k : {0u, 1u}) {
    kind[first + k] = others.kind[from + k];
    corner_body[first + k] = others.corner_body[from + k], edge_body[first + k] = others.edge_body[from + k];
    round_[first + k] = others.round_[from + k];
    if (!rocking.empty()) rocking[first + k] = others.rocking[from + k];
  }
  note_round(target);
}

void ContactPoints::wake(std::size_t block, std::span<const Frame> frames) {
  if (!std::exchange(blocks_[block].asleep, false)) return;
  const std::size_t first = block * PointBlock::size, end = std::min(first + PointBlock::size, size());
  for (std::size_t i = first; i < end; ++i) start(i, frames);
}

void ContactPoints::set(std::size_t i, BodyPair bodies, const Feature& f, const BearingLength& length,
                        const PointStiffness& law, double width) {
  kind[i] = f.kind;
  corner_body[i] = f.corner_body, edge_body[i] = f.edge_body;
  const bool round = f.kind == FeatureKind::round;
  round_[i] = {
      .corner = f.corner, .edge_point = f.edge_point, .radius = f.radius, .other_radius = f.other_radius};
  PointBlock& b = block(i);
  const std::size_t k = lane(i);
  b.a[k / 2] = bodies.a, b.b[k / 2] = bodies.b;
  b.corner_is_b[k] = f.corner_body == bodies.b;
  b.angular[k] = !round;
  note_round(b);
  b.corner_x[k] = f.corner.x, b.corner_y[k] = f.corner.y;
  b.normal_x[k] = f.edge_normal.x, b.normal_y[k] = f.edge_normal.y;
  b.offset_x[k] = dot(f.edge_normal, f.edge_point), b.offset_y[k] = dot(turned(f.edge_normal), f.edge_point);
  b.radius[k] = round ? PointBlock::far_away : f.radius;
  b.facing[k] = length.facing, b.edge_length[k] = length.edge_length;
  b.nominal[k / 2] = length.nominal, b.per_reference[k] = length.per_reference;
  b.inverse_width[k / 2] = 1.0 / width;
  set_stiffness(i, law);
}

void ContactPoints::start(std::size_t i, std::span<const Frame> frames) {
  set_history(i, {});
  const PointGeometry g = geometry_of(*this, i, frames);
  const bool round = kind[i] == FeatureKind::round;
  if (round) set_history(i, rebased({}, g, frames[corner_body[i]], frames[edge_body[i]]));
  set_past(i, {g.overlap, round ? 0.0 : g.position, 0.0, 0.0, 0.0});
}

PointStiffness ContactPoints::stiffness(std::size_t i) const {
  const PointBlock& b = block(i);
  const std::size_t k = lane(i);
  return {b.normal[k],       b.tangential[k],       b.normal_damping[k], b.tangential_damping[k],
          b.friction[k / 2], b.resting_share[k / 2]};
}

void ContactPoints::set_stiffness(std::size_t i, const PointStiffness& law) {
  PointBlock& b = block(i);
  const std::size_t k = lane(i);
  b.normal[k] = law.normal, b.tangential[k] = law.tangential;
  b.normal_damping[k] = law.normal_damping, b.tangential_damping[k] = law.tangential_damping;
  b.friction[k / 2] = law.friction, b.resting_share[k / 2] = law.resting;
}

void ContactPoints::set_back(std::size_t i, double by) {
  if (kind[i] == FeatureKind::corner_edge) block(i).radius[lane(i)] -= by;
}

BearingLength ContactPoints::bearing(std::size_t i) const {
  const PointBlock& b = block(i);
  const std::size_t k = lane(i);
  return {b.facing[k], b.edge_length[k], b.nominal[k / 2], b.per_reference[k]};
}

PointHistory ContactPoints::history(std::size_t i) const {
  const PointBlock& b = block(i);
  const std::size_t k = lane(i);
  const Round& r = round_[i];
  return {b.anchor[k],  b.open[k] != 0,    r.direction,        r.angle_corner,
          r.angle_edge, b.resting[k] != 0, b.calm_since[k / 2]};
}

void ContactPoints::set_history(std::size_t i, const PointHistory& h) {
  PointBlock& b = block(i);
  const std::size_t k = lane(i);
  b.anchor[k] = h.anchor, b.calm_since[k / 2] = h.calm_since;
  b.open[k] = h.open, b.resting[k] = h.resting;
  round_[i].direction = h.direction;
  round_[i].angle_corner = h.angle_corner, round_[i].angle_edge = h.angle_edge;
}

PointPast ContactPoints::past(std::size_t i) const {
  const PointBlock& b = block(i);
  const std::size_t k = lane(i);
  return {b.overlap[k], b.position[k], b.dashpot[k], b.viscous[k], b.spent_friction[k]};
}

void ContactPoints::set_past(std::size_t i, const PointPast& p) {
  PointBlock& b = block(i);
  const std::size_t k = lane(i);
  b.overlap[k] = p.overlap, b.position[k] = p.position;
  b.dashpot[k] = p.dashpot, b.viscous[k] = p.viscous, b.spent_friction[k] = p.friction;
}

PointGeometry geometry_of(const ContactPoints& points, std::size_t i, std::span<const Frame> frames) {
  const Frame &corner = frames[points.corner_body[i]], &edge = frames[points.edge_body[i]];
  const PointBlock& b = points.block(i);
  const std::size_t k = points.lane(i);
  if (points.kind[i] == FeatureKind::corner_edge) {
    const CornerEdgeOf<double> place{{b.corner_x[k], b.corner_y[k]},
                                     {b.normal_x[k], b.normal_y[k]},
                                     {b.offset_x[k], b.offset_y[k]},
                                     b.radius[k]};
    return corner_edge_geometry(place, pose_of(corner), pose_of(edge),
                                {b.anchor[k], flag(b.open[k]), flag(b.resting[k])});
  }
  const ContactPoints::Round& past = points.round_[i];
  const Vec2 edge_arm = edge.turned_to_world(past.edge_point);
  const Vec2 between = corner.position() - edge.position();
  const Vec2 d = between + corner.turned_to_world(past.corner) - edge_arm;
  const double distance = norm(d);
  PointGeometry g;
  g.normal = distance > 0.0 ? (1.0 / distance) * d : past.direction;
  g.overlap = past.radius - distance;
  const double other = past.other_radius;
  // Rate of slip: D phi' - (D - r_o) theta_corner' - r_o theta_edge', D the distance of the centres.
  g.position = distance * cross(past.direction, g.normal) -
               (distance - other) * (corner.angle - past.angle_corner) -
               other * (edge.angle - past.angle_edge);
  g.slip = b.open[k] != 0 ? 0.0 : g.position - b.anchor[k];
  g.arm_edge = edge_arm + other * g.normal;
  g.arm_corner = g.arm_edge - between;
  return g;
}

double damping_share(const ContactPoints& points, std::size_t i) {
  return points.history(i).resting ? points.stiffness(i).resting : 1.0;
}

PointStiffness law_at(const ContactPoints& points, std::size_t i, const PointGeometry& g) {
  return scaled(points.stiffness(i), bearing_share(points.bearing(i), g.position).factor,
                damping_share(points, i));
}

double overlap_rate(const PointGeometry& g, const Frame& corner, const Frame& edge) {
  return rates_of(g, corner, edge).overlap;
}

Vec2 force_of(const ContactPoints& points, std::size_t i, std::span<const Frame> frames) {
  return action_of(points, i, frames, 0.0).force.force;
}

void put_to_rest(ContactPoints& points) {
  for (PointBlock& b : points.blocks())
    for (std::size_t k = 0; k < PointBlock::size; k += 2) {
      b.resting[k] = b.resting[k + 1] = b.open[k] == 0 && b.open[k + 1] == 0;
      b.calm_since[k / 2] = PointBlock::never;
    }
}

ContactTotals contact_forces(ContactPoints& points, std::span<const Frame> frames, bool commit,
                             std::span<PairLoad> loads, double time, double step, Crew& crew) {
  constexpr std::size_t share = 64;                 // blocks
  thread_local std::vector<ContactTotals> partial;  // sums, of each share
  const auto blocks = points.blocks();
  partial.assign((blocks.size() + share - 1) / share, {});
  crew.share_range(blocks.size(), share, [&, sums = partial.data()](std::size_t first, std::size_t last) {
    best_kernels().corner_edge_forces(
        {blocks.data(), first, last, points.size(), frames.data(), commit, loads.data(), time, step},
        sums[first / share]);
    for (std::size_t k = first; k < last; ++k)
      add_rounds(points, k, frames, commit, loads, step, sums[first / share]);
  });
  ContactTotals totals;
  for (const ContactTotals& sum : partial) totals += sum;
  if (totals.roused) points.note_roused();
  add_rocking_couples(points, frames, commit, loads, totals);
  return totals;
}

namespace {

// Whether the spring, as it was committed, holds all that friction can.
bool slides(const PointStiffness& law, const PointGeometry& g, const PointRatesOf<double>& rate) {
  constexpr double rounding = 1e-9;
  const double limit = law.friction * normal_force(law.normal, law.normal_damping, g.overlap, rate.overlap);
  return limit > 0.0 && law.tangential * std::abs(g.slip) >= (1.0 - rounding) * limit;
}

}  // namespace

void contact_events(const ContactPoints& points, std::span<const Frame> frames, bool at_start,
                    std::span<double> values) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PointGeometry g = geometry_of(points, i, frames);
    const auto rate = rates_of(g, frames[points.corner_body[i]], frames[points.edge_body[i]]);
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
