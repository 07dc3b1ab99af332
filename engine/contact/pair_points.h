// The two contact points of a pair, written from its manifold: which features, which law, which memory.
#pragma once

#include <optional>
#include <span>

#include "engine/contact/contact_pair.h"

namespace dougong::engine {

/// What the points of a pair are made by, besides their manifold.
struct PairLaw {
  bool rigid = false;                  // without stiffness and dashpots
  std::optional<double> most_damping;  // of the damping ratio, where a bond damps the pair
};

/// The points of a pair that begins, at pair.first_point.
void write_points(const Model& model, std::span<const Frame> frames, const PairLaw& law,
                  ContactPoints& points, ContactPair& pair);

/// The points of a pair that stays, after another manifold was found in place of `old`: friction anchors
/// survive as long as their feature does, and pass on when one end of the contact changes hands between two
/// coinciding corners. Returns whether the features are others.
bool renew_points(const Model& model, std::span<const Frame> frames, const PairLaw& law,
                  ContactPoints& points, ContactPair& pair, const Manifold& old);

}  // namespace dougong::engine
