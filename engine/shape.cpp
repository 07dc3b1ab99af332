#include "engine/shape.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace dougong::engine {
namespace {

// Shorter than this part of the outline's extent is a repeated corner; flatter, a collinear one.
constexpr double corner_tolerance = 1e-12;
constexpr double infinity = std::numeric_limits<double>::infinity();

void require_finite(std::span<const Vec2> points) {
  for (const Vec2 p : points)
    if (!std::isfinite(p.x) || !std::isfinite(p.y))
      throw std::invalid_argument("polygon has a non-finite corner");
}

double extent(std::span<const Vec2> points) {
  double largest = 0.0;
  for (const Vec2 p : points) largest = std::max(largest, norm(p - points[0]));
  return largest;
}

double twice_signed_area(const std::vector<Vec2>& v) {
  double sum = 0.0;
  for (std::size_t i = 0; i < v.size(); ++i) sum += cross(v[i], v[(i + 1) % v.size()]);
  return sum;
}

bool is_spare(Vec2 before, Vec2 corner, Vec2 after, double size) {
  const Vec2 a = corner - before, b = after - corner;
  if (norm(a) <= corner_tolerance * size || norm(b) <= corner_tolerance * size) return true;
  return std::abs(cross(a, b)) <= corner_tolerance * norm(a) * norm(b) && dot(a, b) > 0.0;
}

// Removing a corner can make its neighbour spare in turn, so repeat until nothing changes.
std::vector<Vec2> without_spare_corners(std::vector<Vec2> v, double size) {
  for (bool changed = true; changed && v.size() >= 3;) {
    changed = false;
    for (std::size_t i = 0; i < v.size() && !changed; ++i) {
      const std::size_t n = v.size();
      if (!is_spare(v[(i + n - 1) % n], v[i], v[(i + 1) % n], size)) continue;
      v.erase(v.begin() + static_cast<std::ptrdiff_t>(i));
      changed = true;
    }
  }
  return v;
}

// Left turns everywhere and one full turn in all: a five-pointed star turns left too, but twice.
void require_convex(const std::vector<Vec2>& v) {
  double turning = 0.0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const Vec2 a = v[(i + 1) % v.size()] - v[i];
    const Vec2 b = v[(i + 2) % v.size()] - v[(i + 1) % v.size()];
    if (cross(a, b) <= 0.0) throw std::invalid_argument("polygon is not convex (or crosses itself)");
    turning += std::atan2(cross(a, b), dot(a, b));
  }
  if (turning > 3.0 * std::numbers::pi) throw std::invalid_argument("polygon crosses itself");
}

// Green's theorem about the origin of v: A = 1/2 sum c_i, x_c = 1/(6A) sum (v_i + v_(i+1)) c_i,
// J = 1/12 sum c_i (v_i.v_i + v_i.v_(i+1) + v_(i+1).v_(i+1)), c_i = v_i x v_(i+1).
Vec2 centroid_of(const std::vector<Vec2>& v) {
  Vec2 sum;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const Vec2 p = v[i], q = v[(i + 1) % v.size()];
    sum += cross(p, q) * (p + q);
  }
  return (1.0 / (3.0 * twice_signed_area(v))) * sum;
}

double second_moment_of(const std::vector<Vec2>& v) {
  double sum = 0.0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const Vec2 p = v[i], q = v[(i + 1) % v.size()];
    sum += cross(p, q) * (dot(p, p) + dot(p, q) + dot(q, q));
  }
  return sum / 12.0;
}

std::vector<Vec2> outward_normals(const std::vector<Vec2>& v) {
  std::vector<Vec2> normals;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const Vec2 e = v[(i + 1) % v.size()] - v[i];
    normals.push_back((1.0 / norm(e)) * Vec2{e.y, -e.x});
  }
  return normals;
}

double width_along(const ConvexPolygon& polygon, Vec2 direction) {
  double low = infinity, high = -infinity;
  for (const Vec2 v : polygon.vertices()) {
    low = std::min(low, dot(v, direction));
    high = std::max(high, dot(v, direction));
  }
  return high - low;
}

}  // namespace

