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

const ConvexPolygon& polygon_of(const Model& model, Index i) {
  return std::get<ConvexPolygon>(model.shapes[i]);
}

bool was_feature(const Manifold& previous, std::uint64_t identity) {
  for (Index i = 0; i < previous.count; ++i)
    if (previous.features[i].identity == identity) return true;
  return false;
}

double distance_to_face(const ConvexPolygon& polygon, Index edge) {
  return std::max(0.0, dot(polygon.normal(edge), polygon.vertex(edge)));
}

struct Pair {
  const Model& model;
  std::span<const Frame> frames;
  Index a, b;
  double margin;
  const Manifold& previous;

  Index other(Index body) const { return body == a ? b : a; }
};

double separation_of(const Pair& pair, ReferenceEdge r) {
  const Index other = pair.other(r.owner);
  return separation_along(polygon_of(pair.model, r.owner), pair.frames[r.owner], r.edge,
                          polygon_of(pair.model, other), pair.frames[other]);
}

// The axis of greatest separation; the previous one if it is within a tenth of the margin of it.
ReferenceEdge choose_reference(const Pair& pair, double& separation) {
  const auto& pa = polygon_of(pair.model, pair.a);
  const auto& pb = polygon_of(pair.model, pair.b);
  const Frame &fa = pair.frames[pair.a], &fb = pair.frames[pair.b];
  const Axis best_a = greatest_separation(pa, fa, pb, fb);
  const Axis best_b = greatest_separation(pb, fb, pa, fa);
  const double tie = 0.1 * pair.margin;
  separation = std::max(best_a.separation, best_b.separation);
  if (pair.previous.reference.known && separation_of(pair, pair.previous.reference) > separation - tie)
    return pair.previous.reference;
  if (best_b.separation > best_a.separation + tie) return {pair.b, best_b.edge, true};
  return {pair.a, best_a.edge, true};
}

Index facing_edge(const ConvexPolygon& polygon, Vec2 local_direction) {
  Index best = 0;
  double lowest = std::numeric_limits<double>::infinity();
  for (Index e = 0; e < polygon.size(); ++e) {
    const double d = dot(polygon.normal(e), local_direction);
    if (d < lowest) lowest = d, best = e;
  }
  return best;
}

Feature corner_against_edge(const Pair& pair, Index corner_body, Index corner, Index edge) {
  const Index edge_body = pair.other(corner_body);
  const auto& corners = polygon_of(pair.model, corner_body);
  const auto& edges = polygon_of(pair.model, edge_body);
  Feature f;
  f.corner_body = corner_body;
  f.edge_body = edge_body;
  f.corner = corners.vertex(corner);
  f.edge_point = edges.vertex(edge);
  f.edge_normal = edges.normal(edge);
  f.identity = identity_of(corner_body == pair.b, corner % static_cast<Index>(corners.size()), edge);
  return f;
}

// One end of the clipped interval: the corner further in. Where both coincide, whichever it was.
Feature end_feature(const Pair& pair, const Feature& reference_corner, const Feature& incident_corner,
                    double reference_is_further_in_by) {
  if (std::abs(reference_is_further_in_by) <= pair.margin) {
    if (was_feature(pair.previous, reference_corner.identity)) return reference_corner;
    if (was_feature(pair.previous, incident_corner.identity)) return incident_corner;
  }
  return reference_is_further_in_by > 0.0 ? reference_corner : incident_corner;
}

Manifold clip(const Pair& pair, ReferenceEdge reference) {
  const Index owner = reference.owner, other = pair.other(owner);
  const auto& ref = polygon_of(pair.model, owner);
  const auto& inc = polygon_of(pair.model, other);
  const Frame &ref_frame = pair.frames[owner], &inc_frame = pair.frames[other];
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
  m.features[0] =
      end_feature(pair, corner_against_edge(pair, owner, reference.edge, incident),
                  corner_against_edge(pair, other, incident + 1, reference.edge), ref_low - inc_low);
  m.features[1] =
      end_feature(pair, corner_against_edge(pair, owner, reference.edge + 1, incident),
                  corner_against_edge(pair, other, incident, reference.edge), inc_high - ref_high);
  const double ref_depth = distance_to_face(ref, reference.edge), inc_depth = distance_to_face(inc, incident);
  m.depth_a = owner == pair.a ? ref_depth : inc_depth;
  m.depth_b = owner == pair.a ? inc_depth : ref_depth;
  return m;
}

