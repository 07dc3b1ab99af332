// Buildings put together: one on a floor of another, or one beside another.
//
// on      What stands on the ground in one of them stands on the level of the other, its own x = 0 at the
// place
//         given. Its blocks count in the storey of that level, but not in the level: a statue that falls is a
//         loss, not a storey.
// beside  Two neighbours with a gap between them that may close. Names get "A." on the left and "B." on the
//         right. Each keeps its ground, left and right of the middle of the gap, and storeys of its own: the
//         first storey of B stands on the ground.
#pragma once

#include "structures/building.h"

namespace dougong::structures {

/// The place on a building where another stands.
struct Place {
  std::size_t level = 1;  // from 1: the first floor above the ground
  double x = 0.0;         // m
};

/// Throws LayoutError (on.level, on.place, on.name) where there is no such level, no level face that carries
/// all of its feet, or where the item stands on terrain of its own or on isolators.
Building on(Building below, Building item, const Place& place);
/// gap in m, between the nearest blocks. Throws LayoutError (beside.gap) for a gap that is negative, and
/// (beside.resting_damping_ratio) for two that differ in it.
Building beside(Building left, Building right, double gap);

}  // namespace dougong::structures
