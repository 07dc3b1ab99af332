#include "app/report/film.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "app/report/film_instruments.h"
#include "app/report/safe_file.h"
#include "app/report/subprocess.h"

namespace dougong::app {
namespace {

namespace fs = std::filesystem;

constexpr double film_width = 960.0;   // px
constexpr double caption_lasts = 1.0;  // s of the film

/// What happened last, as long as it is news.
std::string caption_at(const RunResult& run, double time, const FilmOptions& options) {
  std::string caption;
  for (const Moment& moment : run.moments)
    if (moment.time <= time + 1e-9 && time - moment.time < caption_lasts / options.slow)
      caption = moment.caption;
  if (options.slow == 1.0) return caption;
  const std::string speed = options.slow > 1.0 ? fmt::format("{:g} times slowed", options.slow)
                                               : fmt::format("{:g} times faster", 1.0 / options.slow);
  return (caption.empty() ? "" : caption + "; ") + speed;
}

// Even sizes, which the usual encoding of films needs.
Image evened(const Image& image) {
  Image even(image.width + image.width % 2, image.height + image.height % 2);
  even.paste(image, 0, 0);
  return even;
}

void colour_by(const RunResult& run, const std::vector<Frame>& frames, BlockColour colour, SceneView& view) {
  std::vector<std::size_t> steps;
  for (const Frame& frame : frames) steps.push_back(frame.step);
  const ColourScale scale = colour_scale(run, colour, steps);
  view.colour = colour, view.largest = scale.largest;
  view.unit = scale.unit, view.meaning = scale.meaning;
}

void run_ffmpeg(const fs::path& folder, double frames_a_second) {
  const bool ended_well =
      run_in(folder,
             {"ffmpeg", "-y", "-loglevel", "error", "-framerate", fmt::format("{:g}", frames_a_second), "-i",
              "frame%06d.png", "-pix_fmt", "yuv420p", "-movflags", "+faststart", "film.mp4"},
             "/dev/null");
  if (!ended_well)
    throw std::runtime_error("ffmpeg could not make the film: " + read_file(folder / messages_name));
}

}  // namespace

std::vector<Frame> film_frames(const RunResult& run, const FilmOptions& options) {
  const auto& times = run.trajectory.times;
  std::vector<Frame> frames;
  for (std::size_t i = 0; !times.empty(); ++i) {
    const double time = times.front() + static_cast<double>(i) / (options.frames_a_second * options.slow);
    if (time > times.back() + 1e-9) break;
    const auto after = std::ranges::lower_bound(times, time - 1e-9) - times.begin();
    const auto step = std::min(static_cast<std::size_t>(after), times.size() - 1);
    frames.push_back({step, times[step], caption_at(run, time, options)});
  }
  return frames;
}

SceneView film_view(const RunResult& run, const std::vector<Frame>& frames, BlockColour colour) {
  SceneView view = view_of(run, frames);
  if (colour != BlockColour::displacement) colour_by(run, frames, colour, view);
  view.scale = 1.0;
  view.width = has_instruments(run) ? film_width - drift_bars_width : film_width;
  return view;
}

Image film_image(const RunResult& run, const Frame& frame, const SceneView& view) {
  const Image scene = draw_scene(run, frame, view);
  if (!has_instruments(run)) return evened(scene);
  Image image(static_cast<int>(film_width), scene.height + motion_strip_height);
  image.paste(scene, 0, 0);
  draw_drift_bars(image, run, frame.time, scene.width, scene.height);
  draw_motion_strip(image, run, frame.time, scene.height);
  return evened(image);
}

bool can_film() {
  return on_path("ffmpeg");
}

std::size_t write_film_frames(const RunResult& run, const FilmOptions& options, const fs::path& folder) {
  make_directory(folder);
  const std::vector<Frame> frames = film_frames(run, options);
  if (frames.empty()) return 0;
  const SceneView view = film_view(run, frames, options.colour);
  for (std::size_t i = 0; i < frames.size(); ++i)
    write_file(folder / fmt::format("frame{:06d}.png", i), png_of(film_image(run, frames[i], view)));
  return frames.size();
}

void write_film(const RunResult& run, const FilmOptions& options, const fs::path& path) {
  const TemporaryDirectory folder;
  if (write_film_frames(run, options, folder.path()) == 0)
    throw std::runtime_error("no positions were stored, so there is nothing to film");
  run_ffmpeg(folder.path(), options.frames_a_second);
  write_file(path, read_file(folder.path() / "film.mp4"));
}

}  // namespace dougong::app
