#include "engine/contact/contact_set.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/contact/stiffness.h"
#include "engine/kernels.h"

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
constexpr double skin_ratio = 0.5;
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

// The one whose radius bounds how far a turn of the pair carries its rim.
Index smaller_of(const Model& model, BodyPair p) {
  return model.bounding_radius[p.a] >= model.bounding_radius[p.b] ? p.b : p.a;
}

// What the motion that calls for a new manifold is measured by (m).
double reach_of(const ContactPair& pair) {
  if (pair.manifold.count < 2) return pair.margin;
  return std::clamp(pair.manifold.length, shortest_reach * pair.margin, pair.margin);
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
  points = ContactPoints(model.has_rocking_restitution());
  has_contacts_ = model.has_contacts();
  if (!has_contacts_) return;
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
  const auto leave_behind = [&](auto&& is_behind) {
    for (; old != pairs_.end() && is_behind(*old); ++old)
      if (old->active) leave(*old), disturb(old->bodies);
  };
  for (const BodyPair colliders : find_pairs(model, frames, skin_)) {
    const Collider &a = model.colliders[colliders.a], &b = model.colliders[colliders.b];
    if (!model.touchable[a.owner] || !model.touchable[b.owner]) continue;
    leave_behind([&](const ContactPair& pair) { return pair.colliders < colliders; });
    if (old != pairs_.end() && old->colliders == colliders) {
      pairs.push_back(*old++);
      continue;
    }
    if (std::binary_search(held_.begin(), held_.end(), BodyPair{a.owner, b.owner})) continue;
    ContactPair pair;
    pair.colliders = colliders;
    pair.bodies = {a.owner, b.owner};
    pair.margin = margin_ratio * std::min(a.minimum_width, b.minimum_width);
    pairs.push_back(pair);
  }
  leave_behind([](const ContactPair&) { return true; });
  pairs_ = std::move(pairs);
  watches_.assign((pairs_.size() + PairWatch::size - 1) / PairWatch::size, {});
  for (std::size_t k = 0; k < pairs_.size(); ++k) watch(model, k);
  note_skin_poses(model, frames);
}

void ContactSet::note_skin_poses(const Model& model, std::span<const Frame> frames) {
  const Vec2 common = common_position(model, frames);
  skin_position_.resize(model.size()), skin_angle_.resize(model.size());
  for (std::size_t i = 0; i < model.size(); ++i) {
    skin_position_[i] = frames[i].position() - common;
    skin_angle_[i] = frames[i].angle;
  }
}

void ContactSet::watch(const Model& model, std::size_t k) {
  const ContactPair& pair = pairs_[k];
  PairWatch& w = watches_[k / PairWatch::size];
  const std::size_t lane = k % PairWatch::size;
  const Index small = smaller_of(model, pair.bodies);
  w.small[lane] = small, w.large[lane] = pair.bodies.a == small ? pair.bodies.b : pair.bodies.a;
  w.x[lane] = pair.seen_position.x, w.y[lane] = pair.seen_position.y, w.angle[lane] = pair.seen_angle;
  w.radius[lane] = model.bounding_radius[small];
  w.moved[lane] = 0.0;
  w.limit[lane] = refresh_ratio * reach_of(pair);
}

// Gives a pair two slots: two that were left, or new ones behind the others.
void ContactSet::enter(const Model& model, std::span<const Frame> frames, ContactPair& pair) {
  if (free_slots_.empty()) {
    pair.first_point = static_cast<Index>(points.size());
    points.resize(points.size() + 2);
  } else {
    pair.first_point = free_slots_.back();
    free_slots_.pop_back();
  }
  pair.active = true;
  ++entered_;
  write_points(model, frames, pair, {}, {});
}

void ContactSet::leave(ContactPair& pair) {
  pair.active = false;
  points.clear(pair.first_point, {}), points.clear(pair.first_point + 1, {});
  free_slots_.push_back(pair.first_point);
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
      points.clear(i, pair.bodies);
      continue;
    }
    Feature feature = pair.manifold.features[k];
    if (feature.kind == FeatureKind::corner_edge) feature.radius -= pair.setback;
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

// Bodies overlap by so much more before the pair bears.
void ContactSet::set_back(ContactPair& pair, double setback) {
  for (const std::size_t i : {pair.first_point + 0u, pair.first_point + 1u})
    points.set_back(i, setback - pair.setback);
  pair.setback = setback;
}

