// The storeys of a building as a profile draws them: each between its true heights.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/study/run_result.h"

namespace dougong::app {

struct Level {
  double base, top;                          // m
  const structures::StoreyResponse* storey;  // of the run that it was made of
};
/// From below, without the level of isolators.
std::vector<Level> levels_of(const RunResult& run);
/// The raft on isolators; nothing where a building has none.
std::optional<Level> raft_of(const RunResult& run);

}  // namespace dougong::app
