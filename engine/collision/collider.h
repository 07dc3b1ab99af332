// A convex piece of a body or a terrain, in its owner's frame: what the collision code sees. Most owners have
// one; a compound has one for each part.
#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "engine/shape.h"

namespace dougong::engine {

using Index = std::uint32_t;

struct Collider {
  Index owner = 0;
  std::variant<Circle, ConvexPolygon, HalfPlane> shape;  // a polygon's vertices are in the owner's frame
  Vec2 centre;                                           // m, of the piece, in the owner's frame
  double radius = 0.0;                                   // m, of the bounding circle about the centre
  double minimum_width = 0.0;                            // m
};

/// The convex pieces of a shape.
std::vector<Collider> colliders_of(const Shape& shape, Index owner);

}  // namespace dougong::engine
