#include "engine/contact/pair_points.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/contact/pair_energy.h"
#include "engine/contact/stiffness.h"

namespace dougong::engine {
namespace {

// A pair whose points are being written, and what by.
struct Writing {
  const Model& model;
  std::span<const Frame> frames;
  const PairLaw& law;
  ContactPoints& points;
  ContactPair& pair;

  std::size_t point(Index k) const { return pair.first_point + k; }
};

// What a point keeps while its feature stays.
struct Memory {
  PointHistory history;
  PointPast past;
  RockingDashpot rocking;
};

Memory memory_of(const ContactPoints& points, std::size_t i) {
  return {points.history(i), points.past(i), points.rocking.empty() ? RockingDashpot{} : points.rocking[i]};
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

PointStiffness stiffness_of(const Writing& w, const Feature& feature, double length) {
  if (!w.law.rigid)
    return point_stiffness(w.model, w.frames, w.pair.manifold, feature, length, w.pair.bodies,
                           w.law.most_damping);
  PointStiffness rigid;
  rigid.friction = w.model.rule(w.pair.bodies.a, w.pair.bodies.b).friction_coefficient;
  return rigid;
}

void write_point(const Writing& w, Index k) {
  const auto [a, b] = w.pair.bodies;
  if (k >= w.pair.manifold.count) return w.points.clear(w.point(k), w.pair.bodies);
  const double width = std::min(w.model.minimum_width[a], w.model.minimum_width[b]);
  Feature feature = w.pair.manifold.features[k];
  if (feature.kind == FeatureKind::corner_edge) feature.radius -= w.pair.setback;
  const BearingLength length =
      w.law.rigid ? BearingLength{} : bearing_of(w.model, w.frames, w.pair.manifold, feature);
  const PointStiffness law = stiffness_of(w, feature, 1.0 / length.per_reference);
  w.points.set(w.point(k), w.pair.bodies, feature, length, hardened(law, w.pair.hardening), width);
  w.points.start(w.point(k), w.frames);
}

void recall(const Writing& w, Index k, const Memory& kept) {
  const std::size_t i = w.point(k);
  w.points.set_history(i, kept.history), w.points.set_past(i, kept.past);
  if (!w.points.rocking.empty()) w.points.rocking[i] = kept.rocking;
}

// The couple of a face that rocks; it is found anew when the length of contact has changed.
void find_rocking_law(const Writing& w, double ratio) {
  constexpr double same_length = 1e-3;
  const Manifold& m = w.pair.manifold;
  if (std::abs(m.length - w.pair.rocking_length) <= same_length * m.length) return;
  const PointStiffness law = w.points.stiffness(w.pair.first_point);
  w.pair.rocking = law_for_ratio(rocking_impact(w.model, m, w.pair.bodies, law), ratio);
  w.pair.rocking_length = m.length;
}

// A face with two corners can rock.
void write_rocking(const Writing& w) {
  if (w.points.rocking.empty()) return;
  const Manifold& m = w.pair.manifold;
  const auto ratio = w.model.rule(w.pair.bodies.a, w.pair.bodies.b).rocking_restitution;
  const bool rocks = ratio && !w.law.most_damping && m.count == 2 && m.length > 0.0;
  if (rocks) find_rocking_law(w, *ratio);
  for (const Index k : {0, 1}) {
    const std::size_t i = w.point(k);
    RockingDashpot& dashpot = w.points.rocking[i];
    if (!dashpot.acts())
      dashpot.past_angle = w.frames[w.points.corner_body[i]].angle - w.frames[w.points.edge_body[i]].angle;
    const PointStiffness law = w.points.stiffness(i);
    dashpot.couple = rocks ? w.pair.rocking.couple : 0.0;
    dashpot.inset = rocks ? inward_turn(w.points, i, w.point(1 - k), w.frames) * w.pair.rocking.inset : 0.0;
    dashpot.length = m.length;
    if (rocks) dashpot.rate = law.normal / law.normal_damping, dashpot.damping = law.normal_damping;
  }
}

// What an end of the contact was before its pair was written anew.
struct End {
  Memory kept;
  double slip = 0.0;  // m
  Vec2 place;         // m
};

End end_of(const Writing& w, Index k, const Manifold& old) {
  const std::size_t i = w.point(k);
  const double slip = k < old.count ? geometry_of(w.points, i, w.frames).slip : 0.0;
  return {memory_of(w.points, i), slip, place_of(w.points, old.count > 1 ? i : w.pair.first_point, w.frames)};
}

// End k of the contact may have passed from one corner to another at the same place.
void pass_on(const Writing& w, Index k, const Manifold& old, const End& end) {
  const auto identity = w.pair.manifold.features[k].identity;
  if (identity == old.features[0].identity || (old.count > 1 && identity == old.features[1].identity)) return;
  const std::size_t i = w.point(k);
  if (end.kept.history.open || norm(place_of(w.points, i, w.frames) - end.place) > 2.0 * w.pair.margin)
    return;
  // Corner and edge may have changed sides: both the tangent and the motion turn round, so slip stays.
  w.points.set_history(i, history_with_slip(w.points, i, w.frames, end.kept.history, end.slip));
}

}  // namespace

void write_points(const Model& model, std::span<const Frame> frames, const PairLaw& law,
                  ContactPoints& points, ContactPair& pair) {
  const Writing w{model, frames, law, points, pair};
  for (const Index k : {0u, 1u}) write_point(w, k);
  write_rocking(w);
}

bool renew_points(const Model& model, std::span<const Frame> frames, const PairLaw& law,
                  ContactPoints& points, ContactPair& pair, const Manifold& old) {
  const Writing w{model, frames, law, points, pair};
  const std::array<End, 2> ends{end_of(w, 0, old), end_of(w, 1, old)};
  const double stored = stored_energy(points, pair.first_point, frames);
  if (stored == 0.0) pair.hardening = 1.0;
  if (pair.setback > 0.0 && pair.gap > 0.0) pair.setback = 0.0;
  for (const Index k : {0u, 1u}) {
    write_point(w, k);
    for (Index l = 0; k < pair.manifold.count && l < old.count; ++l)
      if (old.features[l].identity == pair.manifold.features[k].identity) recall(w, k, ends[l].kept);
  }
  write_rocking(w);
  keep_energy(points, frames, pair, stored);
  if (same_features(old, pair.manifold)) return false;
  for (Index k = 0; k < std::min(old.count, pair.manifold.count); ++k) pass_on(w, k, old, ends[k]);
  return true;
}

}  // namespace dougong::engine
