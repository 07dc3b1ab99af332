// summary.json: the answer of a run for other programs, as docs/summary.schema.json describes it. Every
// metric has a value, a unit and the time it happened (null where it has none); nothing is rounded.
#pragma once

#include <string>
#include <vector>

#include "app/study/run_result.h"

namespace dougong::app {

inline constexpr int summary_format_version = 1;

/// `files`: paths of the companions, relative to the folder of the summary.
std::string summary_json(const RunResult& run, const std::vector<std::string>& files);

}  // namespace dougong::app
