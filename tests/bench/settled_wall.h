// The wall S1 in equilibrium, ready to be shaken, and what a run of it costs. Processor time of one core.
#pragma once

#include <ctime>

#include "engine/settle.h"
#include "tests/scenes/running.h"
#include "tests/scenes/running_bond.h"

namespace dougong::bench {

struct Wall {
  engine::Model model;
  engine::State settled;
};

inline Wall settle(const engine::Scene& scene) {
  Wall wall{engine::compile(scene), {}};
  wall.settled = engine::initial_state(wall.model, scene);
  engine::settle(wall.model, wall.settled);
  return wall;
}

/// S1, of such a stiffness that it settles by so much (m), shaken at 2 Hz by so many g.
inline engine::Scene s1_scene(double settlement, double amplitude, double damping_ratio = 0.3) {
  scenes::RunningBond brickwork;
  brickwork.damping_ratio = damping_ratio;
  brickwork.young_modulus *= scenes::settlement(brickwork) / settlement;
  return scenes::running_bond(brickwork, scenes::sine_motion(9.81 * amplitude, 2.0));
}

struct Cost {
  engine::RunOutcome run;
  double cpu = 0.0;        // s
  std::size_t points = 0;  // of contact, at the end
  double per_simulated_second() const { return cpu / run.end_time; }
  double per_step() const { return cpu / static_cast<double>(run.steps); }  // s
};

/// From the settled state on, which is left as it is.
inline Cost run(const Wall& wall, const engine::DriveOptions& options, const engine::Observer& observe = {}) {
  engine::State state = wall.settled;
  Cost cost;
  const std::clock_t start = std::clock();
  cost.run = engine::drive(wall.model, state, options, observe);
  cost.cpu = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  cost.points = state.contacts.points.size();
  return cost;
}

}  // namespace dougong::bench
