#include "engine/collision/separation.h"

#include <algorithm>
#include <limits>

namespace dougong::engine {
namespace {

// The other polygon's placement as seen from the owner's frame.
struct Relative {
  Vec2 position;
  double c, s;
};

Relative seen_from(const Frame& owner, const Frame& other) {
  return {owner.to_local(other.position()), owner.c * other.c + owner.s * other.s,
          owner.c * other.s - owner.s * other.c};
}

// A direction of the owner's frame in the other's.
Vec2 turned_to_other(Vec2 n, const Relative& r) {
  return {r.c * n.x + r.s * n.y, r.c * n.y - r.s * n.x};
}

// Whether what the other turns to this edge is an inner edge: a compound is not touched from within, so two
// pieces cannot be pushed apart along it.
bool faces_inner_edge(const ConvexPolygon& owner, Index edge, const ConvexPolygon& other, const Relative& r) {
  if (!other.has_inner_edges()) return false;
  const Vec2 m = turned_to_other(owner.normal(edge), r);
  Index facing = 0;
  for (Index e = 1; e < other.size(); ++e)
    if (dot(other.normal(e), m) < dot(other.normal(facing), m)) facing = e;
  return other.is_inner(facing);
}

double lowest_vertex(const ConvexPolygon& owner, Index edge, const ConvexPolygon& other, const Relative& r) {
  const Vec2 n = owner.normal(edge);
  // Turn the normal into the other's frame once, instead of every vertex out of it.
  const Vec2 m = turned_to_other(n, r);
  double lowest = std::numeric_limits<double>::infinity();
  for (const Vec2 v : other.vertices()) lowest = std::min(lowest, dot(m, v));
  return lowest + dot(n, r.position - owner.vertex(edge));
}

}  // namespace

double separation_along(const ConvexPolygon& owner, const Frame& owner_frame, Index edge,
                        const ConvexPolygon& other, const Frame& other_frame) {
  return lowest_vertex(owner, edge, other, seen_from(owner_frame, other_frame));
}

Axis greatest_separation(const ConvexPolygon& owner, const Frame& owner_frame, const ConvexPolygon& other,
                         const Frame& other_frame) {
  const Relative r = seen_from(owner_frame, other_frame);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Axis best{-infinity, -infinity, 0};
  for (Index e = 0; e < owner.size(); ++e) {
    const double separation = lowest_vertex(owner, e, other, r);
    best.separation = std::max(best.separation, separation);
    if (separation <= best.outer || owner.is_inner(e) || faces_inner_edge(owner, e, other, r)) continue;
    best.outer = separation, best.edge = e;
  }
  return best;
}

}  // namespace dougong::engine