// Makes the springs of the pairs store that energy. Where it is less than their overlap asks for, the
// surfaces are set back, not the springs softened: a corner beyond the bond's points may overlap where they
// were relaxed, and must bear the next load as any other.
void ContactSet::take_over(std::span<const Frame> frames, std::span<ContactPair* const> pairs,
                           double energy) {
  const auto stored = [&] {
    double sum = 0.0;
    for (const ContactPair* pair : pairs) sum += energy_of(points, pair->first_point, frames);
    return sum;
  };
  const double now = stored();
  if (energy >= now) {
    for (ContactPair* pair : pairs) harden(*pair, pair->hardening * energy / now);
    return;
  }
  double least = 0.0, most = 0.0;
  for (const ContactPair* pair : pairs)
    for (const std::size_t i : {pair->first_point + 0u, pair->first_point + 1u})
      most = std::max(most, geometry_of(points, i, frames).overlap);
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (least + most);
    for (ContactPair* pair : pairs) set_back(*pair, middle);
    (stored() > energy ? least : most) = middle;
  }
}

// The contacts of two bodies whose face was joined until now: closed where they overlap, with relaxed
// friction springs.
void ContactSet::hand_over(std::span<const Frame> frames, const Heir& heir) {
  std::vector<ContactPair*> pairs;
  for (ContactPair& pair : pairs_)
    if (pair.active && pair.bodies == heir.bodies) pairs.push_back(&pair);
  double now = 0.0, taken = 0.0;
  for (const ContactPair* pair : pairs) now += energy_of(points, pair->first_point, frames);
  if (now == 0.0) return;
  take_over(frames, pairs, heir.energy);
  for (const ContactPair* pair : pairs) {
    for (const std::size_t i : {pair->first_point + 0u, pair->first_point + 1u}) {
      const PointGeometry g = geometry_of(points, i, frames);
      if (g.overlap > 0.0)
        points.set_history(i, history_with_slip(points, i, frames, points.history(i), 0.0));
    }
    taken += energy_of(points, pair->first_point, frames);
  }
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

// Returns whether any of its points was added, removed or replaced.
bool ContactSet::refresh(const Model& model, std::span<const Frame> frames, ContactPair& pair) {
  const Manifold old = pair.manifold;
  pair.manifold = find_manifold(model, frames, pair.colliders.a, pair.colliders.b, pair.margin, old);
  pair.gap = gap_of(pair.manifold, frames);
  const bool touches = pair.manifold.count > 0;
  if (touches && pair.active) return renew(model, frames, pair, old);
  if (touches == pair.active) return false;
  pair.hardening = 1.0, pair.setback = 0.0;
  touches ? enter(model, frames, pair) : leave(pair);
  return true;
}

// The points of a pair that stays, after another manifold was found.
bool ContactSet::renew(const Model& model, std::span<const Frame> frames, ContactPair& pair,
                       const Manifold& old) {
  // End k of the contact may have passed from one corner to another at the same place.
  const std::array<Memory, 2> kept = memory_of(points, pair.first_point);
  std::array<double, 2> slip{};
  for (Index k = 0; k < old.count; ++k) slip[k] = geometry_of(points, pair.first_point + k, frames).slip;
  const auto place = [&](Index k) { return place_of(points, pair.first_point + k, frames); };
  const std::array<Vec2, 2> old_place{place(0), place(old.count > 1 ? 1 : 0)};
  const double stored = energy_of(points, pair.first_point, frames);
  if (stored == 0.0) pair.hardening = 1.0;
  if (pair.setback > 0.0 && pair.gap > 0.0) pair.setback = 0.0;
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

// Closes the gaps between the slots and puts pairs far from touching last, so that they share blocks that can
// sleep: when a quarter of the slots are free, or were given out since the last time.
void ContactSet::compact_slots(std::span<const Frame> frames) {
  constexpr std::size_t part = 4;
  const std::size_t slots = points.size() / 2;
  if (part * free_slots_.size() <= slots && part * entered_ <= slots) return;
  for (std::size_t block = 0; block < points.blocks().size(); ++block) points.wake(block, frames);
  const ContactPoints old = std::exchange(points, ContactPoints(!points.rocking.empty()));
  std::size_t near = 0, far = old.size() - 2 * free_slots_.size();
  points.resize(far);
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    ContactPair& pair = pairs_[k];
    if (!pair.active) continue;
    const bool apart = pair.gap - moved(k) > sleeping_gap_;
    const std::size_t first = apart ? far -= 2 : near;
    near += apart ? 0 : 2;
    points.take_over(old, pair.first_point, first);
    pair.first_point = static_cast<Index>(first);
  }
  free_slots_.clear();
  entered_ = 0;
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
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const ContactPair& pair = pairs_[k];
    const bool apart = pair.gap - moved(k) > sleeping_gap_;
    if (pair.active && !(apart && points.open(pair.first_point) && points.open(pair.first_point + 1)))
      sleeps_[pair.first_point / PointBlock::size] = false;
  }
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    if (!sleeps_[k]) points.wake(k, frames);
    blocks[k].asleep = sleeps_[k] != 0;
  }
}

