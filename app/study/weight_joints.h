// The joints of a building by name: what they bear under its weight alone, and what they did in a run.
#pragma once

#include "app/study/run_result.h"
#include "engine/state.h"
#include "structures/joint_response.h"

namespace dougong::app {

/// `faces` by name, the most used first.
std::vector<WeightJoint> weight_joints(const engine::Scene& scene, const engine::Model& model,
                                       const std::vector<structures::FaceLoad>& faces);

/// The more of its widest opening and its farthest slip (m).
double movement(const MovedJoint& joint);
/// Those that opened or slid farthest first.
std::vector<MovedJoint> moved_joints(const engine::Scene& scene, const engine::Model& model,
                                     const structures::JointForceRecorder& recorder,
                                     const structures::Trajectory& trajectory,
                                     const std::vector<structures::BlockLoss>& losses);

}  // namespace dougong::app
