#include "engine/contact/contact_set.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/contact/stiffness.h"

namespace dougong::engine {
namespace {

// Margin of a pair over the smaller body's minimum width: manifolds are looked for this far apart.
constexpr double margin_ratio = 0.02;
// Relative motion that calls for a new manifold, over the margin.
constexpr double refresh_ratio = 0.3;
// Where corners pass each other their contact turns across as soon as it is no longer than deep: the motion
// allowed is a part of its length, at least this part of the margin.
constexpr double shortest_reach = 0.02;
// Skin of the broad phase over the median minimum width.
constexpr double skin_ratio = 0.25;
constexpr std::size_t longest_wait = 16;  // steps
// How far a rim may go in one step: two bodies then close by less than half the margin, or half the skin.
constexpr double margin_travel = 0.2;
constexpr double skin_travel = 0.1;
// How far two bodies may come closer between two looks, over the margin: steps may be half as long again as
// margin_travel says (drive.cpp), or refresh_ratio bounds their motion.
constexpr double longest_travel = std::max(3.0 * margin_travel, refresh_ratio);

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

struct SeenPose {
  Vec2 position;
  double angle;
};

// The smaller body's pose in the larger one's frame: its own radius bounds how far a turn carries its rim.
SeenPose seen_pose(const Model& model, std::span<const Frame> frames, BodyPair p) {
  const bool a_larger = model.bounding_radius[p.a] >= model.bounding_radius[p.b];
  const Frame &large = frames[a_larger ? p.a : p.b], &small = frames[a_larger ? p.b : p.a];
  return {large.to_local(small.position()), small.angle - large.angle};
}

// What the motion that calls for a new manifold is measured by (m).
double reach_of(const ContactPair& pair) {
  if (pair.manifold.count < 2) return pair.margin;
  return std::clamp(pair.manifold.length, shortest_reach * pair.margin, pair.margin);
}

// How far any point of one may have moved against the other since then (m).
double moved_since_seen(const Model& model, const ContactPair& pair, const SeenPose& now) {
  const Vec2 d = now.position - pair.seen_position;
  const double radius = std::min(model.bounding_radius[pair.bodies.a], model.bounding_radius[pair.bodies.b]);
  return std::abs(d.x) + std::abs(d.y) + radius * std::abs(now.angle - pair.seen_angle);
}

double gap_of(const Feature& f, std::span<const Frame> frames) {
  const Frame& edge = frames[f.edge_body];
  const Vec2 d = frames[f.corner_body].to_world(f.corner) - edge.to_world(f.edge_point);
  return (f.kind == FeatureKind::round ? norm(d) : dot(edge.turned_to_world(f.edge_normal), d)) - f.radius;
}

double gap_of(const Manifold& m, std::span<const Frame> frames) {
  double gap = std::numeric_limits<double>::infinity();
  for (Index k = 0; k < m.count; ++k) gap = std::min(gap, gap_of(m.features[k], frames));
  return gap;
}

// What the scene's moving ground carries along does not count as motion.
Vec2 common_position(const Model& model, std::span<const Frame> frames) {
  for (std::size_t j = 0; j < model.terrain_count; ++j)
    if (model.motions[j]) return frames[model.body_count + j].position();
  return {};
}

Vec2 common_velocity(const Model& model, std::span<const Frame> frames) {
  for (std::size_t j = 0; j < model.terrain_count; ++j)
    if (model.motions[j]) return frames[model.body_count + j].velocity();
  return {};
}

// Greatest speed of any point of a body, relative to what moves all of them (m/s).
double fastest_rim(const Model& model, std::span<const Frame> frames) {
  const Vec2 common = common_velocity(model, frames);
  double fastest = 0.0;
  for (std::size_t i = 0; i < model.size(); ++i) {
    if (!model.touchable[i]) continue;
    const Vec2 v = frames[i].velocity() - common;
    fastest = std::max(fastest,
                       std::abs(v.x) + std::abs(v.y) + model.bounding_radius[i] * std::abs(frames[i].spin));
  }
  return fastest;
}

// Time in which what moves at `speed` and falls freely besides goes `way` (s).
double time_to_go(const Model& model, double way, double speed) {
  const double root = std::sqrt(speed * speed + 2.0 * norm(model.gravity) * way);
  return speed + root > 0.0 ? 2.0 * way / (speed + root) : std::numeric_limits<double>::infinity();
}

bool same_features(const Manifold& a, const Manifold& b) {
  if (a.count != b.count) return false;
  for (Index i = 0; i < a.count; ++i)
    if (a.features[i].identity != b.features[i].identity) return false;
  return true;
}

// The second slot of a pair that touches in one point: so far apart that it never does.
Feature empty_slot(Index a, Index b) {
  Feature f;
  f.corner_body = a;
  f.edge_body = b;
  f.edge_normal = {0.0, 1.0};
  f.radius = PointBlock::far_away;
  return f;
}

// The lighter of two bodies rocks on the other, which is taken to stand still.
RockingImpact rocking_impact(const Model& model, const Manifold& m, BodyPair bodies,
                             const PointStiffness& law) {
  const bool a_rocks = model.mass[bodies.a] <= model.mass[bodies.b];
  const Index body = a_rocks ? bodies.a : bodies.b;
  return {model.mass[body], model.inertia[body], 0.5 * m.length, a_rocks ? m.depth_a : m.depth_b, law};
}

Vec2 place_of(const ContactPoints& points, std::size_t i, std::span<const Frame> frames) {
  return frames[points.edge_body[i]].position() + geometry_of(points, i, frames).arm_edge;
}

// The sense in which a point's force turns the corner's body more if it acts nearer to the other point.
double inward_turn(const ContactPoints& points, std::size_t i, std::size_t other,
                   std::span<const Frame> frames) {
  const Vec2 tangent = turned(geometry_of(points, i, frames).normal);
  const Vec2 inward = place_of(points, other, frames) - place_of(points, i, frames);
  return dot(inward, tangent) > 0.0 ? -1.0 : 1.0;
}

// Of the springs along the normals of a pair's two points (J).
double energy_of(const ContactPoints& points, std::size_t first, std::span<const Frame> frames) {
  double energy = 0.0;
  for (const std::size_t i : {first, first + 1}) {
    const PointGeometry g = geometry_of(points, i, frames);
    if (g.overlap > 0.0) energy += 0.5 * law_at(points, i, g).normal * g.overlap * g.overlap;
  }
  return energy;
}

PointStiffness hardened(PointStiffness law, double factor) {
  law.normal *= factor, law.tangential *= factor;
  law.normal_damping *= std::sqrt(factor), law.tangential_damping *= std::sqrt(factor);
  return law;
}

// The history that another feature hands over, with a spring that holds its slip.
PointHistory history_with_slip(const ContactPoints& points, std::size_t i, std::span<const Frame> frames,
                               const PointHistory& kept, double slip) {
  const Frame &corner = frames[points.corner_body[i]], &edge = frames[points.edge_body[i]];
  const PointGeometry g = geometry_of(points, i, frames);
  const bool round = points.kind[i] == FeatureKind::round;
  PointHistory history{
      round ? -slip : g.position - slip, false, {0.0, 1.0}, 0.0, 0.0, kept.resting, kept.calm_since};
  if (round)
    history.direction = g.normal, history.angle_corner = corner.angle, history.angle_edge = edge.angle;
  return history;
}

}  // namespace

ContactSet::ContactSet(const Model& model) {
  index_bodies(model.size());
  if (!model.has_contacts()) return;
  std::vector<double> body_widths;
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < model.size(); ++i) {
    if (!model.touchable[i]) continue;
    smallest = std::min(smallest, model.minimum_width[i]);
    if (i < model.body_count) body_widths.push_back(model.minimum_width[i]);
  }
  skin_ = skin_ratio * median(std::move(body_widths));
  smallest_margin_ = margin_ratio * smallest;
  skin_ = std::max(skin_, 4.0 * smallest_margin_);
  sleeping_gap_ = longest_travel * smallest_margin_;
}

