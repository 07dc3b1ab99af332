// Small scenes whose errors are known, for tests of the tradeoff.
#pragma once

#include <string>

#include "app/study/scene_file.h"
#include "app/study/tradeoff/tradeoff.h"
#include "tests/app/box_that_lands.h"

namespace dougong::app {

inline const std::filesystem::path shipped_records = DOUGONG_RECORDS_DIRECTORY;

/// Two bodies on an ellipse of eccentricity 0.3, once around (period 2 pi).
inline const std::string orbit = R"toml(
title = "an orbit"
gravity = "none"
[[body]]
name = "sun"
shape = "circle"
radius = "0.01 m"
mass = "1 kg"
collides = false
[[body]]
name = "planet"
shape = "circle"
radius = "0.01 m"
mass = "1e-9 kg"
position = ["0.7 m", "0 m"]
velocity = ["0 m/s", "1.36277029 m/s"]
collides = false
[fields]
gravitational_constant = "1 m3/(kg s2)"
[solve]
duration = "6.4 s"
[output]
rate = "5 Hz"
)toml";

inline TradeoffChoice with(std::vector<std::string> integrators, std::vector<double> steps) {
  TradeoffChoice choice;
  choice.ladder.integrators = std::move(integrators);
  choice.ladder.steps = std::move(steps);
  choice.ladder.tolerances = {1e-6, 1e-8};
  choice.ladder.stiffnesses = {1.0};
  choice.members = 0;
  return choice;
}

inline Tradeoff traded(const std::string& scene, const TradeoffChoice& choice,
                       const TradeoffObserver& progress = {}) {
  return run_tradeoff(read_scene(scene, "s.toml"), shipped_records, choice, progress);
}

}  // namespace dougong::app
