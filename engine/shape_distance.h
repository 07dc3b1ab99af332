// How far a point lies outside of a shape.
#pragma once

#include "engine/shape.h"

namespace dougong::engine {

/// m, from a point in the shape's own frame to the nearest of the shape; 0 inside.
double distance_outside(const Shape& shape, Vec2 point);

}  // namespace dougong::engine
