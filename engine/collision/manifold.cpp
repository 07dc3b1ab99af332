#include "engine/collision/manifold.h"

#include <algorithm>
#include <limits>

#include "engine/collision/separation.h"

namespace dougong::engine {
namespace {

// identity: which body owns the corner (1 bit), its number, the number of the edge. 31 bits each.
std::uint64_t identity_of(bool corner_of_b, Index corner, Index edge) {
  return (static_cast<std::uint64_t>(corner_of_b) << 62) | (static_cast<std::uint64_t>(corner) << 31) | edge;
}

const ConvexPolygon& polygon_of(const Model& model, Index collider) {
  return std::get<ConvexPolygon>(model.colliders[collider].shape);
}

bool was_feature(const Manifold& previous, std::uint64_t identity) {
  for (Index i = 0; i < previous.count; ++i)
    if (previous.features[i].identity == identity) return true;
  return false;
}

struct Pair {
  const Model& model;
  std::span<const Frame> frames;
  Index a, b;  // colliders
  double margin;
  const Manifold& previous;

  Index other(Index collider) const { return collider == a ? b : a; }
  Index owner(Index collider) const { return model.colliders[collider].owner; }
  const Frame& frame(Index collider) const { return frames[owner(collider)]; }
};

double distance_to_face(const Pair& pair, Index collider, Index edge) {
  const ConvexPolygon& polygon = polygon_of(pair.model, collider);
  return std::max(0.0,
                  dot(polygon.normal(edge), polygon.vertex(edge) - pair.model.colliders[collider].centre));
}

double separation_of(const Pair& pair, ReferenceEdge r) {
  const Index other = pair.other(r.owner);
  return separation_along(polygon_of(pair.model, r.owner), pair.frame(r.owner), r.edge,
                          polygon_of(pair.model, other), pair.frame(other));
}

Vec2 normal_of(const Pair& pair, ReferenceEdge r) {
  return pair.frame(r.owner).turned_to_world(polygon_of(pair.model, r.owner).normal(r.edge));
}

// How much worse one axis may be than another and still count as good: a tenth of the margin if they are
// parallel, as those of two faces that lie on each other; next to nothing if they are tilted, where a corner
// passes another: what the worse one has in common with the other shape may end before the better one's.
double tie_of(const Pair& pair, ReferenceEdge one, ReferenceEdge other) {
  constexpr double of_faces = 0.1, of_corners = 0.001, tilted = 0.25;  // rad
  const double tilt = cross(normal_of(pair, one), normal_of(pair, other)) / tilted;
  return pair.margin * std::max(of_corners, of_faces * (1.0 - tilt * tilt));
}

struct References {
  double separation;           // m, of the polygons
  ReferenceEdge best, chosen;  // of greatest separation; the previous one if that is as good
};

References choose_references(const Pair& pair) {
  const auto& pa = polygon_of(pair.model, pair.a);
  const auto& pb = polygon_of(pair.model, pair.b);
  const Frame &fa = pair.frame(pair.a), &fb = pair.frame(pair.b);
  const Axis best_a = greatest_separation(pa, fa, pb, fb);
  const Axis best_b = greatest_separation(pb, fb, pa, fa);
  const ReferenceEdge of_a{pair.a, best_a.edge, true}, of_b{pair.b, best_b.edge, true};
  const ReferenceEdge first = best_b.outer > best_a.outer + tie_of(pair, of_a, of_b) ? of_b : of_a;
  const ReferenceEdge previous = pair.previous.reference;
  const double outer = std::max(best_a.outer, best_b.outer);
  const bool kept = previous.known && separation_of(pair, previous) > outer - tie_of(pair, previous, first);
  return {std::max(best_a.separation, best_b.separation), best_b.outer > best_a.outer ? of_b : of_a,
          kept ? previous : first};
}

Index facing_edge(const ConvexPolygon& polygon, Vec2 local_direction) {
  Index best = 0;
  double lowest = std::numeric_limits<double>::infinity();
  for (Index e = 0; e < polygon.size(); ++e) {
    const double d = dot(polygon.normal(e), local_direction);
    if (d < lowest && !polygon.is_inner(e)) lowest = d, best = e;
  }
  return best;
}

double edge_length(const ConvexPolygon& polygon, Index edge) {
  return norm(polygon.vertex(edge + 1) - polygon.vertex(edge));
}

// The corner is the start or the end of its own edge, which runs against the other.
Feature corner_against_edge(const Pair& pair, Index corner_piece, Index own_edge, bool at_end, Index edge) {
  const Index corner = own_edge + (at_end ? 1 : 0);
  const Index edge_piece = pair.other(corner_piece);
  const auto& corners = polygon_of(pair.model, corner_piece);
  const auto& edges = polygon_of(pair.model, edge_piece);
  Feature f;
  f.corner_body = pair.owner(corner_piece);
  f.edge_body = pair.owner(edge_piece);
  f.corner = corners.vertex(corner);
  f.edge_point = edges.vertex(edge);
  f.edge_normal = edges.normal(edge);
  f.identity = identity_of(corner_piece == pair.b, corner % static_cast<Index>(corners.size()), edge);
  f.edge_length = edge_length(edges, edge);
  f.facing = (at_end ? 1.0 : -1.0) * edge_length(corners, own_edge);
  return f;
}

Vec2 normal_of_edge(const Pair& pair, const Feature& f) {
  return pair.frames[f.edge_body].turned_to_world(f.edge_normal);
}

// One end of the clipped interval: the corner further in. Where both coincide, whichever it was: within the
// margin if the faces are parallel, so that both overlap alike, and less the more they are tilted.
Feature end_feature(const Pair& pair, const Feature& reference_corner, const Feature& incident_corner,
                    double reference_is_further_in_by) {
  constexpr double parallel = 0.01;  // rad
  const double tilt =
      std::abs(cross(normal_of_edge(pair, reference_corner), normal_of_edge(pair, incident_corner)));
  if (std::abs(reference_is_further_in_by) * std::max(tilt, parallel) <= parallel * pair.margin) {
    if (was_feature(pair.previous, reference_corner.identity)) return reference_corner;
    if (was_feature(pair.previous, incident_corner.identity)) return incident_corner;
  }
  return reference_is_further_in_by > 0.0 ? reference_corner : incident_corner;
}

// Whether the piece beyond this end of the edge continues its face, or bends it.
bool is_seam(const ConvexPolygon& polygon, Index edge, bool at_end) {
  const auto size = static_cast<Index>(polygon.size());
  return polygon.is_inner((edge + (at_end ? 1 : size - 1)) % size);
}

Manifold clip(const Pair& pair, ReferenceEdge reference) {
  const Index owner = reference.owner, other = pair.other(owner);
  const auto& ref = polygon_of(pair.model, owner);
  const auto& inc = polygon_of(pair.model, other);
  const Frame &ref_frame = pair.frame(owner), &inc_frame = pair.frame(other);
  const Vec2 n = ref_frame.turned_to_world(ref.normal(reference.edge));
  const Index incident = facing_edge(inc, inc_frame.turned_to_local(n));

  // Along the reference edge, which runs with the tangent; the incident edge runs against it.
  const Vec2 start = ref_frame.to_world(ref.vertex(reference.edge));
  const Vec2 tangent = turned(n);
  const auto along = [&](Vec2 world) { return dot(tangent, world - start); };
  const double ref_low = 0.0, ref_high = along(ref_frame.to_world(ref.vertex(reference.edge + 1)));
  const double inc_low = along(inc_frame.to_world(inc.vertex(incident + 1)));
  const double inc_high = along(inc_frame.to_world(inc.vertex(incident)));

  Manifold m;
  m.reference = reference;
  m.length = std::min(ref_high, inc_high) - std::max(ref_low, inc_low);
  if (m.length <= 0.0) return m;
  m.count = 2;
  // The incident edge runs against the tangent: its end is the low one.
  m.at_seam = (ref_low > inc_low ? is_seam(ref, reference.edge, false) : is_seam(inc, incident, true)) ||
              (ref_high < inc_high ? is_seam(ref, reference.edge, true) : is_seam(inc, incident, false));
  m.features[0] =
      end_feature(pair, corner_against_edge(pair, owner, reference.edge, false, incident),
                  corner_against_edge(pair, other, incident, true, reference.edge), ref_low - inc_low);
  m.features[1] =
      end_feature(pair, corner_against_edge(pair, owner, reference.edge, true, incident),
                  corner_against_edge(pair, other, incident, false, reference.edge), inc_high - ref_high);
  const double ref_depth = distance_to_face(pair, owner, reference.edge);
  const double inc_depth = distance_to_face(pair, other, incident);
  m.depth_a = owner == pair.a ? ref_depth : inc_depth;
  m.depth_b = owner == pair.a ? inc_depth : ref_depth;
  return m;
}

// Of two convex shapes that overlap, the axis of least overlap has a length in common with both; one that is
// nearly as good need not.
Manifold polygon_polygon(const Pair& pair) {
  const References references = choose_references(pair);
  if (references.separation > pair.margin) return {};
  Manifold m = clip(pair, references.chosen);
  if (m.count == 0 && references.separation < 0.0) m = clip(pair, references.best);
  return m;
}

double radius_of(const Pair& pair, Index circle) {
  return std::get<Circle>(pair.model.colliders[circle].shape).radius;
}

Vec2 centre_of(const Pair& pair, Index circle) {
  return pair.frame(circle).to_world(pair.model.colliders[circle].centre);
}

Feature rim_of(const Pair& pair, Index circle) {
  Feature f;
  f.corner_body = pair.owner(circle);
  f.edge_body = pair.owner(pair.other(circle));
  f.corner = pair.model.colliders[circle].centre;
  f.radius = radius_of(pair, circle);
  return f;
}

Feature rim_against_point(const Pair& pair, Index circle, Vec2 point, double other_radius,
                          std::uint64_t identity) {
  Feature f = rim_of(pair, circle);
  f.kind = FeatureKind::round;
  f.edge_point = point;
  f.radius += other_radius;
  f.other_radius = other_radius;
  f.identity = identity;
  return f;
}

Feature rim_against_edge(const Pair& pair, Index circle, Vec2 point, Vec2 normal, Index edge) {
  Feature f = rim_of(pair, circle);
  f.edge_point = point;
  f.edge_normal = normal;
  f.identity = identity_of(circle == pair.b, 0, edge);
  return f;
}

Manifold single(const Feature& feature, double gap, double margin) {
  Manifold m;
  m.features[0] = feature;
  m.count = gap <= margin ? 1 : 0;
  return m;
}

constexpr Index corner_of_polygon = 1u << 30;  // tells "against corner i" from "against edge i"

Manifold circle_polygon(const Pair& pair, Index circle, Index other) {
  const double radius = radius_of(pair, circle);
  const auto& polygon = polygon_of(pair.model, other);
  const Vec2 centre = pair.frame(other).to_local(centre_of(pair, circle));
  Index edge = 0;
  double separation = -std::numeric_limits<double>::infinity();
  for (Index e = 0; e < polygon.size(); ++e) {
    const double s = dot(polygon.normal(e), centre - polygon.vertex(e));
    if (s > separation && !polygon.is_inner(e)) separation = s, edge = e;
  }
  const Vec2 tangent = turned(polygon.normal(edge));
  const double along = dot(tangent, centre - polygon.vertex(edge));
  const double length = dot(tangent, polygon.vertex(edge + 1) - polygon.vertex(edge));
  if (separation > 0.0 && (along < 0.0 || along > length)) {
    const Index corner = (along < 0.0 ? edge : edge + 1) % static_cast<Index>(polygon.size());
    const Vec2 point = polygon.vertex(corner);
    return single(
        rim_against_point(pair, circle, point, 0.0, identity_of(circle == pair.b, corner_of_polygon, corner)),
        norm(centre - point) - radius, pair.margin);
  }
  return single(rim_against_edge(pair, circle, polygon.vertex(edge), polygon.normal(edge), edge),
                separation - radius, pair.margin);
}

Manifold circle_circle(const Pair& pair) {
  const double ra = radius_of(pair, pair.a), rb = radius_of(pair, pair.b);
  const double gap = norm(centre_of(pair, pair.a) - centre_of(pair, pair.b)) - ra - rb;
  return single(rim_against_point(pair, pair.a, pair.model.colliders[pair.b].centre, rb, 0), gap,
                pair.margin);
}

constexpr Vec2 up{0.0, 1.0};  // a half-plane's normal, in its frame

Manifold circle_plane(const Pair& pair, Index circle, Index plane) {
  const double height = pair.frame(plane).to_local(centre_of(pair, circle)).y;
  return single(rim_against_edge(pair, circle, {}, up, 0), height - radius_of(pair, circle), pair.margin);
}

Feature corner_against_plane(const Pair& pair, Index polygon, Index plane, Index corner) {
  const auto& corners = polygon_of(pair.model, polygon);
  Feature f;
  f.corner_body = pair.owner(polygon);
  f.edge_body = pair.owner(plane);
  f.corner = corners.vertex(corner);
  f.edge_normal = up;
  f.identity = identity_of(polygon == pair.b, corner % static_cast<Index>(corners.size()), 0);
  return f;
}

// Both corners of the edge that faces the plane most.
Manifold polygon_plane(const Pair& pair, Index polygon, Index plane) {
  const auto& shape = polygon_of(pair.model, polygon);
  const Frame &frame = pair.frame(polygon), &plane_frame = pair.frame(plane);
  const Index edge = facing_edge(shape, frame.turned_to_local(plane_frame.turned_to_world(up)));
  const auto seen = [&](Index corner) { return plane_frame.to_local(frame.to_world(shape.vertex(corner))); };
  const Vec2 first = seen(edge), second = seen(edge + 1);
  Manifold m;
  if (std::min(first.y, second.y) > pair.margin) return m;
  m.count = 2;
  m.features = {corner_against_plane(pair, polygon, plane, edge),
                corner_against_plane(pair, polygon, plane, edge + 1)};
  m.length = edge_length(shape, edge);
  (polygon == pair.a ? m.depth_a : m.depth_b) = distance_to_face(pair, polygon, edge);
  return m;
}

}  // namespace

Manifold find_manifold(const Model& model, std::span<const Frame> frames, Index a, Index b, double margin,
                       const Manifold& previous) {
  const Pair pair{model, frames, a, b, margin, previous};
  const auto& shape_a = model.colliders[a].shape;
  const auto& shape_b = model.colliders[b].shape;
  const bool a_round = std::holds_alternative<Circle>(shape_a);
  const bool b_round = std::holds_alternative<Circle>(shape_b);
  if (std::holds_alternative<HalfPlane>(shape_b))
    return a_round ? circle_plane(pair, a, b) : polygon_plane(pair, a, b);
  if (std::holds_alternative<HalfPlane>(shape_a))
    return b_round ? circle_plane(pair, b, a) : polygon_plane(pair, b, a);
  if (a_round && b_round) return circle_circle(pair);
  if (a_round) return circle_polygon(pair, a, b);
  if (b_round) return circle_polygon(pair, b, a);
  return polygon_polygon(pair);
}

}  // namespace dougong::engine