void ContactSet::keep_apart(std::vector<BodyPair> held) {
  held_ = std::move(held);
  skin_position_.clear();  // look for pairs again
}

bool ContactSet::moved_beyond_skin(const Model& model, std::span<const Frame> frames) const {
  if (skin_position_.size() != model.size()) return true;
  const Vec2 common = common_position(model, frames);
  for (std::size_t i = 0; i < model.size(); ++i) {
    if (!model.touchable[i]) continue;
    const Vec2 d = frames[i].position() - common - skin_position_[i];
    const double turn = model.bounding_radius[i] * std::abs(frames[i].angle - skin_angle_[i]);
    // A quarter of the skin: the other half of the half is for the steps until the next look.
    if (std::abs(d.x) + std::abs(d.y) + turn > 0.25 * skin_) return true;
  }
  return false;
}

void ContactSet::rebuild_pairs(const Model& model, std::span<const Frame> frames) {
  std::vector<ContactPair> pairs;
  auto old = pairs_.begin();
  for (const BodyPair colliders : find_pairs(model, frames, skin_)) {
    const Collider &a = model.colliders[colliders.a], &b = model.colliders[colliders.b];
    if (!model.touchable[a.owner] || !model.touchable[b.owner]) continue;
    while (old != pairs_.end() && old->colliders < colliders) ++old;
    if (old != pairs_.end() && old->colliders == colliders) {
      pairs.push_back(*old);
      continue;
    }
    if (std::binary_search(held_.begin(), held_.end(), BodyPair{a.owner, b.owner})) continue;
    ContactPair pair;
    pair.colliders = colliders;
    pair.bodies = {a.owner, b.owner};
    pair.margin = margin_ratio * std::min(a.minimum_width, b.minimum_width);
    pair.seen_angle = std::numeric_limits<double>::infinity();  // never seen: has moved
    pairs.push_back(pair);
  }
  pairs_ = std::move(pairs);
  const Vec2 common = common_position(model, frames);
  skin_position_.resize(model.size()), skin_angle_.resize(model.size());
  for (std::size_t i = 0; i < model.size(); ++i) {
    skin_position_[i] = frames[i].position() - common;
    skin_angle_[i] = frames[i].angle;
  }
}

