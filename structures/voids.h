// The spaces that remain under what stands and what fell: where someone may survive.
//
// The plane is divided into square cells. A cell is a void when it is empty and something lies above it. A
// space is a set of voids that share edges; it counts when a circle of a given diameter fits into it, clear
// of blocks, of the ground and of what is open to the sky. Sizes are known to a cell or two.
//
// The diameter of the largest circle is twice the greatest distance of a void from the nearest cell that is
// none: an exact Euclidean distance transform (P. F. Felzenszwalb, D. P. Huttenlocher, Distance transforms of
// sampled functions, Theory of Computing 8, 2012, 415-428).
#pragma once

#include <vector>

#include "structures/outline.h"

namespace dougong::structures {

/// The width that a crouching person needs; the usual 0.5 m of rescue practice is a convention.
inline constexpr double void_diameter = 0.5;  // m

struct Void {
  double area = 0.0;      // m2
  double diameter = 0.0;  // m, of the largest circle in it
  engine::Vec2 middle;    // m, of that circle
};

/// Largest circle first. `within`: where to look; its lower edge is the ground. Cells are a tenth of
/// void_diameter wide, larger where the box would hold more than four million of them.
std::vector<Void> voids(const std::vector<Outline>& blocks, const Extent& within);

}  // namespace dougong::structures
