// Whole cycles of a sine of acceleration, and the ground at rest before and after.
#pragma once

#include <algorithm>

#include "tests/scenes/running_bond.h"

namespace dougong::scenes {

/// As sine_motion, for so many whole cycles: the ground then stands still where they took it.
inline std::shared_ptr<const engine::PrescribedMotion> sine_cycles(double amplitude, double frequency,
                                                                   int cycles) {
  const double w = 2.0 * std::numbers::pi * frequency, end = cycles / frequency;
  return horizontal_motion(
      [=](double t) { return t < end ? amplitude * std::sin(w * t) : 0.0; },
      [=](double t) { return t < end ? amplitude / w * (1.0 - std::cos(w * t)) : 0.0; },
      [=](double t) { return amplitude / w * (std::min(t, end) - std::sin(w * std::min(t, end)) / w); });
}

}  // namespace dougong::scenes
