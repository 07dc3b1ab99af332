// A film of a run: 50 frames a second, at true speed or slowed. Over the picture of the building (scene.h)
// its storeys' drifts as bars at the side and the ground acceleration below, with a cursor that runs along.
#pragma once

#include <cstddef>
#include <filesystem>

#include "app/report/image.h"
#include "app/report/scene.h"

namespace dougong::app {

struct FilmOptions {
  double frames_a_second = 50.0;
  double slow = 1.0;  // 4: a second of the run takes four
  BlockColour colour = BlockColour::displacement;
};

/// The output times that are nearest to the frames; every frame with what just happened.
std::vector<Frame> film_frames(const RunResult& run, const FilmOptions& options);
/// One frame. `view`: of all of them. Of even sizes, which the usual encoding needs.
Image film_image(const RunResult& run, const Frame& frame, const SceneView& view);
/// What all frames share.
SceneView film_view(const RunResult& run, const std::vector<Frame>& frames,
                    BlockColour colour = BlockColour::displacement);

/// True where ffmpeg is on the PATH.
bool can_film();
/// MP4, H.264 where this ffmpeg has it. Throws std::runtime_error with ffmpeg's own words, and FileError.
void write_film(const RunResult& run, const FilmOptions& options, const std::filesystem::path& path);
/// The frames alone, frame000000.png and so on; returns how many. Throws FileError.
std::size_t write_film_frames(const RunResult& run, const FilmOptions& options,
                              const std::filesystem::path& folder);

}  // namespace dougong::app
