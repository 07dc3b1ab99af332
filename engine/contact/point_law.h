// What one contact point of a corner against an edge does, for any number of points at once (lanes.h).
#pragma once

#include "engine/contact/bearing_length.h"
#include "engine/contact/law.h"
#include "engine/vec2.h"

namespace dougong::engine {

/// Where a body is and how it moves, as Frame.
template <class R>
struct PoseOf {
  R x{}, y{}, c{}, s{}, vx{}, vy{}, spin{}, angle{};

  [[gnu::always_inline]] VecOf<R> turned_to_world(VecOf<R> local) const {
    return {c * local.x - s * local.y, s * local.x + c * local.y};
  }
};

/// A corner and the edge it faces, each in its own body's frame.
template <class R>
struct CornerEdgeOf {
  VecOf<R> corner;  // m
  VecOf<R> normal;  // -, of the edge
  VecOf<R> offset;  // m, of the edge along its normal and its tangent
  R radius{};       // m
};

/// Geometry of a point at given poses.
template <class R>
struct PointGeometryOf {
  VecOf<R> normal;      // -, from the edge's body to the corner's
  VecOf<R> arm_corner;  // m, from the corner body's centroid to the contact point
  VecOf<R> arm_edge;    // m
  R overlap{};          // m, > 0 when touching
  R slip{};             // m, from the anchor; 0 for an open point
  R position{};         // m, of the corner along the edge; round contacts: slip since the last commit
};
using PointGeometry = PointGeometryOf<double>;

template <class R>
struct PointRatesOf {
  R overlap{}, slip{};  // m/s
};

/// Where its friction spring is relaxed; flags: it has none, its face rests.
template <class R>
struct PointMemoryOf {
  R anchor{};           // m
  R open{}, resting{};  // 0 or 1
};

/// What a point did at the last committed poses: the work of its forces since then is the trapezoidal rule
/// along its displacement.
template <class R>
struct PointPastOf {
  R overlap{}, position{};  // m, negative overlap when open
  R dashpot{};              // N, normal force less the spring's
  R viscous{}, friction{};  // N, against slip: the tangential dashpot, and all else
};
using PointPast = PointPastOf<double>;

/// Force on the corner's body, and what it is made of. Zero where the point is open.
template <class R>
struct PointForceOf {
  VecOf<R> force;                      // N
  R dashpot{}, viscous{}, friction{};  // N, as in PointPast
  R slip{};                            // m, that the spring keeps
};

template <class R>
[[gnu::always_inline]] inline PointGeometryOf<R> corner_edge_geometry(const CornerEdgeOf<R>& p,
                                                                      const PoseOf<R>& corner,
                                                                      const PoseOf<R>& edge,
                                                                      const PointMemoryOf<R>& memory) {
  PointGeometryOf<R> g;
  g.normal = edge.turned_to_world(p.normal);
  const VecOf<R> arm = corner.turned_to_world(p.corner);
  const VecOf<R> between{corner.x - edge.x, corner.y - edge.y};
  const VecOf<R> reach = between + arm;  // from the edge body's centroid to the corner
  g.overlap = p.radius + p.offset.x - dot(g.normal, reach);
  g.arm_corner = arm - p.radius * g.normal;
  g.arm_edge = reach - p.radius * g.normal;
  g.position = dot(turned(g.normal), reach) - p.offset.y - p.radius * (corner.angle - edge.angle);
  g.slip = where(memory.open, R{}, g.position - memory.anchor);
  return g;
}

template <class R>
[[gnu::always_inline]] inline PointRatesOf<R> point_rates(const PointGeometryOf<R>& g,
                                                          const PoseOf<R>& corner, const PoseOf<R>& edge) {
  const VecOf<R> v{corner.vx - edge.vx, corner.vy - edge.vy};
  const VecOf<R> u = v + corner.spin * turned(g.arm_corner) - edge.spin * turned(g.arm_edge);
  return {-dot(g.normal, u), dot(turned(g.normal), u)};
}

/// What the forces of a pose count for in the step before and after it, where the point closed since the last
/// pose or is about to open (contact_forces). step = 0: no weighing.
template <class R>
struct PoseWeightsOf {
  R spring = R{} + 1.0, dashpot = R{} + 1.0;
};

// tau/h: part of the step before in which the point was closed.
template <class R>
[[gnu::always_inline]] inline PoseWeightsOf<R> closing_weights(R overlap, R rate, double step) {
  const R way = rate * step, one = R{} + 1.0;
  const R closed = where_less(overlap, way, overlap / way, one);
  return {0.5 + 0.5 * closed, 0.5 + closed};
}

// Of a point that will open before the step is over.
template <class R>
[[gnu::always_inline]] inline R opening_weight(R overlap, R rate, double step) {
  const R way = rate * step;
  return where_less(overlap + way, R{}, 0.5 - 0.5 * overlap / way, R{} + 1.0);
}

template <class R>
[[gnu::always_inline]] inline PointForceOf<R> point_force(const PointStiffnessOf<R>& whole,
                                                          const BearingLengthOf<R>& bearing,
                                                          const PointGeometryOf<R>& g,
                                                          const PointRatesOf<R>& rate,
                                                          const PointMemoryOf<R>& memory, double step) {
  const R one = R{} + 1.0;
  const BearingShareOf<R> share = bearing_share(bearing, g.position);
  const PointStiffnessOf<R> law = scaled(whole, share.factor, where(memory.resting, whole.resting, one));
  // What hardly any point does at a time is left out where none does it: the divisions cost most.
  PoseWeightsOf<R> w;
  if (step > 0.0 && any_positive(where_positive(g.overlap, memory.open, R{}))) {
    const PoseWeightsOf<R> closing = closing_weights(g.overlap, rate.overlap, step);
    w.spring = where(memory.open, closing.spring, one);
    w.dashpot = where(memory.open, closing.dashpot, one);
  }
  R spring = w.spring * law.normal * g.overlap;
  R normal = normal_force(w.spring * law.normal, w.dashpot * law.normal_damping, g.overlap, rate.overlap);
  const R limit = law.friction * normal;
  const R damping = w.dashpot * law.tangential_damping;
  const R wanted = law.tangential * g.slip + damping * rate.slip;
  R last = one;
  if (step > 0.0 && any_positive(where_less(g.overlap + rate.overlap * step, R{}, normal, R{}))) {
    last = where_positive(normal, opening_weight(g.overlap, rate.overlap, step), one);
    spring = last * spring, normal = last * normal;
  }
  R slip = g.slip;
  if (any_positive(magnitude(law.tangential * slip) - limit))
    slip = returned_slip(slip, law.tangential, limit);
  // A stiffness that follows the position pushes along the edge with the slope of its springs' energy.
  const R end_normal = 0.5 * share.slope * whole.normal * g.overlap * g.overlap;
  const R end_tangential = 0.5 * share.slope * whole.tangential * slip * slip;
  const R held = last * friction_force(wanted, limit) + end_tangential;
  const R tangential = -held - end_normal;
  const R viscous = where_less(limit, magnitude(wanted), R{}, last * damping * rate.slip);

  const auto kept = [&] [[gnu::always_inline]] (R value) { return where_positive(g.overlap, value, R{}); };
  const VecOf<R> force = normal * g.normal + tangential * turned(g.normal);
  return {
      {kept(force.x), kept(force.y)}, kept(normal - spring), kept(viscous), kept(held - viscous), kept(slip)};
}

/// Work that a point takes: by its dashpots, and by the tangential forces less theirs.
template <class R>
struct PointWorkOf {
  R damping{}, tangential{};  // J, or W
};

template <class R>
[[gnu::always_inline]] inline PointWorkOf<R> power_of(const PointForceOf<R>& f, const PointRatesOf<R>& rate) {
  return {f.dashpot * rate.overlap + f.viscous * rate.slip, f.friction * rate.slip};
}

/// Since the last commit.
template <class R>
[[gnu::always_inline]] inline PointWorkOf<R> work_since(const PointPastOf<R>& past,
                                                        const PointGeometryOf<R>& g,
                                                        const PointForceOf<R>& f) {
  const R closed = g.overlap - past.overlap, slid = g.position - past.position;
  return {0.5 * (past.dashpot + f.dashpot) * closed + 0.5 * (past.viscous + f.viscous) * slid,
          0.5 * (past.friction + f.friction) * slid};
}

/// Faces come to rest when both their points have been calm for this many of their relaxation times.
constexpr double relaxations_to_rest = 10.0;

/// A flag: the point bears, and its dashpot adds next to nothing.
template <class R>
[[gnu::always_inline]] inline R calm_flag(R normal_stiffness, const PointPastOf<R>& past) {
  constexpr double next_to_nothing = 0.05;
  const R spring = normal_stiffness * past.overlap;
  const R quiet = where_less(next_to_nothing * spring, magnitude(past.dashpot), R{}, R{} + 1.0);
  return where_positive(spring, quiet, R{});
}

}  // namespace dougong::engine
