// Keys that a scene gives and nothing would read, because of what stands beside them: the peak acceleration
// of a motion without a record, the rest length of a pin. A value passed over in silence is a
// misunderstanding, so they are errors. Keys that merely make no difference are findings (scene_findings.h).
#pragma once

#include <vector>

#include "app/study/scene_build.h"

namespace dougong::app {

std::vector<SceneProblem> ignored_keys(const SceneDescription& description);

}  // namespace dougong::app
