// How far pairs of bodies have moved against each other since they were seen, eight pairs at a time; and what
// else is asked of every pair at every look, so that ContactPair is only read where there is something to do.
//
// The smaller body's pose in the larger one's frame is compared: its own radius bounds how far a turn carries
// its rim, so no point of one has moved further against the other than
//     moved = |x - x_seen| + |y - y_seen| + radius |angle - angle_seen|
#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "engine/model.h"

namespace dougong::engine {

struct alignas(64) PairWatch {
  static constexpr std::size_t size = 8;
  static constexpr double never = std::numeric_limits<double>::infinity();
  using Reals = std::array<double, size>;
  using Bodies = std::array<Index, size>;
  static constexpr Index none = std::numeric_limits<Index>::max();

  Bodies large{}, small{};
  Reals x{}, y{}, angle{};  // m, rad: the smaller body's when the pair was seen; never: has moved
  Reals radius{};           // m, of the smaller body
  Reals gap{};              // m, when the pair was seen
  Reals moved{};            // m
  Reals limit{never, never, never, never, never, never, never, never};  // m, motion that calls for a new look
  Bodies first_point{none, none, none, none, none, none, none, none};   // of two; none: out of reach

  bool any_beyond_limit() const {
    bool any = false;
    for (std::size_t lane = 0; lane < size; ++lane) any |= moved[lane] > limit[lane];
    return any;
  }
  double smallest_limit() const { return *std::min_element(limit.begin(), limit.end()); }
};

}  // namespace dougong::engine
