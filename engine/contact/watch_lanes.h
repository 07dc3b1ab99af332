// The kernel that measures how far pairs have moved, for R at once (kernels.h).
#pragma once

#include "engine/contact/pair_watch.h"
#include "engine/fetch_ahead.h"
#include "engine/pose_lanes.h"

namespace dougong::engine {
namespace {

template <class R>
[[gnu::always_inline]] inline PoseOf<R> poses_from(const PairWatch::Bodies& bodies, int from,
                                                   const Frame* frames) {
  const Frame* rows[lanes_of<R>];
  const Index* const indices = reinterpret_cast<const Index*>(&bodies) + from;
  for (int k = 0; k < lanes_of<R>; ++k) rows[k] = frames + indices[k];
  return columns(rows);
}

template <class R>
[[gnu::always_inline]] inline void measure_motion(PairWatch& w, int from, const Frame* frames) {
  const auto column = [&] [[gnu::always_inline]] (const PairWatch::Reals& c) {
    return load_row<R>(reinterpret_cast<const double*>(&c) + from);
  };
  const PoseOf<R> large = poses_from<R>(w.large, from, frames), small = poses_from<R>(w.small, from, frames);
  const R dx = small.x - large.x, dy = small.y - large.y;
  const R x = large.c * dx + large.s * dy, y = large.c * dy - large.s * dx;
  const R turn = column(w.radius) * magnitude(small.angle - large.angle - column(w.angle));
  store_row(reinterpret_cast<double*>(&w.moved) + from,
            R(magnitude(x - column(w.x)) + magnitude(y - column(w.y)) + turn));
}

template <class R>
[[gnu::always_inline]] inline void measure_motions(PairWatch* watches, std::size_t count,
                                                   const Frame* frames) {
  for (std::size_t i = 0; i < count; ++i) {
    if (i + fetched_ahead < count) fetch(watches[i + fetched_ahead]);
    for (int from = 0; from < static_cast<int>(PairWatch::size); from += lanes_of<R>)
      measure_motion<R>(watches[i], from, frames);
  }
}

}  // namespace
}  // namespace dougong::engine
