// Scene files: a free scene in TOML, read into a SceneDescription and written back.
//
//   [materials.NAME]  [[material_pair]]  [[body]]  [[terrain]]  [fields]  [[joint]]  [[bond]]  [[storey]]
//   [contact]  [solve]  [output], and title and gravity outside any table
//
// Every value with a dimension is text with its unit. All errors are collected and thrown together, each with
// file, line and column. docs/scene.md lists the keys.
#pragma once

#include <filesystem>

#include "app/study/scene_description.h"

namespace dougong::app {

/// Overrides win over the text. Their keys are "solve.duration", "body.NAME.mass", "materials.NAME.friction",
/// "terrain.NAME.motion.pga", or the last word alone of a key of solve, output, fields or contact. Throws
/// ScenarioError.
SceneDescription read_scene(const std::string& text, const std::string& source,
                            const std::vector<Override>& overrides = {});
/// Paths in it are meant from the folder of the file.
SceneDescription load_scene(const std::filesystem::path& path, const std::vector<Override>& overrides = {});

/// What differs from the defaults. Reading it gives a description whose scene has the same bits.
std::string to_toml(const SceneDescription& description);

/// Whether a TOML text describes a scene (true) or a scenario. Throws ScenarioError for what is no TOML.
bool describes_a_scene(const std::string& text, const std::string& source);

}  // namespace dougong::app
