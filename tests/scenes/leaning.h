// What stands is made to lean: gravity is turned a little at a time, which is what tilting the ground does to
// what stands on it.
#pragma once

#include "tests/scenes/running.h"

namespace dougong::scenes {

/// Raises the load to `load` (rad; or g, with the vertical part kept) in twenty stages and rests there.
/// Returns whether any block turns by more than `lost` (rad).
inline bool topples_under(Running& r, double load, bool keep_vertical_part, double rest, double lost,
                          double stage = 0.03) {
  const int stages = 20;
  bool toppled = false;
  for (int i = 1; i <= stages && !toppled; ++i) {
    const double part = load * i / stages;
    r.model.gravity =
        keep_vertical_part ? engine::Vec2{9.81 * part, -9.81} : engine::rotated({0.0, -9.81}, part);
    r.run(run_for(i == stages ? rest : stage, 0.01), [&](const engine::Sample&) {
      for (std::size_t k = 0; k < r.bodies(); ++k) toppled |= std::abs(r.angle(k)) > lost;
      return toppled ? engine::Wish::stop : engine::Wish::go_on;
    });
  }
  return toppled;
}

}  // namespace dougong::scenes