Manifold polygon_polygon(const Pair& pair) {
  double separation = 0.0;
  const ReferenceEdge reference = choose_reference(pair, separation);
  if (separation > pair.margin) return {};
  return clip(pair, reference);
}

Feature rim_against_point(Index circle, double radius, Index other, Vec2 point, double other_radius,
                          std::uint64_t identity) {
  Feature f;
  f.kind = FeatureKind::round;
  f.corner_body = circle;
  f.edge_body = other;
  f.edge_point = point;
  f.radius = radius + other_radius;
  f.other_radius = other_radius;
  f.identity = identity;
  return f;
}

Feature rim_against_edge(const Pair& pair, Index circle, double radius, Index polygon_body, Index edge) {
  const auto& polygon = polygon_of(pair.model, polygon_body);
  Feature f;
  f.corner_body = circle;
  f.edge_body = polygon_body;
  f.edge_point = polygon.vertex(edge);
  f.edge_normal = polygon.normal(edge);
  f.radius = radius;
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

Manifold circle_polygon(const Pair& pair, Index circle, Index polygon_body) {
  const double radius = std::get<Circle>(pair.model.shapes[circle]).radius;
  const auto& polygon = polygon_of(pair.model, polygon_body);
  const Vec2 centre = pair.frames[polygon_body].to_local(pair.frames[circle].position());
  Index edge = 0;
  double separation = -std::numeric_limits<double>::infinity();
  for (Index e = 0; e < polygon.size(); ++e) {
    const double s = dot(polygon.normal(e), centre - polygon.vertex(e));
    if (s > separation) separation = s, edge = e;
  }
  const Vec2 tangent = turned(polygon.normal(edge));
  const double along = dot(tangent, centre - polygon.vertex(edge));
  const double length = dot(tangent, polygon.vertex(edge + 1) - polygon.vertex(edge));
  if (separation > 0.0 && (along < 0.0 || along > length)) {
    const Index corner = (along < 0.0 ? edge : edge + 1) % static_cast<Index>(polygon.size());
    const Vec2 point = polygon.vertex(corner);
    return single(rim_against_point(circle, radius, polygon_body, point, 0.0,
                                    identity_of(circle == pair.b, corner_of_polygon, corner)),
                  norm(centre - point) - radius, pair.margin);
  }
  return single(rim_against_edge(pair, circle, radius, polygon_body, edge), separation - radius, pair.margin);
}

Manifold circle_circle(const Pair& pair) {
  const double ra = std::get<Circle>(pair.model.shapes[pair.a]).radius;
  const double rb = std::get<Circle>(pair.model.shapes[pair.b]).radius;
  const double gap = norm(pair.frames[pair.a].position() - pair.frames[pair.b].position()) - ra - rb;
  return single(rim_against_point(pair.a, ra, pair.b, {}, rb, 0), gap, pair.margin);
}

}  // namespace

Manifold find_manifold(const Model& model, std::span<const Frame> frames, Index a, Index b, double margin,
                       const Manifold& previous) {
  const Pair pair{model, frames, a, b, margin, previous};
  const bool a_round = std::holds_alternative<Circle>(model.shapes[a]);
  const bool b_round = std::holds_alternative<Circle>(model.shapes[b]);
  if (a_round && b_round) return circle_circle(pair);
  if (a_round) return circle_polygon(pair, a, b);
  if (b_round) return circle_polygon(pair, b, a);
  return polygon_polygon(pair);
}

}  // namespace dougong::engine