std::array<ContactSet::Memory, 2> ContactSet::memory_of(const ContactPoints& points, std::size_t first) {
  const auto one = [&](std::size_t i) {
    return Memory{points.history(i), points.past(i),
                  points.rocking.empty() ? RockingDashpot{} : points.rocking[i]};
  };
  return {one(first), one(first + 1)};
}

PointStiffness ContactSet::law_of(const Model& model, std::span<const Frame> frames, const ContactPair& pair,
                                  const Feature& feature, double length) const {
  const auto [a, b] = pair.bodies;
  if (!rigid_) return point_stiffness(model, frames, pair.manifold, feature, length, a, b);
  PointStiffness rigid;
  rigid.friction = model.rule(a, b).friction_coefficient;
  return rigid;
}

void ContactSet::make_rigid(const Model& model, std::span<const Frame> frames, bool rigid) {
  if (rigid == rigid_) return;
  rigid_ = rigid;
  for (ContactPair& pair : pairs_)
    if (pair.active) write_points(model, frames, pair, {}, {});
}

void ContactSet::write_points(const Model& model, std::span<const Frame> frames, ContactPair& pair,
                              const Manifold& old, std::span<const Memory> kept) {
  const auto [a, b] = pair.bodies;
  const double width = std::min(model.minimum_width[a], model.minimum_width[b]);
  for (Index k = 0; k < 2; ++k) {
    const std::size_t i = pair.first_point + k;
    if (k >= pair.manifold.count) {
      points.set(i, pair.bodies, empty_slot(a, b), {}, {}, width);
      points.set_history(i, {}), points.set_past(i, {});
      if (!points.rocking.empty()) points.rocking[i] = {};
      continue;
    }
    const Feature& feature = pair.manifold.features[k];
    const BearingLength length = rigid_ ? BearingLength{} : bearing_of(model, frames, pair.manifold, feature);
    const PointStiffness law = law_of(model, frames, pair, feature, 1.0 / length.per_reference);
    points.set(i, pair.bodies, feature, length, hardened(law, pair.hardening), width);
    points.start(i, frames);
    for (Index l = 0; l < old.count; ++l) {
      if (old.features[l].identity != feature.identity) continue;
      points.set_history(i, kept[l].history), points.set_past(i, kept[l].past);
      if (!points.rocking.empty()) points.rocking[i] = kept[l].rocking;
    }
  }
  if (!points.rocking.empty()) write_rocking(model, frames, pair);
}

