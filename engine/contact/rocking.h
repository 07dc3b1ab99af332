// A measured ratio of rocking: the couple between two faces when a corner comes down.
//
// A rigid block that rocks from one corner to the other keeps
//     omega+/omega- = [I + m (h^2 - b^2)] / [I + m (h^2 + b^2)]
// of its spin if the impact acts at the new corner alone (Housner, Bull. Seism. Soc. Am. 53 (1963) 403-417:
// 1 - 3/2 sin^2(alpha) for a rectangle). Tests find less on concrete and rubber (ElGawady et al., Earthq.
// Eng. Struct. Dyn. 40 (2011)) and more for granite (Pena et al., Earthq. Eng. Struct. Dyn. 36 (2007)).
// Angular momentum about the new corner then needs a couple, which the face as a whole gives. For a corner
// with overlap d > 0 and rate d' > 0, relative spin w, face length L, and a = max(0, d' - kn/cn d), what its
// dashpot bears beyond the spring:
//     less:  M = -C clamp(w L, -a, a), which resists the turning
//     more:  M = x cn a towards the middle: the impact acts x inside of the corner; no more than the dashpot
//            takes, so that both together never drive
// Either vanishes with the approach, so a block that stands or turns about a corner does not feel it, and is
// of first degree in the velocities, so that the ratio does not depend on the speed of the impact. C and x
// follow from the ratio asked for by following one impact without weight (the limit of stiff contact).
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

/// What a face does beyond its corners; one of the two is 0.
struct RockingLaw {
  double couple = 0.0;  // N s, C
  double inset = 0.0;   // m, x
};
/// The ratio that the corners' springs and dashpots give with it.
double velocity_ratio(const RockingImpact& impact, const RockingLaw& law);
/// The law for which velocity_ratio() is the one asked for; where none reaches that, the one that comes
/// nearest (x at most b, C at most what still changes anything).
RockingLaw law_for_ratio(const RockingImpact& impact, double ratio);

/// Of one contact point.
struct RockingDashpot {
  double couple = 0.0;   // N s, C
  double inset = 0.0;    // m, x: positive if its couple turns the corner's body counterclockwise
  double length = 0.0;   // m, L
  double rate = 0.0;     // 1/s, kn/cn
  double damping = 0.0;  // N s/m, cn
  double past_couple = 0.0, past_angle = 0.0;  // N m, rad, at the last committed poses

  bool acts() const { return couple != 0.0 || inset != 0.0; }
};

class ContactPoints;
struct ContactTotals;
struct PairLoad;
/// Adds the couples to the loads, and what they take to the damping. As contact_forces().
void add_rocking_couples(ContactPoints& points, std::span<const Frame> frames, bool commit,
                         std::span<PairLoad> loads, ContactTotals& totals);

}  // namespace dougong::engine
