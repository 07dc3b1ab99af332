#include "app/cli/film_aloud.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/cli/run_text.h"
#include "app/report/film.h"
#include "app/report/safe_file.h"
#include "app/study/output_times.h"

namespace dougong::app {
namespace {

namespace fs = std::filesystem;

/// Where the frames go without ffmpeg: film.mp4 -> film/.
fs::path frames_folder(const fs::path& path) {
  return fs::path(path).replace_extension();
}

void require_free(const fs::path& path, bool force) {
  std::error_code error;
  if (!force && fs::exists(path, error))
    throw FileError(path, "write the film", "it is there already; --force writes over it");
}

double longest_interval(const std::vector<double>& times) {
  double longest = 0.0;
  for (std::size_t i = 1; i < times.size(); ++i) longest = std::max(longest, times[i] - times[i - 1]);
  return longest;
}

/// Frames without a state of their own look frozen.
void say_rate(const RunResult& run, const FilmOptions& options, const Terminal& terminal) {
  const double wanted = options.frames_a_second * options.slow, has = longest_interval(run.trajectory.times);
  if (wanted * has < 1.001) return;
  const double outputs = longest_interval(output_times(run));
  const std::string more =
      wanted * outputs < 1.001 ? "" : fmt::format(" --set output.rate=\"{:.0f} Hz\"", wanted);
  terminal.line(
      row("film", fmt::format("it shows {:.0f} moments a second of the run and has {:.0f}; smoother with "
                              "--set output.state_rate=\"{:.0f} Hz\"{}",
                              wanted, 1.0 / has, wanted, more)),
      Tone::doubtful);
}

}  // namespace

void require_film_path(const FilmChoice& film, bool force) {
  if (film.path.empty()) return;
  const fs::path path = film.path;
  if (path.extension() != ".mp4")
    throw FileError(path, "write the film", "expected a file that ends in .mp4");
  std::error_code error;
  if (const fs::path folder = fs::absolute(path).parent_path(); !fs::is_directory(folder, error))
    throw FileError(path, "write the film", "no such folder: " + folder.string());
  require_free(can_film() ? path : frames_folder(path), force);
}

void film_aloud(const RunResult& run, const FilmChoice& film, const Terminal& terminal) {
  if (film.path.empty()) return;
  FilmOptions options;
  options.slow = film.slow;
  options.colour = block_colour_named(film.colour);
  const fs::path path = film.path;
  say_rate(run, options, terminal);
  terminal.line(fmt::format("Drawing {} frames of the film ...", film_frames(run, options).size()),
                Tone::faint);
  try {
    if (can_film()) {
      write_film(run, options, path);
      return terminal.line(row("film", path.string()));
    }
    const std::size_t frames = write_film_frames(run, options, frames_folder(path));
    terminal.line(row("film", fmt::format("ffmpeg is not installed: {} frames as PNG in {}, {:g} a second",
                                          frames, frames_folder(path).string(), options.frames_a_second)),
                  Tone::doubtful);
  } catch (const std::runtime_error& error) {
    terminal.line(row("film", error.what()), Tone::doubtful);
  }
}

}  // namespace dougong::app