// What a pair that touches has stored stays when other features take its contact over: a corner in a face
// bears on as it did, though now another of its own faces turns to it.
void ContactSet::keep_energy(std::span<const Frame> frames, ContactPair& pair, double stored) {
  constexpr double rounding = 1e-9;
  const double now = energy_of(points, pair.first_point, frames);
  if (stored == 0.0 || now == 0.0 || std::abs(stored / now - 1.0) < rounding) return;
  harden(pair, pair.hardening * stored / now);
}

void ContactSet::harden(ContactPair& pair, double hardening) {
  constexpr double most = 1e4;  // a sliver of 1:100 that goes over from its end to its side
  hardening = std::clamp(hardening, 1.0 / most, most);
  for (const Index k : {0, 1}) {
    const std::size_t i = pair.first_point + k;
    points.set_stiffness(i, hardened(points.stiffness(i), hardening / pair.hardening));
  }
  pair.hardening = hardening;
}

// The contacts of two bodies whose face was joined until now: closed where they overlap, with relaxed
// friction springs.
void ContactSet::hand_over(std::span<const Frame> frames, const Heir& heir) {
  const auto each = [&](auto&& visit) {
    for (ContactPair& pair : pairs_)
      if (pair.active && pair.bodies == heir.bodies) visit(pair);
  };
  double now = 0.0, taken = 0.0;
  each([&](ContactPair& pair) { now += energy_of(points, pair.first_point, frames); });
  if (now == 0.0) return;
  each([&](ContactPair& pair) {
    harden(pair, pair.hardening * heir.energy / now);
    for (const std::size_t i : {pair.first_point + 0u, pair.first_point + 1u}) {
      const PointGeometry g = geometry_of(points, i, frames);
      if (g.overlap > 0.0)
        points.set_history(i, history_with_slip(points, i, frames, points.history(i), 0.0));
    }
    taken += energy_of(points, pair.first_point, frames);
  });
  inherited_ += std::min(taken, heir.energy);
}

// A face with two corners can rock; its law is found anew when the length of contact has changed.
void ContactSet::write_rocking(const Model& model, std::span<const Frame> frames, ContactPair& pair) {
  constexpr double same_length = 1e-3;
  const Manifold& m = pair.manifold;
  const auto ratio = model.rule(pair.bodies.a, pair.bodies.b).rocking_restitution;
  const bool rocks = ratio && m.count == 2 && m.length > 0.0;
  if (rocks && std::abs(m.length - pair.rocking_length) > same_length * m.length) {
    const PointStiffness law = points.stiffness(pair.first_point);
    pair.rocking = law_for_ratio(rocking_impact(model, m, pair.bodies, law), *ratio);
    pair.rocking_length = m.length;
  }
  for (const Index k : {0, 1}) {
    const std::size_t i = pair.first_point + k;
    RockingDashpot& dashpot = points.rocking[i];
    if (!dashpot.acts())
      dashpot.past_angle = frames[points.corner_body[i]].angle - frames[points.edge_body[i]].angle;
    const PointStiffness law = points.stiffness(i);
    dashpot.couple = rocks ? pair.rocking.couple : 0.0;
    dashpot.inset =
        rocks ? inward_turn(points, i, pair.first_point + 1 - k, frames) * pair.rocking.inset : 0.0;
    dashpot.length = m.length;
    if (rocks) dashpot.rate = law.normal / law.normal_damping, dashpot.damping = law.normal_damping;
  }
}

