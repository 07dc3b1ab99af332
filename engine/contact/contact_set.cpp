#include "engine/contact/contact_set.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/contact/pair_energy.h"
#include "engine/contact/pair_points.h"
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

// Time in which what moves at `speed` and falls freely besides goes `way` (s).
double time_to_go(const Model& model, double way, double speed) {
  const double root = std::sqrt(speed * speed + 2.0 * norm(model.gravity) * way);
  return speed + root > 0.0 ? 2.0 * way / (speed + root) : std::numeric_limits<double>::infinity();
}

std::optional<double> damping_of(const std::vector<PairDamping>& tied, BodyPair bodies) {
  const auto found = std::ranges::lower_bound(tied, bodies, {}, &PairDamping::bodies);
  if (found == tied.end() || found->bodies != bodies) return {};
  return found->ratio;
}

}  // namespace

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

// What has another limit than before is looked at anew.
void ContactSet::limit_damping(std::vector<PairDamping> tied) {
  if (tied == tied_) return;
  const std::vector<PairDamping> before = std::exchange(tied_, std::move(tied));
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    if (damping_of(before, pairs_[k].bodies) == damping_of(tied_, pairs_[k].bodies)) continue;
    watches_[k / PairWatch::size].angle[k % PairWatch::size] = PairWatch::never;
  }
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
  w.first_point[lane] = pair.active ? pair.first_point : PairWatch::none;
  w.gap[lane] = pair.gap, w.moved[lane] = 0.0;
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
  pair.active = slots_changed_ = true;
  ++entered_;
  write_points(model, frames, law_of(pair), points, pair);
}

void ContactSet::leave(ContactPair& pair) {
  pair.active = false, slots_changed_ = true;
  points.clear(pair.first_point, {}), points.clear(pair.first_point + 1, {});
  free_slots_.push_back(pair.first_point);
}

void ContactSet::make_rigid(const Model& model, std::span<const Frame> frames, bool rigid) {
  if (rigid == rigid_) return;
  rigid_ = rigid;
  for (ContactPair& pair : pairs_)
    if (pair.active) write_points(model, frames, law_of(pair), points, pair);
}

PairLaw ContactSet::law_of(const ContactPair& pair) const {
  return {rigid_, damping_of(tied_, pair.bodies)};
}

// The contacts of two bodies whose face was joined until now.
void ContactSet::hand_over_to(const Heir& heir, std::span<const Frame> frames) {
  std::vector<ContactPair*> pairs;
  for (ContactPair& pair : pairs_)
    if (pair.active && pair.bodies == heir.bodies) pairs.push_back(&pair);
  inherited_ += hand_over(points, frames, pairs, heir.energy);
}

// Returns whether any of its points was added, removed or replaced.
bool ContactSet::refresh(const Model& model, std::span<const Frame> frames, ContactPair& pair) {
  const Manifold old = pair.manifold;
  pair.manifold = find_manifold(model, frames, pair.colliders.a, pair.colliders.b, pair.margin, old);
  pair.gap = gap_of(pair.manifold, frames);
  const bool touches = pair.manifold.count > 0;
  if (touches && pair.active) return renew_points(model, frames, law_of(pair), points, pair, old);
  if (touches == pair.active) return false;
  pair.hardening = 1.0, pair.setback = 0.0;
  touches ? enter(model, frames, pair) : leave(pair);
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
    watches_[k / PairWatch::size].first_point[k % PairWatch::size] = pair.first_point;
  }
  free_slots_.clear(), sleeps_.clear();
  entered_ = 0, slots_changed_ = true;
}

void ContactSet::index_bodies(std::size_t bodies) {
  // Counted two places ahead: writing the touches of a body moves its end to where the next one's begin.
  first_.assign(bodies + 2, 0);
  const auto each = [&](auto&& visit) {
    for (const PairWatch& w : watches_)
      for (std::size_t lane = 0; lane < PairWatch::size; ++lane) {
        if (w.first_point[lane] == PairWatch::none) continue;
        visit(std::min(w.large[lane], w.small[lane]), w.first_point[lane]);
        visit(std::max(w.large[lane], w.small[lane]), w.first_point[lane] + 1);
      }
  };
  each([&](Index body, Index) { ++first_[body + 2]; });
  for (std::size_t k = 2; k < first_.size(); ++k) first_[k] += first_[k - 1];
  touches_.resize(points.size());
  each([&](Index body, Index side) { touches_[first_[body + 1]++] = side; });
  first_.pop_back();
}

