// A wall that starts where the weight of the courses above presses every joint, for walls too large to
// settle.
#pragma once

#include "tests/bench/settled_wall.h"

namespace dougong::bench {

// A joint carries the courses above it; the lowest, on rigid ground, is twice as stiff.
inline void press(engine::Scene& scene, const scenes::RunningBond& w) {
  const double weight = w.density * w.length * w.height * -scene.gravity.y;
  const double yields = weight * w.height / (w.young_modulus * w.length);  // m, under one brick
  std::vector<double> sunk;
  for (int course = 0; course < w.courses; ++course)
    sunk.push_back((course == 0 ? 0.0 : sunk.back()) +
                   (w.courses - course) * yields * (course == 0 ? 0.5 : 1.0));
  for (engine::Body& body : scene.bodies)
    body.position.y -= sunk[static_cast<std::size_t>(body.position.y / w.height)];
}

/// Shaken like S1, by so many g.
inline Wall pressed_wall(const scenes::RunningBond& brickwork, double g) {
  engine::Scene scene = scenes::running_bond(brickwork, scenes::sine_motion(g * 9.81, 2.0));
  press(scene, brickwork);
  Wall wall{engine::compile(scene), {}};
  wall.settled = engine::initial_state(wall.model, scene);
  return wall;
}

}  // namespace dougong::bench
