// The contact points as the kernel reads them: blocks of eight, a column of eight numbers for each quantity.
//
// Points 2 k and 2 k + 1 belong to the same pair of bodies, so a block has four pairs and needs the frames of
// eight bodies only.
#pragma once

#include <array>
#include <limits>

#include "engine/contact/point_law.h"
#include "engine/model.h"

namespace dougong::engine {

struct alignas(64) PointBlock {
  static constexpr std::size_t size = 8, pairs = 4;
  using Reals = std::array<double, size>;
  using PairReals = std::array<double, pairs>;    // the same for both points of a pair
  using Flags = std::array<unsigned char, size>;  // 0 or 1
  using Bodies = std::array<Index, pairs>;
  static constexpr double far_away = -1e100;  // m, the radius of a slot that never touches
  static constexpr double never = std::numeric_limits<double>::infinity();

  static constexpr Reals all(double value) {
    return {value, value, value, value, value, value, value, value};
  }

  // Where: CornerEdgeOf. A slot without a point, or with a round one, never touches.
  Reals corner_x{}, corner_y{}, normal_x{}, normal_y{}, offset_x{}, offset_y{};
  Reals radius = all(far_away);
  // The law: PointStiffnessOf and BearingLengthOf.
  Reals normal{}, tangential{}, normal_damping{}, tangential_damping{};
  Reals facing{}, edge_length{}, per_reference = all(1.0);
  PairReals friction{}, resting_share{1.0, 1.0, 1.0, 1.0}, nominal{};
  PairReals inverse_width{};  // 1/m
  // What they remember: PointMemoryOf and PointPastOf.
  PairReals calm_since{never, never, never, never};
  Reals anchor{}, overlap{}, position{}, dashpot{}, viscous{}, spent_friction{};
  Flags open{1, 1, 1, 1, 1, 1, 1, 1}, resting{};

  Flags corner_is_b{};     // the corner belongs to the pair's second body
  Flags angular{};         // a corner against an edge; the others are round
  Bodies a{}, b{};         // the pairs'
  bool has_round = false;  // not all are angular
  bool roused = false;     // a face of it has been, since ContactSet::take_disturbed
  bool asleep = false;     // all its points are open and stay so until the next look
};

/// Force on the first body of a pair (the second gets the opposite), torques about the centroids.
struct PairLoad {
  double fx = 0.0, fy = 0.0;              // N
  double torque_a = 0.0, torque_b = 0.0;  // N m

  /// A force on a point's corner, and its torques on the bodies of the corner and of the edge.
  void add(bool corner_is_b, Vec2 force, double on_corner, double on_edge) {
    fx += corner_is_b ? -force.x : force.x, fy += corner_is_b ? -force.y : force.y;
    torque_a += corner_is_b ? on_edge : on_corner, torque_b += corner_is_b ? on_corner : on_edge;
  }
};

/// Sums over the points.
struct ContactTotals {
  double damping_power = 0.0;     // W, taken by the dashpots
  double tangential_power = 0.0;  // W, taken by the tangential forces less their dashpots
  // The same as work since the last committed poses (J); only with `commit`.
  double damping_work = 0.0, tangential_work = 0.0;
  double deepest_ratio = 0.0;  // overlap over the smaller body's minimum width
  std::size_t deepest_point = 0;
  bool roused = false;  // a face that rested no longer does: its dashpots are stiffer

  ContactTotals& operator+=(const ContactTotals& o) {
    damping_power += o.damping_power, tangential_power += o.tangential_power;
    damping_work += o.damping_work, tangential_work += o.tangential_work;
    roused |= o.roused;
    if (o.deepest_ratio > 0.0) note_depth(o.deepest_ratio, o.deepest_point);
    return *this;
  }
  /// Of equal ones the first point counts.
  [[gnu::always_inline]] void note_depth(double ratio, std::size_t point) {
    if (ratio < deepest_ratio || (ratio == deepest_ratio && point >= deepest_point)) return;
    deepest_ratio = ratio, deepest_point = point;
  }
};

}  // namespace dougong::engine
