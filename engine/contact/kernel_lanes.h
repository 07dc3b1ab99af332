// The kernel of the corner-edge forces for R doubles at once (kernels.h).
#pragma once

#include "engine/fetch_ahead.h"
#include "engine/kernels.h"
#include "engine/pose_lanes.h"

namespace dougong::engine {
namespace {

#define DOUGONG_INLINE [[gnu::always_inline]] inline

template <class R>
DOUGONG_INLINE R load_lanes(const PointBlock::Reals& column, int from) {
  return load_row<R>(reinterpret_cast<const double*>(&column) + from);
}
template <class R>
DOUGONG_INLINE void store_lanes(PointBlock::Reals& column, int from, R v) {
  store_row(reinterpret_cast<double*>(&column) + from, v);
}
template <class R>
DOUGONG_INLINE R load_lanes(const PointBlock::PairReals& column, int from) {
  return doubled(reinterpret_cast<const double*>(&column) + from / 2, R{});
}
template <class R>
DOUGONG_INLINE R load_lanes(const PointBlock::Flags& column, int from) {
  return load_flags<R>(reinterpret_cast<const unsigned char*>(&column) + from);
}
template <class R>
DOUGONG_INLINE void store_lanes(PointBlock::Flags& column, int from, R v) {
  store_flags(reinterpret_cast<unsigned char*>(&column) + from, v);
}
DOUGONG_INLINE Index index_at(const PointBlock::Bodies& bodies, int k) {
  return reinterpret_cast<const Index*>(&bodies)[k];
}

// The frames of the corners' bodies and of the edges', for the points from lane `from` of a block.
template <class R>
struct Poses {
  PoseOf<R> corner, edge;
};

template <class R>
DOUGONG_INLINE Poses<R> poses_of(const PointBlock& b, int from, const Frame* frames, R corner_is_b) {
  const Frame* rows[lanes_of<R>];
  for (int k = 0; k < lanes_of<R> / 2; ++k) {
    rows[2 * k] = frames + index_at(b.a, from / 2 + k);
    rows[2 * k + 1] = frames + index_at(b.b, from / 2 + k);
  }
  const PoseOf<R> all = columns(rows);
  Poses<R> p;
  const auto share = [&] [[gnu::always_inline]] (R both, R & corner, R & edge) {
    const R first = evens(both), second = odds(both);
    corner = where(corner_is_b, second, first), edge = where(corner_is_b, first, second);
  };
  share(all.x, p.corner.x, p.edge.x), share(all.y, p.corner.y, p.edge.y);
  share(all.c, p.corner.c, p.edge.c), share(all.s, p.corner.s, p.edge.s);
  share(all.vx, p.corner.vx, p.edge.vx), share(all.vy, p.corner.vy, p.edge.vy);
  share(all.spin, p.corner.spin, p.edge.spin), share(all.angle, p.corner.angle, p.edge.angle);
  return p;
}

// Both points of a pair together, on its first body, as rows of the loads.
DOUGONG_INLINE void store_loads(PairLoad* to, Real2 forces, Real2 torques) {
  store_row(&to->fx, forces), store_row(&to->torque_a, torques);
}
DOUGONG_INLINE void store_loads(PairLoad* to, Real4 forces, Real4 torques) {
  store_row(&to[0].fx, Real4(__builtin_shufflevector(forces, torques, 0, 1, 4, 5)));
  store_row(&to[1].fx, Real4(__builtin_shufflevector(forces, torques, 2, 3, 6, 7)));
}
DOUGONG_INLINE void store_loads(PairLoad* to, Real8 forces, Real8 torques) {
  store_row(&to[0].fx, Real8(__builtin_shufflevector(forces, torques, 0, 1, 8, 9, 2, 3, 10, 11)));
  store_row(&to[2].fx, Real8(__builtin_shufflevector(forces, torques, 4, 5, 12, 13, 6, 7, 14, 15)));
}

template <class R>
DOUGONG_INLINE void add_loads(PairLoad* to, R corner_is_b, const PointGeometryOf<R>& g, VecOf<R> force) {
  const R on_corner = cross(g.arm_corner, force), on_edge = -cross(g.arm_edge, force);
  const R fx = where(corner_is_b, -force.x, force.x), fy = where(corner_is_b, -force.y, force.y);
  const R ta = where(corner_is_b, on_edge, on_corner), tb = where(corner_is_b, on_corner, on_edge);
  const auto both = [] [[gnu::always_inline]] (R v) { return v + partners(v); };
  store_loads(to, alternate(both(fx), both(fy)), alternate(both(ta), both(tb)));
}

// Sums, lane by lane over the blocks.
template <class R>
struct LaneTotals {
  R damping_power{}, tangential_power{}, damping_work{}, tangential_work{};
  R deepest_ratio{}, deepest_block = R{} - 1.0;
  R roused{};
};

// Both points of a pair, after a commit at `time`. They come to rest when both have been calm for some
// periods of their springs, so that no landing ends in between; a point that opens rouses both.
template <class R>
DOUGONG_INLINE R follow_rest(PointBlock& b, int from, R angular, R open, R resting,
                             const PointPastOf<R>& past, double time) {
  const R one = all_lanes<R>(1.0), never = all_lanes<R>(PointBlock::never);
  const R normal = load_lanes<R>(b.normal, from), damping = load_lanes<R>(b.normal_damping, from);
  const R since = load_lanes<R>(b.calm_since, from);
  const R alone = magnitude(resting - partners(resting));
  const R leaves = greater(greater(open, partners(open)), alone),
          rested = greater(resting, partners(resting));
  const R calm_here = calm_flag(normal, past), calm = calm_here * partners(calm_here);
  const R calm_since = where(calm, lesser(since, all_lanes<R>(time)), never);
  const R waited = (time - calm_since) * normal, needed = relaxations_to_rest * damping;
  const R ready = where(calm, where_less(waited, needed, R{}, one), R{});
  const R comes_to_rest = ready * partners(ready);
  const R next_since = where(leaves, never, where(rested, since, calm_since));
  const R next = where(leaves, R{}, greater(rested, comes_to_rest));
  store_evens(reinterpret_cast<double*>(&b.calm_since) + from / 2, R(where(angular, next_since, since)));
  store_lanes(b.resting, from, R(angular * next));
  return angular * leaves * rested;
}

template <class R>
DOUGONG_INLINE void commit_points(PointBlock& b, int from, double block, const PointGeometryOf<R>& g,
                                  const PointForceOf<R>& f, R resting, double time, LaneTotals<R>& totals) {
  const R one = all_lanes<R>(1.0), angular = load_lanes<R>(b.angular, from);
  const PointPastOf<R> past{load_lanes<R>(b.overlap, from), load_lanes<R>(b.position, from),
                            load_lanes<R>(b.dashpot, from), load_lanes<R>(b.viscous, from),
                            load_lanes<R>(b.spent_friction, from)};
  PointWorkOf<R> work = work_since(past, g, f);
  PointPastOf<R> now{g.overlap, g.position, f.dashpot, f.viscous, f.friction};
  R anchor = g.position - f.slip, open = where_positive(g.overlap, R{}, one);
  R ratio = g.overlap * load_lanes<R>(b.inverse_width, from);
  if (b.has_round) {
    const auto keep = [&] [[gnu::always_inline]] (R & value, R before) {
      value = where(angular, value, before);
    };
    keep(work.damping, R{}), keep(work.tangential, R{}), keep(ratio, R{});
    keep(now.overlap, past.overlap), keep(now.position, past.position), keep(now.dashpot, past.dashpot);
    keep(now.viscous, past.viscous), keep(now.friction, past.friction);
    keep(anchor, load_lanes<R>(b.anchor, from)), keep(open, load_lanes<R>(b.open, from));
  }
  totals.damping_work += work.damping, totals.tangential_work += work.tangential;
  store_lanes(b.overlap, from, now.overlap), store_lanes(b.position, from, now.position);
  store_lanes(b.dashpot, from, now.dashpot), store_lanes(b.viscous, from, now.viscous);
  store_lanes(b.spent_friction, from, now.friction);
  store_lanes(b.anchor, from, anchor), store_lanes(b.open, from, open);
  totals.deepest_block = where_less(totals.deepest_ratio, ratio, all_lanes<R>(block), totals.deepest_block);
  totals.deepest_ratio = greater(totals.deepest_ratio, ratio);
  const R alone = where(angular, open, one);  // round points are the only ones of their pairs
  const R roused = follow_rest(b, from, angular, alone, resting, now, time);
  b.roused |= any_positive(roused);
  totals.roused = greater(totals.roused, roused);
}

template <class R, bool commit>
DOUGONG_INLINE void evaluate(PointBlock& b, int from, double block, const Frame* frames, PairLoad* loads,
                             double time, double step, LaneTotals<R>& totals) {
  const R corner_is_b = load_lanes<R>(b.corner_is_b, from);
  const Poses<R> p = poses_of<R>(b, from, frames, corner_is_b);
  const CornerEdgeOf<R> place{{load_lanes<R>(b.corner_x, from), load_lanes<R>(b.corner_y, from)},
                              {load_lanes<R>(b.normal_x, from), load_lanes<R>(b.normal_y, from)},
                              {load_lanes<R>(b.offset_x, from), load_lanes<R>(b.offset_y, from)},
                              load_lanes<R>(b.radius, from)};
  const PointMemoryOf<R> memory{load_lanes<R>(b.anchor, from), load_lanes<R>(b.open, from),
                                load_lanes<R>(b.resting, from)};
  const PointStiffnessOf<R> law{
      load_lanes<R>(b.normal, from),         load_lanes<R>(b.tangential, from),
      load_lanes<R>(b.normal_damping, from), load_lanes<R>(b.tangential_damping, from),
      load_lanes<R>(b.friction, from),       load_lanes<R>(b.resting_share, from)};
  const BearingLengthOf<R> bearing{load_lanes<R>(b.facing, from), load_lanes<R>(b.edge_length, from),
                                   load_lanes<R>(b.nominal, from), load_lanes<R>(b.per_reference, from)};
  const PointGeometryOf<R> g = corner_edge_geometry(place, p.corner, p.edge, memory);
  const PointRatesOf<R> rate = point_rates(g, p.corner, p.edge);
  const PointForceOf<R> f = point_force(law, bearing, g, rate, memory, step);
  add_loads<R>(loads + from / 2, corner_is_b, g, f.force);
  const PointWorkOf<R> power = power_of(f, rate);
  totals.damping_power += power.damping, totals.tangential_power += power.tangential;
  if constexpr (commit) commit_points<R>(b, from, block, g, f, memory.resting, time, totals);
}

// In the order of the lanes, so that the sums do not depend on how many were taken at once.
template <class R>
DOUGONG_INLINE void add_lanes(const LaneTotals<R>& lanes, std::size_t from, ContactTotals& totals) {
  for (int k = 0; k < lanes_of<R>; ++k) {
    totals.damping_power += lanes.damping_power[k], totals.tangential_power += lanes.tangential_power[k];
    totals.damping_work += lanes.damping_work[k], totals.tangential_work += lanes.tangential_work[k];
    totals.roused |= lanes.roused[k] != 0.0;
    if (lanes.deepest_ratio[k] <= 0.0) continue;
    const auto block = static_cast<std::size_t>(lanes.deepest_block[k]);
    const std::size_t point = block * PointBlock::size + from + static_cast<std::size_t>(k);
    totals.note_depth(lanes.deepest_ratio[k], point);
  }
}

// Fewer points than lanes of R: a rocking block has two.
template <class Few, bool commit>
DOUGONG_INLINE void evaluate_few(const CornerEdgeCall& call, ContactTotals& totals) {
  if (call.first == call.last) return;
  LaneTotals<Few> lanes;
  evaluate<Few, commit>(call.blocks[0], 0, 0.0, call.frames, call.loads, call.time, call.step, lanes);
  add_lanes(lanes, 0, totals);
}

template <class R, bool commit>
DOUGONG_INLINE void evaluate_blocks(const CornerEdgeCall& call, ContactTotals& totals) {
  constexpr int parts = static_cast<int>(PointBlock::size) / lanes_of<R>;
  LaneTotals<R> lanes[parts];
  const bool far = outgrow_the_caches<PointBlock>(call.points / PointBlock::size);
  for (std::size_t i = call.first; i < call.last; ++i) {
    if (far && i + fetched_ahead < call.last) fetch(call.blocks[i + fetched_ahead]);
    PairLoad* const to = call.loads + PointBlock::pairs * i;
    if (call.blocks[i].asleep) {
      for (std::size_t k = 0; k < PointBlock::pairs; ++k) to[k] = PairLoad{};
      continue;
    }
    for (int part = 0; part < parts; ++part)
      evaluate<R, commit>(call.blocks[i], part * lanes_of<R>, static_cast<double>(i), call.frames, to,
                          call.time, call.step, lanes[part]);
  }
  for (int part = 0; part < parts; ++part)
    add_lanes(lanes[part], static_cast<std::size_t>(part * lanes_of<R>), totals);
}

template <class R, bool commit>
DOUGONG_INLINE void evaluate_as_many(const CornerEdgeCall& call, ContactTotals& totals) {
  if (call.points <= lanes_of<Real2>)
    evaluate_few<Real2, commit>(call, totals);
  else if (call.points <= lanes_of<Real4>)
    evaluate_few<Real4, commit>(call, totals);
  else
    evaluate_blocks<R, commit>(call, totals);
}

template <class R>
DOUGONG_INLINE void evaluate_all(const CornerEdgeCall& call, ContactTotals& totals) {
  if (call.commit)
    evaluate_as_many<R, true>(call, totals);
  else
    evaluate_as_many<R, false>(call, totals);
}

#undef DOUGONG_INLINE

}  // namespace
}  // namespace dougong::engine
