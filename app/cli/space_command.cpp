#include <fmt/format.h>
#include <unistd.h>

#include <iostream>
#include <sstream>

#include "app/cli/commands.h"
#include "app/cli/run_text.h"
#include "app/cli/scene_session.h"
#include "app/report/safe_file.h"
#include "app/study/entries.h"
#include "app/study/quantity.h"
#include "app/study/scene_build.h"
#include "app/study/scene_file.h"
#include "app/study/space_input.h"

namespace dougong::app {
namespace {

namespace fs = std::filesystem;

SpaceRules rules_of(const SpaceOptions& options) {
  return {options.earthquake, options.material,
          [](const MotionChoice& choice) { make_terrain_motion(choice, records_directory()); }};
}

SpaceInput read_messages(const SpaceOptions& options) {
  std::istringstream text(load_text(options.file, "a text with messages"));
  SpaceWords words(text, options.file, nullptr);
  return read_space(words, rules_of(options));
}

SpaceInput read_standard_input(const SpaceOptions& options) {
  const bool person = ::isatty(STDIN_FILENO) != 0;
  SpaceWords words(std::cin, "standard input", person ? &std::cout : nullptr);
  return read_space(words, rules_of(options));
}

double duration_of(const SpaceOptions& options) {
  if (options.duration.empty()) return SceneSolve{}.duration;
  try {
    const double duration = parse_quantity(options.duration, Dimension::time);
    if (duration > 0.0) return duration;
  } catch (const QuantityError& error) {
    throw ScenarioError({{"--duration " + options.duration, error.what()}});
  }
  throw ScenarioError({{"--duration " + options.duration, "expected a time above zero"}});
}

// A scene that lies elsewhere must still find its record.
void make_paths_absolute(SceneDescription& description) {
  for (TerrainChoice& terrain : description.terrains)
    if (terrain.motion && names_a_file(terrain.motion->source))
      terrain.motion->source = fs::absolute(terrain.motion->source).string();
}

}  // namespace

int space_command(const SpaceOptions& options) {
  const double duration = duration_of(options);
  SpaceInput input = options.file.empty() ? read_standard_input(options) : read_messages(options);
  SceneDescription& description = input.description;
  description.solve.duration = duration;
  // A motion starts from the equilibrium under gravity, not from stones just laid down.
  description.solve.settle = options.earthquake;
  description.output.film = true;
  if (!options.file.empty()) description.head.title = fs::path(options.file).stem().string();
  if (!options.out.empty()) description.output.directory = options.out;
  make_paths_absolute(description);
  Terminal terminal(stdout);
  terminal.line(row("step", choose_space_step(description, input.divisor, records_directory())));
  for (const std::string& path : input.save_paths) {
    if (!options.force && fs::exists(path))
      throw ScenarioError({{"save " + path, "the file exists; choose another name, or --force"}});
    write_file(path, to_toml(description));
    terminal.line(row("saved", path));
  }
  return run_scene_aloud(description, options.force, options.command, terminal);
}

}  // namespace dougong::app
