#include <algorithm>
#include <limits>
#include <stdexcept>

#include "engine/collision/collider.h"

namespace dougong::engine {
namespace {

// Parts may touch and overlap by this part of the smaller one's width.
constexpr double allowed_overlap = 1e-6;

double separation_from(const ConvexPolygon& a, const std::vector<Vec2>& points) {
  double best = -std::numeric_limits<double>::infinity();
  for (std::size_t e = 0; e < a.size(); ++e) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const Vec2 p : points) lowest = std::min(lowest, dot(a.normal(e), p - a.vertex(e)));
    best = std::max(best, lowest);
  }
  return best;
}

double distance_to_edges(const ConvexPolygon& polygon, Vec2 point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t e = 0; e < polygon.size(); ++e) {
    const Vec2 start = polygon.vertex(e), d = polygon.vertex(e + 1) - start;
    const double along = std::clamp(dot(point - start, d) / dot(d, d), 0.0, 1.0);
    nearest = std::min(nearest, norm(point - start - along * d));
  }
  return nearest;
}

double separation(const Collider& a, const Collider& b) {
  const auto* pa = std::get_if<ConvexPolygon>(&a.shape);
  const auto* pb = std::get_if<ConvexPolygon>(&b.shape);
  if (pa && pb) return std::max(separation_from(*pa, pb->vertices()), separation_from(*pb, pa->vertices()));
  if (!pa && !pb) return norm(a.centre - b.centre) - a.radius - b.radius;
  if (!pa) return separation(b, a);
  const double to_edges = distance_to_edges(*pa, b.centre);
  return (separation_from(*pa, {b.centre}) > 0.0 ? to_edges : -to_edges) - b.radius;
}

void require_apart(const std::vector<Part>& parts) {
  const std::vector<Collider> pieces = colliders_of(Compound{parts}, 0);
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::size_t j = i + 1; j < pieces.size(); ++j) {
      const double allowed = allowed_overlap * std::min(pieces[i].minimum_width, pieces[j].minimum_width);
      if (separation(pieces[i], pieces[j]) < -allowed)
        throw std::invalid_argument("parts " + std::to_string(i + 1) + " and " + std::to_string(j + 1) +
                                    " of a compound overlap: their mass would count twice");
    }
}

PlacedCompound about_centroid(std::vector<Part> parts) {
  double area = 0.0;
  Vec2 sum;
  for (const Part& part : parts) {
    const double a =
        std::visit([](const auto& shape) { return area_properties(Shape(shape)).area; }, part.shape);
    area += a;
    sum += a * part.position;
  }
  const Vec2 centroid = (1.0 / area) * sum;
  for (Part& part : parts) part.position -= centroid;
  return {{std::move(parts)}, centroid};
}

Part quadrilateral_under(Vec2 left, Vec2 right, double depth) {
  const Vec2 corners[] = {left, right, right - Vec2{0.0, depth}, left - Vec2{0.0, depth}};
  const PlacedPolygon placed = make_polygon(corners);
  return {placed.polygon, placed.centroid, 0.0};
}

}  // namespace

PlacedCompound make_compound(std::vector<Part> parts) {
  if (parts.empty()) throw std::invalid_argument("a compound needs at least one part");
  for (const Part& part : parts)
    if (!std::isfinite(part.position.x) || !std::isfinite(part.position.y) || !std::isfinite(part.angle))
      throw std::invalid_argument("a part of a compound has a position that is not finite");
  PlacedCompound placed = about_centroid(std::move(parts));
  require_apart(placed.compound.parts);
  return placed;
}

PlacedCompound make_polyline_ground(std::span<const Vec2> points, double depth) {
  if (points.size() < 2) throw std::invalid_argument("a ground line needs at least two points");
  if (!(depth > 0.0)) throw std::invalid_argument("a ground line needs a positive depth");
  std::vector<Part> parts;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (!(points[i + 1].x > points[i].x))
      throw std::invalid_argument("the points of a ground line must go to the right: point " +
                                  std::to_string(i + 2) + " does not");
    parts.push_back(quadrilateral_under(points[i], points[i + 1], depth));
  }
  return about_centroid(std::move(parts));
}

}  // namespace dougong::engine
