#include "engine/collision/collider.h"

#include <cmath>

namespace dougong::engine {
namespace {

// An edge lies on another when both its ends do, to this part of its length.
constexpr double coincidence = 1e-9;

bool lies_on(Vec2 point, Vec2 start, Vec2 end, double tolerance) {
  const Vec2 d = end - start;
  const double length = norm(d);
  const double along = dot(point - start, d) / length, off = cross(d, point - start) / length;
  return std::abs(off) <= tolerance && along >= -tolerance && along <= length + tolerance;
}

bool is_covered(Vec2 start, Vec2 end, const ConvexPolygon& other) {
  const double tolerance = coincidence * norm(end - start);
  for (std::size_t e = 0; e < other.size(); ++e)
    if (lies_on(start, other.vertex(e), other.vertex(e + 1), tolerance) &&
        lies_on(end, other.vertex(e), other.vertex(e + 1), tolerance))
      return true;
  return false;
}

std::vector<bool> inner_edges(std::size_t self, const std::vector<Collider>& pieces) {
  const auto& polygon = std::get<ConvexPolygon>(pieces[self].shape);
  std::vector<bool> inner(polygon.size());
  for (std::size_t e = 0; e < polygon.size(); ++e)
    for (std::size_t k = 0; k < pieces.size() && !inner[e]; ++k)
      if (const auto* other = std::get_if<ConvexPolygon>(&pieces[k].shape); other && k != self)
        inner[e] = is_covered(polygon.vertex(e), polygon.vertex(e + 1), *other);
  return inner;
}

Collider piece_of(const Part& part, Index owner) {
  Collider c;
  c.owner = owner;
  c.centre = part.position;
  const auto shape = std::visit([](const auto& s) -> Shape { return s; }, part.shape);
  c.radius = bounding_radius(shape);
  c.minimum_width = minimum_width(shape);
  if (const auto* circle = std::get_if<Circle>(&part.shape))
    c.shape = *circle;
  else if (part.position == Vec2{} && part.angle == 0.0)
    c.shape = std::get<ConvexPolygon>(part.shape);
  else
    c.shape = std::get<ConvexPolygon>(part.shape).moved(part.position, part.angle);
  return c;
}

std::vector<Collider> pieces_of(const Compound& compound, Index owner) {
  std::vector<Collider> pieces;
  for (const Part& part : compound.parts) pieces.push_back(piece_of(part, owner));
  std::vector<Collider> marked = pieces;
  for (std::size_t k = 0; k < pieces.size(); ++k)
    if (const auto* polygon = std::get_if<ConvexPolygon>(&pieces[k].shape))
      marked[k].shape = polygon->with_inner_edges(inner_edges(k, pieces));
  return marked;
}

}  // namespace

std::vector<Collider> colliders_of(const Shape& shape, Index owner) {
  if (const auto* compound = std::get_if<Compound>(&shape)) return pieces_of(*compound, owner);
  if (std::holds_alternative<HalfPlane>(shape))
    return {{owner, HalfPlane{}, {}, bounding_radius(shape), minimum_width(shape)}};
  if (const auto* circle = std::get_if<Circle>(&shape)) return {piece_of({*circle, {}, 0.0}, owner)};
  return {piece_of({std::get<ConvexPolygon>(shape), {}, 0.0}, owner)};
}

}  // namespace dougong::engine
