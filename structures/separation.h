// How two convex shapes stand to each other: apart, touching over a patch, or overlapping.
//
//   gap = max over the separating directions n of  min_A(n) - max_B(n)
//
// The directions are the edge normals of both polygons (separating axis theorem) and, where a circle
// takes part, the line from its centre to the nearest corner. gap < 0 is the overlap depth and gap = 0
// a touch; a positive gap is exact between parallel faces and a lower bound between corners.
//
// Source: S. Gottschalk, M. C. Lin, D. Manocha, OBBTree, SIGGRAPH 1996 (separating axes).
#pragma once

#include <vector>

#include "engine/shape.h"

namespace dougong::structures {

/// A shape where it stands: corners anticlockwise, or a centre with a radius.
struct PlacedShape {
  std::vector<engine::Vec2> corners;  // m; the centre alone for a circle
  double radius = 0.0;                // m; 0 for a polygon
  engine::Vec2 low, high;             // m, bounding box
};

PlacedShape place(const engine::Shape& shape, engine::Vec2 position, double angle);

struct Separation {
  double gap = 0.0;       // m, < 0 is overlap
  engine::Vec2 normal;    // unit, from B to A
  engine::Vec2 from, to;  // m, ends of the patch where they face each other; equal for a corner
  bool facing = false;    // false: they pass each other, there is no patch
};

/// Corners closer than tolerance (m) to the supporting line count as lying on it.
Separation separation(const PlacedShape& a, const PlacedShape& b, double tolerance);

}  // namespace dougong::structures
