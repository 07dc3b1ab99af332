#include "engine/shape_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dougong::engine {
namespace {

double distance_to_segment(Vec2 point, Vec2 from, Vec2 to) {
  const Vec2 along = to - from;
  const double part = std::clamp(dot(point - from, along) / dot(along, along), 0.0, 1.0);
  return norm(point - from - part * along);
}

double outside(const Circle& circle, Vec2 point) {
  return std::max(0.0, norm(point) - circle.radius);
}

double outside(const HalfPlane&, Vec2 point) {
  return std::max(0.0, point.y);
}

double outside(const ConvexPolygon& polygon, Vec2 point) {
  bool inside = true;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    inside = inside && dot(polygon.normal(i), point - polygon.vertex(i)) <= 0.0;
    nearest = std::min(nearest, distance_to_segment(point, polygon.vertex(i), polygon.vertex(i + 1)));
  }
  return inside ? 0.0 : nearest;
}

double outside(const Compound& compound, Vec2 point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Part& part : compound.parts) {
    const Vec2 local = rotated(point - part.position, -part.angle);
    nearest =
        std::min(nearest, std::visit([&](const auto& shape) { return outside(shape, local); }, part.shape));
  }
  return nearest;
}

}  // namespace

double distance_outside(const Shape& shape, Vec2 point) {
  return std::visit([&](const auto& kind) { return outside(kind, point); }, shape);
}

}  // namespace dougong::engine
