// What happened in each variant on one motion, side by side: the order of failures, and the moments at which
// all of them are drawn.
#pragma once

#include <string>
#include <vector>

#include "app/report/scene.h"
#include "app/study/run_result.h"

namespace dougong::app {

struct Event {
  double time = 0.0;  // s
  std::string what;   // "S3.column.left fell 1.30 m", "S1.mortar.4 cracked in tension", "S3 lost"
};
/// The first failures of a run in order of time: bonds that crack or break, blocks and storeys that are lost.
std::vector<Event> first_failures(const RunResult& run, std::size_t most);

/// Times that tell the runs apart, the same for all: start, strongest shaking, peak drifts, first losses,
/// end.
std::vector<double> common_moments(const std::vector<RunResult>& runs, std::size_t most);
/// A run at these times, each with what it is in this run. After its end, its last state.
std::vector<Frame> frames_at(const RunResult& run, const std::vector<double>& times);
/// The same camera, magnification and colours for all.
SceneView common_view(const std::vector<RunResult>& runs, const std::vector<double>& times);

}  // namespace dougong::app
