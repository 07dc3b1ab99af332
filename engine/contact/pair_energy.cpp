#include "engine/contact/pair_energy.h"

#include <algorithm>
#include <cmath>

namespace dougong::engine {
namespace {

void harden(ContactPoints& points, ContactPair& pair, double hardening) {
  constexpr double most = 1e4;  // a sliver of 1:100 that goes over from its end to its side
  hardening = std::clamp(hardening, 1.0 / most, most);
  for (const Index k : {0, 1}) {
    const std::size_t i = pair.first_point + k;
    points.set_stiffness(i, hardened(points.stiffness(i), hardening / pair.hardening));
  }
  pair.hardening = hardening;
}

// Bodies overlap by so much more before the pair bears.
void set_back(ContactPoints& points, ContactPair& pair, double setback) {
  for (const std::size_t i : {pair.first_point + 0u, pair.first_point + 1u})
    points.set_back(i, setback - pair.setback);
  pair.setback = setback;
}

double stored_in(const ContactPoints& points, std::span<const Frame> frames,
                 std::span<ContactPair* const> pairs) {
  double sum = 0.0;
  for (const ContactPair* pair : pairs) sum += stored_energy(points, pair->first_point, frames);
  return sum;
}

// Makes the springs of the pairs store that energy. Where it is less than their overlap asks for, the
// surfaces are set back, not the springs softened: a corner beyond the bond's points may overlap where they
// were relaxed, and must bear the next load as any other.
void take_over(ContactPoints& points, std::span<const Frame> frames, std::span<ContactPair* const> pairs,
               double energy) {
  const double now = stored_in(points, frames, pairs);
  if (energy >= now) {
    for (ContactPair* pair : pairs) harden(points, *pair, pair->hardening * energy / now);
    return;
  }
  double least = 0.0, most = 0.0;
  for (const ContactPair* pair : pairs)
    for (const std::size_t i : {pair->first_point + 0u, pair->first_point + 1u})
      most = std::max(most, geometry_of(points, i, frames).overlap);
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (least + most);
    for (ContactPair* pair : pairs) set_back(points, *pair, middle);
    (stored_in(points, frames, pairs) > energy ? least : most) = middle;
  }
}

}  // namespace

PointStiffness hardened(PointStiffness law, double factor) {
  law.normal *= factor, law.tangential *= factor;
  law.normal_damping *= std::sqrt(factor), law.tangential_damping *= std::sqrt(factor);
  return law;
}

double stored_energy(const ContactPoints& points, std::size_t first, std::span<const Frame> frames) {
  double energy = 0.0;
  for (const std::size_t i : {first, first + 1}) {
    const PointGeometry g = geometry_of(points, i, frames);
    if (g.overlap > 0.0) energy += 0.5 * law_at(points, i, g).normal * g.overlap * g.overlap;
  }
  return energy;
}

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

void keep_energy(ContactPoints& points, std::span<const Frame> frames, ContactPair& pair, double stored) {
  constexpr double rounding = 1e-9;
  const double now = stored_energy(points, pair.first_point, frames);
  if (stored == 0.0 || now == 0.0 || std::abs(stored / now - 1.0) < rounding) return;
  harden(points, pair, pair.hardening * stored / now);
}

double hand_over(ContactPoints& points, std::span<const Frame> frames, std::span<ContactPair* const> pairs,
                 double energy) {
  if (stored_in(points, frames, pairs) == 0.0) return 0.0;
  take_over(points, frames, pairs, energy);
  for (const ContactPair* pair : pairs)
    for (const std::size_t i : {pair->first_point + 0u, pair->first_point + 1u}) {
      const PointGeometry g = geometry_of(points, i, frames);
      if (g.overlap > 0.0)
        points.set_history(i, history_with_slip(points, i, frames, points.history(i), 0.0));
    }
  return std::min(stored_in(points, frames, pairs), energy);
}

}  // namespace dougong::engine
