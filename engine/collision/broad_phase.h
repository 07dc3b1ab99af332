// Broad phase: which pairs can meet while nothing moves further than half the skin.
//
// Two sieves for every candidate: bounding circles, then axis-aligned boxes, both grown by the skin.
// Candidates come from a uniform grid filled by a counting sort; shapes larger than a cell (a ground, a
// long slab, a half-plane) are tested against everything. Pairs of two terrains, or of two parts of one body,
// are never made.
#pragma once

#include <vector>

#include "engine/frame.h"

namespace dougong::engine {

struct BodyPair {
  Index a = 0, b = 0;  // a < b
  friend auto operator<=>(const BodyPair&, const BodyPair&) = default;
};

/// The most damping ratio that the contacts of two bodies have.
struct PairDamping {
  BodyPair bodies;
  double ratio = 0.0;  // -
  friend bool operator==(const PairDamping&, const PairDamping&) = default;
};

/// Sorted pairs of colliders (indices into Model::colliders) that are within `skin` of each other, and some
/// that are not quite.
std::vector<BodyPair> find_pairs(const Model& model, std::span<const Frame> frames, double skin);

}  // namespace dougong::engine
