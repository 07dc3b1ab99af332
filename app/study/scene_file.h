// Scene files: a free scene in TOML, read into a SceneDescription and written back.
//
//   [materials.NAME]  [[material_pair]]  [[body]]  [[terrain]]  [fields]  [[joint]]  [[bond]]  [contact]
//   [solve]  [output], and title and gravity outside any table
//
// Every value with a dimension is text with its unit. All errors are collected and thrown together, each with
// file, line and column. docs/scene.md lists the keys.
#pragma once

#include <filesystem>

#include "app/study/scene_description.h"

namespace dougong::app {

/// The largest file that is read (bytes): a scene of a hundred thousand bodies has a tenth of it.
inline constexpr std::uintmax_t largest_scene_file = std::uintmax_t{256} << 20;

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

/// The bytes of a text file. Throws ScenarioError for what is not there, a folder, or too large a file.
std::string load_text(const std::filesystem::path& path, const std::string& expected);

}  // namespace dougong::app