// Finds the manifolds of pairs that have moved since they were seen.
void ContactSet::refresh_moved(const Model& model, std::span<const Frame> frames) {
  best_kernels().measure_motions(watches_.data(), watches_.size(), frames.data());
  smallest_limit_ = refresh_ratio * smallest_margin_;
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const PairWatch& w = watches_[k / PairWatch::size];
    const std::size_t lane = k % PairWatch::size;
    if (w.moved[lane] > w.limit[lane]) look_at(model, frames, k);
    smallest_limit_ = std::min(smallest_limit_, w.limit[lane]);
  }
}

void ContactSet::look_at(const Model& model, std::span<const Frame> frames, std::size_t k) {
  ContactPair& pair = pairs_[k];
  const PairWatch& w = watches_[k / PairWatch::size];
  const Frame &large = frames[w.large[k % PairWatch::size]], &small = frames[w.small[k % PairWatch::size]];
  pair.seen_position = large.to_local(small.position()), pair.seen_angle = small.angle - large.angle;
  if (refresh(model, frames, pair)) disturb(pair.bodies);
  watch(model, k);
}

bool ContactSet::update(const Model& model, std::span<const Frame> frames) {
  if (!has_contacts_) return false;
  const std::size_t before = disturbed_.size();
  if (moved_beyond_skin(model, frames)) rebuild_pairs(model, frames);
  refresh_moved(model, frames);
  const bool changed = disturbed_.size() > before;
  if (changed) {
    compact_slots(frames);
    index_bodies(model.size());
  }
  for (const Heir& heir : heirs_) hand_over(frames, heir);
  heirs_.clear();
  put_blocks_to_sleep(frames);
  return changed;
}

std::vector<Index> ContactSet::take_disturbed() {
  for (PointBlock& block : points.blocks()) {
    if (!std::exchange(block.roused, false)) continue;
    disturbed_.insert(disturbed_.end(), block.a.begin(), block.a.end());
    disturbed_.insert(disturbed_.end(), block.b.begin(), block.b.end());
  }
  return std::exchange(disturbed_, {});
}

double ContactSet::longest_step(const Model& model, std::span<const Frame> frames) const {
  const double fastest = fastest_rim(model, frames);
  if (!has_contacts_) return std::numeric_limits<double>::infinity();
  return time_to_go(model, pairs_.empty() ? skin_travel * skin_ : margin_travel * smallest_margin_, fastest);
}

std::size_t ContactSet::steps_until_update(const Model& model, std::span<const Frame> frames,
                                           double h) const {
  const double allowed = 0.5 * smallest_limit_;
  const double steps = time_to_go(model, 0.5 * allowed, fastest_rim(model, frames)) / h;
  return std::max<std::size_t>(1,
                               static_cast<std::size_t>(std::min(steps, static_cast<double>(longest_wait))));
}

void ContactSet::gather_bodies(std::size_t begin, std::size_t end, std::span<const PairLoad> loads,
                               std::span<Vec2> forces, std::span<double> torques) const {
  for (std::size_t body = begin; body < end; ++body) {
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

void ContactSet::gather(std::span<const PairLoad> loads, std::span<Vec2> forces, std::span<double> torques,
                        Crew& crew) const {
  constexpr std::size_t share = 512;  // bodies
  crew.share_range(first_.size() - 1, share, [&](std::size_t begin, std::size_t end) {
    gather_bodies(begin, end, loads, forces, torques);
  });
}

}  // namespace dougong::engine