bool ContactSet::refresh(const Model& model, std::span<const Frame> frames, ContactPair& pair,
                         bool& activity_changed) {
  const Manifold old = pair.manifold;
  pair.manifold = find_manifold(model, frames, pair.colliders.a, pair.colliders.b, pair.margin, old);
  pair.gap = gap_of(pair.manifold, frames);
  const bool active = pair.manifold.count > 0;
  if (active != pair.active) {
    activity_changed = true;
    pair.hardening = 1.0;
    return true;
  }
  if (!active) return false;

  // End k of the contact may have passed from one corner to another at the same place.
  const std::array<Memory, 2> kept = memory_of(points, pair.first_point);
  std::array<double, 2> slip{};
  for (Index k = 0; k < old.count; ++k) slip[k] = geometry_of(points, pair.first_point + k, frames).slip;
  const auto place = [&](Index k) { return place_of(points, pair.first_point + k, frames); };
  const std::array<Vec2, 2> old_place{place(0), place(old.count > 1 ? 1 : 0)};
  const double stored = energy_of(points, pair.first_point, frames);
  if (stored == 0.0) pair.hardening = 1.0;
  write_points(model, frames, pair, old, kept);
  keep_energy(frames, pair, stored);
  if (same_features(old, pair.manifold)) return false;
  for (Index k = 0; k < std::min(old.count, pair.manifold.count); ++k) {
    const auto identity = pair.manifold.features[k].identity;
    if (identity == old.features[0].identity || (old.count > 1 && identity == old.features[1].identity))
      continue;
    if (kept[k].history.open || norm(place(k) - old_place[k]) > 2.0 * pair.margin) continue;
    // Corner and edge may have changed sides: both the tangent and the motion turn round, so slip stays.
    const std::size_t i = pair.first_point + k;
    points.set_history(i, history_with_slip(points, i, frames, kept[k].history, slip[k]));
  }
  return true;
}

// Gives every active pair two slots, keeping the history of those that had them; pairs far from touching
// come last, so that they share blocks that can sleep.
void ContactSet::lay_out_points(const Model& model, std::span<const Frame> frames) {
  const ContactPoints old = std::move(points);
  points = {};
  std::size_t count = 0;
  for (const ContactPair& pair : pairs_) count += pair.manifold.count > 0 ? 2 : 0;
  points.resize(count, model.has_rocking_restitution());
  std::size_t near = 0, far = count;
  for (ContactPair& pair : pairs_) {
    const bool was_active = pair.active;
    pair.active = pair.manifold.count > 0;
    if (!pair.active) continue;
    const std::size_t old_first = pair.first_point;
    const bool apart = pair.gap > sleeping_gap_;
    pair.first_point = static_cast<Index>(apart ? far -= 2 : near);
    near += apart ? 0 : 2;
    if (was_active)
      write_points(model, frames, pair, pair.manifold, memory_of(old, old_first));
    else
      write_points(model, frames, pair, {}, {});
  }
  index_bodies(model.size());
}