// Blocks of points that are open and cannot close before the next look are not evaluated until then.
void ContactSet::put_blocks_to_sleep(std::span<const Frame> frames) {
  const auto blocks = points.blocks();
  std::swap(slept_, sleeps_);
  slept_.resize(blocks.size(), false), sleeps_.assign(blocks.size(), !rigid_);
  for (const PairWatch& w : watches_)
    for (std::size_t lane = 0; lane < PairWatch::size; ++lane) {
      const Index first = w.first_point[lane];
      if (first == PairWatch::none) continue;
      const std::size_t block = first / PointBlock::size;
      const bool apart = w.gap[lane] - w.moved[lane] > sleeping_gap_;
      if (!(apart && (slept_[block] || (points.open(first) && points.open(first + 1)))))
        sleeps_[block] = false;
    }
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    if (sleeps_[k] == slept_[k]) continue;
    if (!sleeps_[k]) points.wake(k, frames);
    blocks[k].asleep = sleeps_[k] != 0;
  }
}

void ContactSet::measure_motions(std::span<const Frame> frames, Crew& crew) {
  constexpr std::size_t share = 256;  // of eight pairs
  seen_.resize(watches_.size());
  crew.share_range(watches_.size(), share, [&](std::size_t first, std::size_t last) {
    best_kernels().measure_motions(watches_.data() + first, last - first, frames.data());
    for (std::size_t k = first; k < last; ++k)
      seen_[k] = {watches_[k].smallest_limit(), watches_[k].any_beyond_limit()};
  });
}

// Finds the manifolds of pairs that have moved since they were seen.
void ContactSet::refresh_moved(const Model& model, std::span<const Frame> frames) {
  smallest_limit_ = refresh_ratio * smallest_margin_;
  for (std::size_t block = 0; block < watches_.size(); ++block) {
    if (seen_[block].beyond_limit) {
      const PairWatch& w = watches_[block];
      for (std::size_t lane = 0; lane < PairWatch::size; ++lane)
        if (w.moved[lane] > w.limit[lane]) look_at(model, frames, block * PairWatch::size + lane);
      seen_[block].smallest_limit = w.smallest_limit();
    }
    smallest_limit_ = std::min(smallest_limit_, seen_[block].smallest_limit);
  }
}

void ContactSet::look_at(const Model& model, std::span<const Frame> frames, std::size_t k) {
  ContactPair& pair = pairs_[k];
  const PairWatch& w = watches_[k / PairWatch::size];
  const Frame &large = frames[w.large[k % PairWatch::size]], &small = frames[w.small[k % PairWatch::size]];
  pair.seen_position = large.to_local(small.position()), pair.seen_angle = small.angle - large.angle;
  const bool other_law = pair.active && w.angle[k % PairWatch::size] == PairWatch::never;
  if (refresh(model, frames, pair) || other_law) disturb(pair.bodies);
  watch(model, k);
}

bool ContactSet::update(const Model& model, std::span<const Frame> frames, Crew& crew) {
  if (!has_contacts_) return false;
  const std::size_t before = disturbed_.size();
  if (moved_beyond_skin(model, frames)) rebuild_pairs(model, frames);
  measure_motions(frames, crew);
  refresh_moved(model, frames);
  const bool changed = disturbed_.size() > before;
  if (changed) compact_slots(frames);
  if (std::exchange(slots_changed_, false)) index_bodies(model.size());
  for (const Heir& heir : heirs_) hand_over_to(heir, frames);
  heirs_.clear();
  put_blocks_to_sleep(frames);
  return changed;
}

std::vector<Index> ContactSet::take_disturbed() {
  const bool any_roused = points.take_roused();
  for (PointBlock& block : points.blocks()) {
    if (!any_roused) break;
    if (!std::exchange(block.roused, false)) continue;
    disturbed_.insert(disturbed_.end(), block.a.begin(), block.a.end());
    disturbed_.insert(disturbed_.end(), block.b.begin(), block.b.end());
  }
  return std::exchange(disturbed_, {});
}

double ContactSet::longest_step(const Model& model, double speed) const {
  if (!has_contacts_) return std::numeric_limits<double>::infinity();
  return time_to_go(model, pairs_.empty() ? skin_travel * skin_ : margin_travel * smallest_margin_, speed);
}

std::size_t ContactSet::steps_until_update(const Model& model, double speed, double h) const {
  const double allowed = 0.5 * smallest_limit_;
  const double steps = time_to_go(model, 0.5 * allowed, speed) / h;
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
