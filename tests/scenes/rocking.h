// A block let go from a tilt, and what is measured of its rocking (validation case R01).
#pragma once

#include <algorithm>
#include <cmath>

#include "tests/oracles/driven_rocking.h"
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

/// How a block that starts at rest on its ground rocks with it.
struct RockingRun {
  engine::Scene scene;
  double alpha = 0.0;              // rad
  double end_time = 0.0;           // s
  double quiet_from = 0.0;         // s: the ground does not accelerate any more
  double safe_energy = 0.0;        // rad2/s2: below it a block within alpha stays up
  double output_interval = 0.005;  // s
  double step_fraction = 0.5;
};

inline RockingRun rocking_run(const oracles::RockingBlock& c, double young_modulus, double damping_ratio,
                              std::shared_ptr<const engine::PrescribedMotion> motion, double quiet_from,
                              double end_time) {
  RockingRun run;
  run.scene = scene(2.0, young_modulus, damping_ratio);
  run.scene.gravity.y = -c.g;
  const double sunk = 2400.0 * 2.0 * c.h * c.g * c.h / young_modulus;
  run.scene.bodies.push_back(block(c.b, c.h, {0.0, c.h - sunk}));
  run.scene.terrains.push_back(ground(2000.0, {}, 0.0, std::move(motion)));
  run.alpha = c.alpha(), run.quiet_from = quiet_from, run.end_time = end_time;
  run.safe_energy = c.p() * c.p();
  return run;
}

inline std::size_t closed_points(const Running& r) {
  std::size_t closed = 0;
  const engine::ContactPoints& points = r.state.contacts.points;
  for (std::size_t i = 0; i < points.size(); ++i) closed += points.open(i) ? 0 : 1;
  return closed;
}

/// An impact is a change of the corner it stands on, between excursions of a thousandth of alpha. Ends early
/// when the outcome is certain: on its side, or too slow to reach alpha on a quiet ground.
inline oracles::RockingHistory measured_rocking(const RockingRun& run) {
  Running r(run.scene);
  oracles::RockingHistory h;
  double side = 0.0;
  const double quarter = 0.5 * std::numbers::pi, seen = 1e-3 * run.alpha;
  auto options = run_for(run.end_time, run.output_interval);
  options.step_fraction = run.step_fraction;
  r.run(options, [&](const engine::Sample& sample) {
    const double angle = r.angle(), spin = r.spin(), t = sample.state.time;
    h.angle = angle, h.spin = spin, h.greatest_angle = std::max(h.greatest_angle, std::abs(angle));
    if (std::abs(angle) > seen && side * angle <= 0.0) h.impacts += side != 0.0 ? 1 : 0, side = angle;
    if (h.uplift_time < 0.0 && t > 0.0 && closed_points(r) < 2) h.uplift_time = t;
    if (std::abs(angle) > 0.95 * quarter) {  // the rest of the way at the present spin
      h.overturned = true, h.overturning_time = t + (quarter - std::abs(angle)) / std::abs(spin);
      return engine::Wish::stop;
    }
    const double to_alpha = run.safe_energy * (1.0 - std::cos(run.alpha - std::abs(angle)));
    const bool leans = std::abs(angle) > 0.05 * run.alpha && std::abs(angle) < run.alpha;  // on one corner
    const bool safe = t > run.quiet_from && leans && 0.5 * spin * spin < 0.99 * to_alpha;
    return safe ? engine::Wish::stop : engine::Wish::go_on;
  });
  return h;
}

}  // namespace dougong::scenes
