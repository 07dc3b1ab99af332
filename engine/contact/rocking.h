// A measured loss in rocking: the couple by which a face resists the turning of a corner that comes down.
//
// A rigid block that rocks from one corner to the other keeps
//     omega+/omega- = [I + m (h^2 - b^2)] / [I + m (h^2 + b^2)]
// of its spin if the impact acts at the new corner alone (Housner, Bull. Seism. Soc. Am. 53 (1963) 403-417:
// 1 - 3/2 sin^2(alpha) for a rectangle). Tests find other ratios, most of them below (ElGawady et al.,
// Earthq. Eng. Struct. Dyn. 40 (2011)). Angular momentum about the new corner then needs a couple, which the
// face as a whole gives. For a corner with overlap d > 0 and rate d' > 0, relative spin w, face length L:
//     M = -C clamp(w L, -d', d')
// It vanishes with the approach, so a block that stands or turns about a corner does not feel it; it never
// drives; and it is of first degree in the velocities, so that the ratio does not depend on the speed of the
// impact. C follows from the ratio asked for by following one impact without weight (the limit of stiff
// contact).
#pragma once

#include <span>

#include "engine/contact/law.h"
#include "engine/frame.h"

namespace dougong::engine {

/// A block that comes down on the second corner of its face; the base does not move.
struct RockingImpact {
  double mass = 0.0, inertia = 0.0;        // kg, kg m2
  double half_length = 0.0, height = 0.0;  // m: b of the face, h of the centroid above it
  PointStiffness law;                      // of each corner
};

/// Housner's ratio of the spins after and before (-).
double housner_ratio(const RockingImpact& impact);
/// The ratio that the corners' springs and dashpots give with a couple of factor C (N s).
double velocity_ratio(const RockingImpact& impact, double couple);
/// C for which velocity_ratio() is the one asked for; 0 where it is that or less without a couple.
double couple_for_ratio(const RockingImpact& impact, double ratio);

/// Of one contact point; couple = 0: none.
struct RockingDashpot {
  double couple = 0.0;                         // N s, C
  double length = 0.0;                         // m, L
  double rate = 0.0;                           // 1/s, kn/cn
  double past_couple = 0.0, past_angle = 0.0;  // N m, rad, at the last committed poses
};

struct ContactPoints;
struct ContactTotals;
struct PointLoad;
/// Adds the couples to the loads, and what they take to the damping. As contact_forces().
void add_rocking_couples(ContactPoints& points, std::span<const Frame> frames, bool commit,
                         std::span<PointLoad> loads, ContactTotals& totals);

}  // namespace dougong::engine
