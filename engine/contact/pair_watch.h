// How far pairs of bodies have moved against each other since they were seen, eight pairs at a time.
//
// The smaller body's pose in the larger one's frame is compared: its own radius bounds how far a turn carries
// its rim, so no point of one has moved further against the other than
//     moved = |x - x_seen| + |y - y_seen| + radius |angle - angle_seen|
#pragma once

#include <array>
#include <limits>

#include "engine/model.h"

namespace dougong::engine {

struct alignas(64) PairWatch {
  static constexpr std::size_t size = 8;
  static constexpr double never = std::numeric_limits<double>::infinity();
  using Reals = std::array<double, size>;
  using Bodies = std::array<Index, size>;

  Bodies large{}, small{};
  Reals x{}, y{}, angle{};  // m, rad: the smaller body's when the pair was seen; never: has moved
  Reals radius{};           // m, of the smaller body
  Reals moved{};            // m
  Reals limit{never, never, never, never, never, never, never, never};  // m, motion that calls for a new look
};

}  // namespace dougong::engine
