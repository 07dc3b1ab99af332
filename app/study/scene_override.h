// key=value of the command line, put into the tree of a scene file before it is read, so that the value is
// judged like one of the file.
#pragma once

#include "app/study/entries.h"

namespace dougong::app {

/// Throws ScenarioError with every override whose key leads nowhere.
void apply_scene_overrides(Entry& root, const std::vector<Override>& overrides);

}  // namespace dougong::app
