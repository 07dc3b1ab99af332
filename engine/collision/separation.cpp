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

double lowest_vertex(const ConvexPolygon& owner, Index edge, const ConvexPolygon& other, const Relative& r) {
  const Vec2 n = owner.normal(edge);
  // Turn the normal into the other's frame once, instead of every vertex out of it.
  const Vec2 m{r.c * n.x + r.s * n.y, r.c * n.y - r.s * n.x};
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
    if (separation > best.outer && !owner.is_inner(e)) best.outer = separation, best.edge = e;
  }
  return best;
}

}  // namespace dougong::engine
