// A block on level ground under a horizontal force F cos(w t), and what is measured of its stick and slip
// (comparison C09).
//
// The engine has no applied forces, and needs none here: seen from a ground of acceleration
//   a(t) = -F cos(w t)/m,   v = -F/(m w) sin(w t),   d = F/(m w^2) (cos(w t) - 1)
// the block feels the inertial force -m a = F cos(w t), so that its motion relative to the ground is that of
// the forced block on a ground at rest.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/oracles/sliding.h"
#include "tests/scenes/running.h"

namespace dougong::scenes {

struct StickSlip {
  double mass, friction, force, w, g = 9.81;        // kg, -, N, rad/s, m/s2
  double half_width = 0.15, half_height = 0.05;     // m
  double young_modulus = 3e9, step_fraction = 0.9;  // Pa
  double until = 10.0, output_interval = 1e-4;      // s

  double ground_displacement(double t) const { return force / (mass * w * w) * (std::cos(w * t) - 1.0); }
  double ground_velocity(double t) const { return -force / (mass * w) * std::sin(w * t); }
  /// -cos(w t) = sin(w t - pi/2).
  oracles::HarmonicSlider exact() const {
    return {force / mass, w, friction * g, until, -0.5 * std::numbers::pi};
  }

  engine::Scene scene() const {
    engine::Scene s = block_on_ground(half_width, half_height, friction, young_modulus);
    s.gravity.y = -g;
    s.bodies[0].mass = mass;
    // In equilibrium: h W / (2 b E).
    s.bodies[0].position.y -= half_height * mass * g / (2.0 * half_width * young_modulus);
    const StickSlip c = *this;
    s.terrains[0].motion = horizontal_motion([c](double t) { return -c.force / c.mass * std::cos(c.w * t); },
                                             [c](double t) { return c.ground_velocity(t); },
                                             [c](double t) { return c.ground_displacement(t); });
    return s;
  }
};

struct MeasuredSlip {
  double start, end, sense, from, to, peak_speed;  // s, s, -, m, m, m/s
};

struct StickSlipHistory {
  std::vector<double> times, places, speeds;  // s, m, m/s: relative to the ground
  std::vector<MeasuredSlip> slips;
};

/// A slip lasts as long as the ground's pull on the block is Coulomb's limit.
inline StickSlipHistory measured(const StickSlip& c) {
  Running r(c.scene());
  StickSlipHistory h;
  const double limit = c.friction * c.mass * c.g;
  bool slipping = false;
  auto options = run_for(c.until, c.output_interval);
  options.step_fraction = c.step_fraction;
  r.run(options, [&](const engine::Sample& sample) {
    const double t = sample.state.time, place = r.position().x - c.ground_displacement(t);
    const double speed = r.velocity().x - c.ground_velocity(t);
    h.times.push_back(t), h.places.push_back(place), h.speeds.push_back(speed);
    const bool slips = std::abs(sample.terrain_reaction.x) > 0.99999 * limit;
    if (slips && !slipping)
      h.slips.push_back({t, t, sample.terrain_reaction.x < 0.0 ? 1.0 : -1.0, place, place, 0.0});
    if (slips) {
      MeasuredSlip& slip = h.slips.back();
      slip.end = t, slip.to = place, slip.peak_speed = std::max(slip.peak_speed, std::abs(speed));
    }
    slipping = slips;
    return engine::Wish::go_on;
  });
  return h;
}

}  // namespace dougong::scenes
