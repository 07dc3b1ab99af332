// Separating axes of two convex polygons (the separating-axis theorem).
//
//   s(e) = min over vertices v of the other polygon of n_e . (v - p_e)
//
// n_e the outward normal of edge e. The polygons are apart when some s(e) > 0; the greatest s(e) is
// the depth of the overlap (negative) or a lower bound of the distance.
#pragma once

#include "engine/frame.h"

namespace dougong::engine {

struct Axis {
  double separation = 0.0;  // m, the greatest of all edges
  double outer = 0.0;       // m, the greatest of those that can be touched
  Index edge = 0;           // that one
};

/// The edge of `owner` with the greatest separation from `other`.
Axis greatest_separation(const ConvexPolygon& owner, const Frame& owner_frame, const ConvexPolygon& other,
                         const Frame& other_frame);
/// The separation along one given edge of `owner`.
double separation_along(const ConvexPolygon& owner, const Frame& owner_frame, Index edge,
                        const ConvexPolygon& other, const Frame& other_frame);

}  // namespace dougong::engine