void ContactSet::index_bodies(std::size_t bodies) {
  first_.assign(bodies + 1, 0);
  const auto each = [&](auto&& visit) {
    for (const ContactPair& pair : pairs_)
      if (pair.active) visit(pair.bodies.a, pair.first_point), visit(pair.bodies.b, pair.first_point + 1);
  };
  each([&](Index body, Index) { ++first_[body + 1]; });
  for (std::size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  touches_.resize(points.size());
  each([&](Index body, Index side) { touches_[next[body]++] = side; });
}

// Blocks of points that are open and cannot close before the next look are not evaluated until then.
void ContactSet::put_blocks_to_sleep(std::span<const Frame> frames) {
  const auto blocks = points.blocks();
  sleeps_.assign(blocks.size(), !rigid_);
  for (const ContactPair& pair : pairs_) {
    const bool apart = pair.gap - pair.moved > sleeping_gap_;
    if (pair.active && !(apart && points.open(pair.first_point) && points.open(pair.first_point + 1)))
      sleeps_[pair.first_point / PointBlock::size] = false;
  }
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    const bool wakes = blocks[k].asleep && !sleeps_[k];
    blocks[k].asleep = sleeps_[k] != 0;
    for (std::size_t i = k * PointBlock::size; wakes && i < (k + 1) * PointBlock::size && i < points.size();
         ++i)
      points.start(i, frames);
  }
}

bool ContactSet::update(const Model& model, std::span<const Frame> frames) {
  if (!model.has_contacts()) return false;
  bool activity_changed = false, changed = false;
  if (moved_beyond_skin(model, frames)) {
    const std::size_t before = points.size();
    rebuild_pairs(model, frames);
    std::size_t kept = 0;
    for (const ContactPair& pair : pairs_) kept += pair.active ? 2 : 0;
    activity_changed = kept != before;
  }
  for (ContactPair& pair : pairs_) {
    const SeenPose now = seen_pose(model, frames, pair.bodies);
    pair.moved = moved_since_seen(model, pair, now);
    if (!(pair.moved > refresh_ratio * reach_of(pair))) continue;
    pair.moved = 0.0;
    pair.seen_position = now.position, pair.seen_angle = now.angle;
    changed |= refresh(model, frames, pair, activity_changed);
  }
  smallest_reach_ = smallest_margin_;
  for (const ContactPair& pair : pairs_) smallest_reach_ = std::min(smallest_reach_, reach_of(pair));
  if (activity_changed) lay_out_points(model, frames);
  for (const Heir& heir : heirs_) hand_over(frames, heir);
  heirs_.clear();
  put_blocks_to_sleep(frames);
  return changed || activity_changed;
}

double ContactSet::longest_step(const Model& model, std::span<const Frame> frames) const {
  const double fastest = fastest_rim(model, frames);
  if (!model.has_contacts()) return std::numeric_limits<double>::infinity();
  return time_to_go(model, pairs_.empty() ? skin_travel * skin_ : margin_travel * smallest_margin_, fastest);
}

std::size_t ContactSet::steps_until_update(const Model& model, std::span<const Frame> frames,
                                           double h) const {
  const double allowed = 0.5 * refresh_ratio * smallest_reach_;
  const double steps = time_to_go(model, 0.5 * allowed, fastest_rim(model, frames)) / h;
  return std::max<std::size_t>(1,
                               static_cast<std::size_t>(std::min(steps, static_cast<double>(longest_wait))));
}

void ContactSet::gather(std::span<const PairLoad> loads, std::span<Vec2> forces,
                        std::span<double> torques) const {
  for (std::size_t body = 0; body + 1 < first_.size(); ++body) {
    double fx = 0.0, fy = 0.0, torque = 0.0;
    for (std::size_t k = first_[body]; k < first_[body + 1]; ++k) {
      const PairLoad& load = loads[touches_[k] >> 1];
      const bool second = touches_[k] & 1;
      fx += second ? -load.fx : load.fx;
      fy += second ? -load.fy : load.fy;
      torque += second ? load.torque_b : load.torque_a;
    }
    forces[body] = {fx, fy};
    torques[body] = torque;
  }
}

}  // namespace dougong::engine
