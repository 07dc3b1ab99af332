// The convex outlines of a block where it stands: one, or one for each part of a compound.
#pragma once

#include <vector>

#include "engine/shape.h"
#include "structures/separation.h"

namespace dougong::structures {

using Outline = std::vector<engine::Vec2>;  // m, corners anticlockwise

/// A circle as the regular polygon of 48 corners in it: 0.2 % of its radius within it at most. None for a
/// half plane, which is no block.
std::vector<Outline> outlines(const engine::Shape& shape, engine::Vec2 position, double angle);

/// A box along the axes (m).
struct Extent {
  engine::Vec2 low, high;
  double width() const { return high.x - low.x; }
  double height() const { return high.y - low.y; }
};
/// Around points, or around two boxes. Of no points: both corners at the origin.
Extent extent_of(const Outline& points);
Extent joined(const Extent& a, const Extent& b);

/// For separation().
PlacedShape placed(const Outline& outline);

}  // namespace dougong::structures
