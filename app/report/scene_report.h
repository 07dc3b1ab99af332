// What a run of a free scene leaves in its folder: results.h5, scene.toml, bodies.csv, energy.csv, pictures.
// The film of a scene is that of any run (film.h).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/study/scene_run.h"

namespace dougong::app {

inline constexpr int scene_results_version = 1;

/// The bodies whose motion is kept, as indices.
std::vector<std::size_t> kept_bodies(const SceneResult& result);
bool keeps(const SceneResult& result, const std::string& quantity);

/// HDF5, SI units: /time, /bodies, /terrains, /energy, /numerics, /reproducibility. Throws FileError.
void write_scene_results(const SceneResult& result, const std::filesystem::path& path);

/// Returns the names of the files, in the folder.
std::vector<std::string> write_scene_report(const SceneResult& result,
                                            const std::filesystem::path& directory);

}  // namespace dougong::app
