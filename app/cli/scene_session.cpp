#include "app/cli/scene_session.h"

#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/interrupts.h"
#include "app/cli/output_folder.h"
#include "app/cli/scene_text.h"
#include "app/report/film.h"
#include "app/report/scene_report.h"

namespace dougong::app {
namespace {

namespace fs = std::filesystem;

PreparedScene prepare_aloud(const SceneDescription& description, const Terminal& terminal) {
  PreparedScene scene = prepare_scene(description, records_directory());
  for (const std::string& text : scene_text(scene)) terminal.line(text);
  terminal.line(cost_text(scene));
  return scene;
}

SceneResult run_aloud(PreparedScene& scene, const std::string& command, Interrupts& interrupts,
                      Terminal& terminal) {
  interrupts.run_begins();
  SceneResult result = run_scene(scene, command, [&](const SceneProgress& progress) {
    terminal.progress(progress);
    return !interrupts.asked();
  });
  terminal.end_progress();
  return result;
}

// A film is a convenience: what keeps it from being made must not cost the results.
void film_aloud(const SceneResult& result, const fs::path& directory, std::vector<std::string>& files,
                const Terminal& terminal) {
  if (!result.output.film) return;
  if (!can_film()) return terminal.line(row("film", "left out: ffmpeg is not installed"));
  try {
    write_film(result.run, FilmOptions{.frames_a_second = 25.0}, directory / "film.mp4");
    files.emplace_back("film.mp4");
  } catch (const std::runtime_error& error) {
    terminal.line(row("film", error.what()), Tone::doubtful);
  }
}

int exit_code_of(const SceneResult& result) {
  if (!result.valid) return exit_numerically_invalid;
  return result.run.partial ? exit_undecided : exit_survived;
}

}  // namespace

int run_scene_aloud(const SceneDescription& description, bool force, const std::string& command,
                    Terminal& terminal) {
  const OutputFolder folder(description.output.directory, force);
  Interrupts interrupts(folder.made());
  PreparedScene scene = prepare_aloud(description, terminal);
  const SceneResult result = run_aloud(scene, command, interrupts, terminal);
  for (const ToneLine& line : scene_answer_text(result)) terminal.line(line.text, line.tone);
  std::vector<std::string> files = write_scene_report(result, folder.path());
  film_aloud(result, folder.path(), files, terminal);
  terminal.line(row("files", fmt::format("{} in {}", fmt::join(files, ", "), folder.path().string())));
  return exit_code_of(result);
}

}  // namespace dougong::app
