// A pair of colliders that can meet: its manifold, and where its contact points are.
#pragma once

#include "engine/collision/broad_phase.h"
#include "engine/contact/contact_points.h"
#include "engine/contact/pair_watch.h"

namespace dougong::engine {

struct ContactPair {
  BodyPair colliders;
  BodyPair bodies;      // their owners, a < b
  double margin = 0.0;  // m
  Manifold manifold;
  double gap = 0.0;        // m, when the manifold was found
  Index first_point = 0;   // of two, if active
  bool active = false;     // within the margin
  double hardening = 1.0;  // of its springs, so that they store what those before them did (keep_energy)
  double setback = 0.0;    // m, of its surfaces: overlap that was there when a bond let go (hand_over)
  // The couple of the pair's rocking restitution, and the length of contact it was found for.
  RockingLaw rocking;
  double rocking_length = -1.0;  // m
  // Pose of the smaller body in the larger one's frame when the manifold was found.
  Vec2 seen_position;
  double seen_angle = PairWatch::never;
};

}  // namespace dougong::engine