PlacedPolygon make_polygon(std::span<const Vec2> points) {
  require_finite(points);
  if (points.size() < 3) throw std::invalid_argument("polygon needs at least three corners");
  const double size = extent(points);
  const Vec2 local_origin = points[0];
  std::vector<Vec2> v;
  for (const Vec2 p : points) v.push_back(p - local_origin);
  v = without_spare_corners(std::move(v), size);
  if (v.size() < 3) throw std::invalid_argument("polygon has no area");
  if (twice_signed_area(v) < 0.0) std::reverse(v.begin(), v.end());
  if (twice_signed_area(v) <= corner_tolerance * size * size)
    throw std::invalid_argument("polygon has no area");
  require_convex(v);

  const Vec2 centroid = centroid_of(v);
  for (Vec2& p : v) p -= centroid;
  PlacedPolygon placed;
  placed.polygon.normals_ = outward_normals(v);
  placed.polygon.vertices_ = std::move(v);
  placed.centroid = local_origin + centroid;
  return placed;
}

ConvexPolygon make_rectangle(double width, double height) {
  if (!(width > 0.0) || !(height > 0.0) || !std::isfinite(width) || !std::isfinite(height))
    throw std::invalid_argument("rectangle needs a positive width and height");
  const double a = 0.5 * width, b = 0.5 * height;
  const Vec2 corners[] = {{-a, -b}, {a, -b}, {a, b}, {-a, b}};
  return make_polygon(corners).polygon;
}

Circle make_circle(double radius) {
  if (!(radius > 0.0) || !std::isfinite(radius))
    throw std::invalid_argument("circle needs a positive radius");
  return {radius};
}

ConvexPolygon ConvexPolygon::moved(Vec2 position, double angle) const {
  ConvexPolygon result = *this;
  for (Vec2& v : result.vertices_) v = position + rotated(v, angle);
  for (Vec2& n : result.normals_) n = rotated(n, angle);
  return result;
}

ConvexPolygon ConvexPolygon::with_inner_edges(std::vector<bool> inner) const {
  ConvexPolygon result = *this;
  result.inner_ = std::move(inner);
  return result;
}

namespace {

AreaProperties area_of(const Circle& circle) {
  const double r2 = circle.radius * circle.radius;
  return {std::numbers::pi * r2, 0.5 * std::numbers::pi * r2 * r2};
}

AreaProperties area_of(const ConvexPolygon& polygon) {
  return {0.5 * twice_signed_area(polygon.vertices()), second_moment_of(polygon.vertices())};
}

AreaProperties area_of(const HalfPlane&) {
  return {infinity, infinity};
}

AreaProperties area_of(const Part& part) {
  return std::visit([](const auto& shape) { return area_of(shape); }, part.shape);
}

// Steiner's theorem: every part turns about the common centroid.
AreaProperties area_of(const Compound& compound) {
  AreaProperties sum;
  for (const Part& part : compound.parts) {
    const AreaProperties a = area_of(part);
    sum.area += a.area;
    sum.second_moment += a.second_moment + a.area * dot(part.position, part.position);
  }
  return sum;
}

double radius_of(const Circle& circle) {
  return circle.radius;
}

double radius_of(const ConvexPolygon& polygon) {
  double largest = 0.0;
  for (const Vec2 v : polygon.vertices()) largest = std::max(largest, norm(v));
  return largest;
}

double radius_of(const HalfPlane&) {
  return infinity;
}

double radius_of(const Compound& compound) {
  double largest = 0.0;
  for (const Part& part : compound.parts) {
    const double own = std::visit([](const auto& shape) { return radius_of(shape); }, part.shape);
    largest = std::max(largest, norm(part.position) + own);
  }
  return largest;
}

double width_of(const Circle& circle) {
  return 2.0 * circle.radius;
}

double width_of(const ConvexPolygon& polygon) {
  double smallest = infinity;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    smallest = std::min(smallest, width_along(polygon, polygon.normal(i)));
  return smallest;
}

double width_of(const HalfPlane&) {
  return infinity;
}

double width_of(const Compound& compound) {
  double smallest = infinity;
  for (const Part& part : compound.parts)
    smallest = std::min(smallest, std::visit([](const auto& shape) { return width_of(shape); }, part.shape));
  return smallest;
}

}  // namespace

AreaProperties area_properties(const Shape& shape) {
  return std::visit([](const auto& s) { return area_of(s); }, shape);
}

MassProperties mass_properties(const Shape& shape, double density, double thickness) {
  const AreaProperties area = area_properties(shape);
  return {density * thickness * area.area, density * thickness * area.second_moment};
}

double bounding_radius(const Shape& shape) {
  return std::visit([](const auto& s) { return radius_of(s); }, shape);
}

double minimum_width(const Shape& shape) {
  return std::visit([](const auto& s) { return width_of(s); }, shape);
}

}  // namespace dougong::engine
