#include "structures/separation.h"

#include <algorithm>
#include <limits>

namespace dougong::structures {
namespace {

using engine::cross;
using engine::dot;
using engine::norm;
using engine::Vec2;

struct Interval {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

Interval extent(const PlacedShape& shape, Vec2 direction) {
  Interval interval;
  for (const Vec2 corner : shape.corners) interval.add(dot(corner, direction));
  return {interval.low - shape.radius, interval.high + shape.radius};
}

void add_edge_normals(const PlacedShape& shape, double sign, std::vector<Vec2>& directions) {
  const std::size_t n = shape.corners.size();
  if (n < 3) return;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 edge = shape.corners[(i + 1) % n] - shape.corners[i];
    directions.push_back((sign / norm(edge)) * Vec2{edge.y, -edge.x});
  }
}

/// The direction in which a circle parts from a corner, or from another circle's centre.
void add_centre_line(const PlacedShape& circle, const PlacedShape& other, double sign,
                     std::vector<Vec2>& directions) {
  if (circle.radius == 0.0) return;
  const Vec2 centre = circle.corners.front();
  const auto nearest = std::ranges::min_element(other.corners, {}, [&](Vec2 c) { return norm(c - centre); });
  const Vec2 line = centre - *nearest;
  if (norm(line) > 0.0) directions.push_back((sign / norm(line)) * line);
}

/// Candidate normals from B to A.
std::vector<Vec2> directions_between(const PlacedShape& a, const PlacedShape& b) {
  std::vector<Vec2> directions;
  add_edge_normals(b, 1.0, directions);
  add_edge_normals(a, -1.0, directions);
  add_centre_line(a, b, 1.0, directions);
  add_centre_line(b, a, -1.0, directions);
  if (directions.empty()) directions.push_back({0.0, 1.0});  // two circles about one centre
  return directions;
}

/// Where the side of a shape that looks along n lies, measured along the tangent t.
Interval side(const PlacedShape& shape, Vec2 n, Vec2 t, double tolerance) {
  const double reach = extent(shape, n).high - shape.radius - tolerance;
  Interval interval;
  for (const Vec2 corner : shape.corners)
    if (dot(corner, n) >= reach) interval.add(dot(corner, t));
  return interval;
}

void find_patch(const PlacedShape& a, const PlacedShape& b, double tolerance, Separation& result) {
  const Vec2 n = result.normal, t = engine::turned(n);
  const Interval on_a = side(a, -n, t, tolerance), on_b = side(b, n, t, tolerance);
  const double low = std::max(on_a.low, on_b.low), high = std::min(on_a.high, on_b.high);
  const double level = 0.5 * (extent(a, n).low + extent(b, n).high);
  result.facing = low <= high + tolerance;
  // An empty patch still has a place: midway between the two sides.
  const double middle = 0.5 * (low + high);
  result.from = level * n + (low <= high ? low : middle) * t;
  result.to = level * n + (low <= high ? high : middle) * t;
}

}  // namespace

PlacedShape place(const engine::Shape& shape, Vec2 position, double angle) {
  PlacedShape placed;
  if (const auto* circle = std::get_if<engine::Circle>(&shape)) {
    placed.corners = {position};
    placed.radius = circle->radius;
  } else if (std::holds_alternative<engine::HalfPlane>(shape)) {
    constexpr double far = 1e5;  // m, beyond any building
    for (const Vec2 corner : {Vec2{-far, -far}, Vec2{far, -far}, Vec2{far, 0.0}, Vec2{-far, 0.0}})
      placed.corners.push_back(position + engine::rotated(corner, angle));
  } else {
    for (const Vec2 vertex : std::get<engine::ConvexPolygon>(shape).vertices())
      placed.corners.push_back(position + engine::rotated(vertex, angle));
  }
  const Interval x = extent(placed, {1.0, 0.0}), y = extent(placed, {0.0, 1.0});
  placed.low = {x.low, y.low};
  placed.high = {x.high, y.high};
  return placed;
}

Separation separation(const PlacedShape& a, const PlacedShape& b, double tolerance) {
  Separation result;
  result.gap = -std::numeric_limits<double>::infinity();
  for (const Vec2 direction : directions_between(a, b)) {
    const double gap = extent(a, direction).low - extent(b, direction).high;
    if (gap <= result.gap) continue;
    result.gap = gap;
    result.normal = direction;
  }
  find_patch(a, b, tolerance, result);
  return result;
}

}  // namespace dougong::structures
