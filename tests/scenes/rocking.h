// A block let go from a tilt, and what is measured of its rocking (validation case R01).
#pragma once

#include <algorithm>
#include <cmath>

#include "tests/oracles/rocking.h"
#include "tests/scenes/running.h"

namespace dougong::scenes {

// Turned about its right corner, which touches the ground.
inline engine::Scene tilted_block(const oracles::RockingBlock& c, double amplitude, double young_modulus,
                                  double damping_ratio) {
  engine::Scene s = scene(2.0, young_modulus, damping_ratio);
  s.gravity.y = -c.g;
  s.bodies.push_back(block(c.b, c.h, engine::rotated({-c.b, c.h}, -amplitude), -amplitude));
  s.terrains.push_back(ground());
  return s;
}

/// Times at which the angle passes zero, the greatest spin of the fall before and angle of the rise after.
inline std::vector<oracles::Impact> measured_impacts(Running& r, const engine::DriveOptions& options,
                                                     std::size_t count) {
  std::vector<oracles::Impact> all;
  double last_angle = 0.0, last_time = 0.0, last_spin = 0.0, fastest = 0.0;
  r.run(options, [&](const engine::Sample& sample) {
    const double angle = r.angle(), time = sample.state.time;
    fastest = last_spin * r.spin() < 0.0 ? 0.0 : std::max(fastest, std::abs(r.spin()));
    if (last_angle * angle < 0.0) {
      if (all.size() == count) return engine::Wish::stop;
      all.push_back({last_time + (time - last_time) * last_angle / (last_angle - angle), fastest, 0.0});
    }
    if (!all.empty()) all.back().amplitude_after = std::max(all.back().amplitude_after, std::abs(angle));
    last_angle = angle, last_time = time, last_spin = r.spin();
    return engine::Wish::go_on;
  });
  return all;
}

}  // namespace dougong::scenes
