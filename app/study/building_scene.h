// Buildings as scene files: a layout written out, block by block, and a building by hand read back.
//
// A scene that lists its storeys ([[storey]]) is a building: its first terrain is the ground, and every
// storey names its blocks. A scenario takes it instead of a layout by layout.file.
#pragma once

#include <filesystem>

#include "app/study/scene_description.h"
#include "structures/building.h"

namespace dougong::app {

/// All that the building has, so that its scene is built again from it to rounding.
SceneDescription description_of(const structures::Building& building);

/// Throws ScenarioError for a scene that is no building: without storeys, with motions or bodies that move.
structures::Building building_of(const SceneDescription& description, const std::string& source);
structures::Building load_building(const std::filesystem::path& path);

}  // namespace dougong::app
