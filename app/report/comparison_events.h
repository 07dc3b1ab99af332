// The moments at which all variants are drawn on one motion, side by side.
#pragma once

#include <vector>

#include "app/report/scene.h"
#include "app/study/run_result.h"

namespace dougong::app {

/// Times that tell the runs apart, the same for all: start, strongest shaking, peak drifts, first losses,
/// end.
std::vector<double> common_moments(const std::vector<RunResult>& runs, std::size_t most);
/// A run at these times, each with what it is in this run. After its end, its last state.
std::vector<Frame> frames_at(const RunResult& run, const std::vector<double>& times);
/// The same camera, magnification and colours for all.
SceneView common_view(const std::vector<RunResult>& runs, const std::vector<double>& times);

}  // namespace dougong::app
