// Frames of several bodies as columns: lanes of their poses.
#pragma once

#include "engine/contact/point_law.h"
#include "engine/frame.h"
#include "engine/lane_rows.h"

namespace dougong::engine {
namespace {

// Rows x y c s vx vy spin angle of a body each, to a column of bodies each.
[[gnu::always_inline]] inline PoseOf<Real2> columns(const Frame* const (&f)[2]) {
  const Frame &a = *f[0], &b = *f[1];
  const auto both = [] [[gnu::always_inline]] (double p, double q) { return Real2{p, q}; };
  return {both(a.x, b.x),   both(a.y, b.y),   both(a.c, b.c),       both(a.s, b.s),
          both(a.vx, b.vx), both(a.vy, b.vy), both(a.spin, b.spin), both(a.angle, b.angle)};
}

[[gnu::always_inline]] inline PoseOf<Real4> columns(const Frame* const (&f)[4]) {
  Real4 near[4], far[4];
  for (int k = 0; k < 4; ++k) {
    near[k] = load_row<Real4>(&f[k]->x);
    far[k] = load_row<Real4>(&f[k]->vx);
  }
  transpose(near[0], near[1], near[2], near[3]);
  transpose(far[0], far[1], far[2], far[3]);
  return {near[0], near[1], near[2], near[3], far[0], far[1], far[2], far[3]};
}

[[gnu::always_inline]] inline PoseOf<Real8> columns(const Frame* const (&f)[8]) {
  Real8 r[8];
  for (int k = 0; k < 8; ++k) r[k] = load_row<Real8>(&f[k]->x);
  transpose(r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7]);
  return {r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7]};
}

}  // namespace
}  // namespace dougong::engine
