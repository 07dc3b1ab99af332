// From the description of a scene to the scene: shapes made and moved to their centroids, names turned into
// indices, materials completed from their presets.
//
// It is a pure function of the description: the same description gives the same bits. Motions need files and
// are attached afterwards.
#pragma once

#include <filesystem>

#include "app/study/motion_input.h"
#include "app/study/scene_description.h"

namespace dougong::app {

/// Something in a description that cannot be built: where it stands ("body", 3, "corners") and what is wrong.
struct SceneProblem {
  std::string section;  // "body", "materials" ...
  std::size_t index = 0;
  std::string key;  // empty: the whole thing
  std::string message;
};

struct BuiltScene {
  engine::Scene scene;
  std::vector<SceneProblem> problems;
};

BuiltScene build_scene(const SceneDescription& description);

/// The motion of one terrain, and what the results say of it.
struct TerrainMotion {
  std::shared_ptr<const engine::PrescribedMotion> motion;
  std::string title;                    // "synthetic Wenchuan-style / SYN1 / EW"
  std::string sha256;                   // of the record or table
  std::vector<std::string> processing;  // of a record
  std::vector<std::string> warnings;
  double duration = 0.0;  // s, of a record or table
};

/// Throws seismic::InputError.
TerrainMotion make_terrain_motion(const MotionChoice& choice, const std::filesystem::path& records_directory);
/// One for each terrain, empty for those that stand still; gives the scene's terrains their motions.
std::vector<TerrainMotion> attach_motions(const SceneDescription& description, engine::Scene& scene,
                                          const std::filesystem::path& records_directory);

/// True for a text that is meant as a path, not as a name of the catalogue.
bool names_a_file(const std::string& record);

}  // namespace dougong::app
