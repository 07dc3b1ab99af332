// What a scene says that is accepted and perhaps not meant: bodies that overlap at the start, outputs at
// other times, keys that make no difference here. Keys that contradict what stands beside them are errors
// instead (scene_ignored.h).
#pragma once

#include <string>
#include <vector>

#include "app/study/scene_run.h"

namespace dougong::app {

/// Of a scene that is compiled and at its start.
std::vector<std::string> findings_of(const PreparedScene& scene);

}  // namespace dougong::app
