// The kernel that places bodies, for R at once (kernels.h).
#pragma once

#include "engine/frame.h"
#include "engine/lane_rows.h"
#include "engine/sine_cosine.h"

namespace dougong::engine {
namespace {

[[gnu::always_inline]] inline void store_frames(Frame* to, Real4 x, Real4 y, Real4 c, Real4 s, Real4 vx,
                                                Real4 vy, Real4 spin, Real4 angle) {
  transpose(x, y, c, s), transpose(vx, vy, spin, angle);
  const Real4 near[4] = {x, y, c, s}, far[4] = {vx, vy, spin, angle};
  for (int k = 0; k < 4; ++k) store_row(&to[k].x, near[k]), store_row(&to[k].vx, far[k]);
}

[[gnu::always_inline]] inline void store_frames(Frame* to, Real8 x, Real8 y, Real8 c, Real8 s, Real8 vx,
                                                Real8 vy, Real8 spin, Real8 angle) {
  transpose(x, y, c, s, vx, vy, spin, angle);
  const Real8 rows[8] = {x, y, c, s, vx, vy, spin, angle};
  for (int k = 0; k < 8; ++k) store_row(&to[k].x, rows[k]);
}

[[gnu::always_inline]] inline void store_frames(Frame* to, double x, double y, double c, double s, double vx,
                                                double vy, double spin, double angle) {
  to->x = x, to->y = y, to->c = c, to->s = s, to->vx = vx, to->vy = vy, to->spin = spin, to->angle = angle;
}

// Bodies from `i` to before `last`, R at once, of n; returns the first that is left.
template <class R>
[[gnu::always_inline]] inline std::size_t place_all(const double* q, const double* v, std::size_t n,
                                                    std::size_t i, std::size_t last, Frame* frames) {
  for (; i + lanes_of<R> <= last; i += lanes_of<R>) {
    const R angle = load_row<R>(q + 2 * n + i);
    const SineCosine<R> turn = sine_cosine(angle);
    store_frames(frames + i, load_row<R>(q + i), load_row<R>(q + n + i), turn.cosine, turn.sine,
                 load_row<R>(v + i), load_row<R>(v + n + i), load_row<R>(v + 2 * n + i), angle);
  }
  return i;
}

template <class R>
[[gnu::always_inline]] inline void place_bodies_by(const double* q, const double* v, std::size_t n,
                                                   std::size_t first, std::size_t last, Frame* frames) {
  place_all<double>(q, v, n, place_all<R>(q, v, n, first, last, frames), last, frames);
}

}  // namespace
}  // namespace dougong::engine
