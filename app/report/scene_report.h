// What a run of a free scene leaves in its folder: results.h5, scene.toml, bodies.csv, energy.csv, pictures
// and, where ffmpeg is installed and it is asked for, a film.
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

/// Everything but the film; returns the names of the files, in the folder.
std::vector<std::string> write_scene_report(const SceneResult& result,
                                            const std::filesystem::path& directory);

/// True where ffmpeg is on the PATH.
bool can_film();
/// 25 frames a second at true speed. Throws std::runtime_error with ffmpeg's own words.
void write_film(const SceneResult& result, const std::filesystem::path& path);

}  // namespace dougong::app
