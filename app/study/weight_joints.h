// What the joints of a building bear under its weight alone, by name.
#pragma once

#include "app/study/run_result.h"
#include "engine/state.h"

namespace dougong::app {

/// The most used first. `state` is at rest under the weight.
std::vector<WeightJoint> weight_joints(const engine::Scene& scene, const engine::Model& model,
                                       const engine::State& state);

}  // namespace dougong::app
