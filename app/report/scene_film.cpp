#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

#include "app/report/safe_file.h"
#include "app/report/scene.h"
#include "app/report/scene_report.h"
#include "app/report/subprocess.h"

namespace dougong::app {
namespace {

namespace fs = std::filesystem;

constexpr double frames_a_second = 25.0;
constexpr double film_width = 960.0;  // px

/// One picture every 1/25 s: the output time that is nearest.
std::vector<Frame> film_frames(const RunResult& run) {
  const auto& times = run.trajectory.times;
  std::vector<Frame> frames;
  for (std::size_t i = 0; !times.empty(); ++i) {
    const double time = times.front() + static_cast<double>(i) / frames_a_second;
    if (time > times.back() + 1e-9) break;
    const auto after = std::ranges::lower_bound(times, time - 1e-9) - times.begin();
    const auto step = std::min(static_cast<std::size_t>(after), times.size() - 1);
    frames.push_back({step, times[step], ""});
  }
  return frames;
}

// Even sizes, which the usual encoding of films needs.
Image evened(Image image) {
  Image even(image.width + image.width % 2, image.height + image.height % 2);
  even.paste(image, 0, 0);
  return even;
}

void draw_frames(const RunResult& run, const fs::path& folder) {
  const std::vector<Frame> frames = film_frames(run);
  SceneView view = view_of(run, frames);
  view.scale = 1.0;
  view.width = film_width;
  for (std::size_t i = 0; i < frames.size(); ++i)
    write_file(folder / fmt::format("frame{:06d}.png", i), png_of(evened(draw_scene(run, frames[i], view))));
}

void run_ffmpeg(const fs::path& folder) {
  const bool ended_well =
      run_in(folder,
             {"ffmpeg", "-y", "-loglevel", "error", "-framerate", "25", "-i", "frame%06d.png", "-pix_fmt",
              "yuv420p", "-movflags", "+faststart", "film.mp4"},
             "/dev/null");
  if (!ended_well)
    throw std::runtime_error("ffmpeg could not make the film: " + read_file(folder / messages_name));
}

}  // namespace

bool can_film() {
  const char* path = std::getenv("PATH");
  const std::string folders = path ? path : "";
  for (std::size_t from = 0; from <= folders.size();) {
    const std::size_t colon = std::min(folders.find(':', from), folders.size());
    const fs::path program = fs::path(folders.substr(from, colon - from)) / "ffmpeg";
    if (::access(program.c_str(), X_OK) == 0) return true;
    from = colon + 1;
  }
  return false;
}

void write_film(const SceneResult& result, const fs::path& path) {
  const TemporaryDirectory folder;
  draw_frames(result.run, folder.path());
  run_ffmpeg(folder.path());
  write_file(path, read_file(folder.path() / "film.mp4"));
}

}  // namespace dougong::app
