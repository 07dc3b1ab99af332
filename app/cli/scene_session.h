// A scene run to its end on the terminal: prepare, run with progress and Ctrl-C, write what it leaves.
#pragma once

#include "app/cli/terminal.h"
#include "app/study/scene_description.h"

namespace dougong::app {

/// Returns the exit code. Errors are thrown; nothing is left behind then.
int run_scene_aloud(const SceneDescription& description, bool force, const std::string& command,
                    Terminal& terminal);

}  // namespace dougong::app
