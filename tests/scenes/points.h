// Point masses for fields: bodies that nothing touches.
#pragma once

#include <string>

#include "tests/scenes/running.h"

namespace dougong::scenes {

inline engine::Body point(double mass, engine::Vec2 position, engine::Vec2 velocity = {},
                          double charge = 0.0) {
  engine::Body body;
  body.name = "point";
  body.shape = engine::make_circle(0.01);
  body.mass = mass;
  body.position = position;
  body.velocity = velocity;
  body.charge = charge;
  body.collides = false;
  return body;
}

/// No gravity, no ground, and no fields yet.
inline engine::Scene space() {
  engine::Scene s;
  s.gravity = {};
  return s;
}

/// Two bodies about their centre of mass, from the relative state given.
inline engine::Scene two_bodies(double g, double m1, double m2, engine::Vec2 apart, engine::Vec2 velocity) {
  engine::Scene s = space();
  s.fields.gravitational_constant = g;
  const double sum = m1 + m2;
  s.bodies = {point(m1, (-m2 / sum) * apart, (-m2 / sum) * velocity),
              point(m2, (m1 / sum) * apart, (m1 / sum) * velocity)};
  return s;
}

/// A cloud of `count` points in a square of side 2, reproducible, with masses of 0.5 to 1.5 kg and charges
/// of both signs.
inline engine::Scene cloud(int count, unsigned seed = 1) {
  engine::Scene s = space();
  std::uint64_t state = seed;
  const auto uniform = [&state](double low, double high) {
    state = state * 6364136223846793005ull + 1442695040888963407ull;
    return low + (high - low) * static_cast<double>(state >> 11) / 9007199254740992.0;
  };
  for (int i = 0; i < count; ++i) {
    const engine::Vec2 p{uniform(-1, 1), uniform(-1, 1)}, v{uniform(-0.1, 0.1), uniform(-0.1, 0.1)};
    s.bodies.push_back(point(uniform(0.5, 1.5), p, v, uniform(-1, 1)));
    s.bodies.back().name = "point " + std::to_string(i);
  }
  return s;
}

}  // namespace dougong::scenes
