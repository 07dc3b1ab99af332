// Experiment M01: a granite boulder on a shaking table as a plane block whose restitution is given, run by
// the contact engine and by the event-driven solution of the rigid block.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "seismic/read_record.h"
#include "tests/oracles/driven_rocking.h"
#include "tests/oracles/synthetic_record.h"
#include "tests/scenes/record_motion.h"
#include "tests/scenes/rocking.h"

namespace dougong::scenes {

struct BoulderTrial {
  std::string name;
  double pga = 0.0, pgv_over_pga = 0.0;  // g, s: as published
  bool overturned = false;               // as tested
  std::vector<double> ground;            // m/s2
  double interval = 0.0;                 // s
  oracles::RockingHistory by_engine, by_events;
};

/// The parameters given with the tests; 30 GPa and a damping ratio of 1 are ours.
struct Boulder {
  double young_modulus = 30e9, damping_ratio = 1.0;
  double alpha = 0.06, p = 5.0, restitution = 0.70;

  oracles::RockingBlock rigid() const {
    const double g = 9.81, radius = 0.75 * g / (p * p);
    oracles::RockingBlock block{radius * std::sin(alpha), radius * std::cos(alpha), g};
    block.restitution = restitution;
    return block;
  }
};

/// The runs of FOLDER/index.csv and their motions TestNNN.AT2 (g, 200 Hz).
inline std::vector<BoulderTrial> read_boulder_trials(const std::string& folder) {
  std::vector<BoulderTrial> trials;
  std::ifstream index(folder + "/index.csv");
  std::string line;
  std::getline(index, line);
  while (std::getline(index, line)) {
    std::vector<std::string> cells;
    std::stringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    BoulderTrial trial;
    trial.name = fmt::format("Test{:0>3}", cells.at(0));
    trial.pga = std::stod(cells.at(2)), trial.pgv_over_pga = std::stod(cells.at(3));
    trial.overturned = cells.at(4) == "1";
    const auto set = seismic::read_record(folder + "/" + trial.name + ".AT2");
    trial.ground = set.horizontal().acceleration, trial.interval = set.horizontal().interval;
    trials.push_back(std::move(trial));
  }
  if (trials.empty()) throw std::runtime_error("no trials in " + folder + "/index.csv");
  return trials;
}

inline void run_boulder(const Boulder& block, BoulderTrial& trial) {
  constexpr double rest = 5.0;  // s, after the motion
  const oracles::RockingBlock rigid = block.rigid();
  const double duration = trial.interval * static_cast<double>(trial.ground.size() - 1);
  const auto ground = [&](double t) { return oracles::interpolated(trial.ground, trial.interval, t); };
  trial.by_events = oracles::DrivenRocking(rigid, ground, trial.interval / 5.0).run(duration + rest);
  auto shaken = rocking_run(rigid, block.young_modulus, block.damping_ratio,
                            record_motion(trial.ground, trial.interval), duration, duration + rest);
  shaken.scene.materials[0].rocking_restitution = block.restitution;
  trial.by_engine = measured_rocking(shaken);
}

}  // namespace dougong::scenes
