#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/model_picture.h"
#include "app/cli/scene_session.h"
#include "app/cli/scene_text.h"
#include "app/study/entries.h"
#include "app/study/scene_file.h"

namespace dougong::app {
namespace {

namespace fs = std::filesystem;

std::vector<Override> overrides_of(const std::vector<std::string>& set) {
  std::vector<Override> overrides;
  for (const std::string& text : set) overrides.push_back(parse_override(text));
  return overrides;
}

SceneDescription description_of(const SceneOptions& options) {
  return load_scene(options.file, overrides_of(options.set));
}

void print(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) fmt::print("{}\n", line);
}

void describe_scene(const fs::path& file, const std::vector<Override>& overrides) {
  const PreparedScene scene = prepare_scene(load_scene(file, overrides), records_directory());
  print(scene_text(scene));
  fmt::print("{}\n", cost_text(scene));
  for (const std::string& term : modelled_terms(scene)) fmt::print("{}\n", row("+", term));
  for (const std::string& term : missing_terms(scene)) fmt::print("{}\n", row("-", term));
}

void describe_scenario(const fs::path& file, const std::vector<Override>& overrides) {
  print(preparation_text(prepare(load_scenario(file, overrides), records_directory())));
}

}  // namespace

int scene_check_command(const SceneOptions& options) {
  const PreparedScene scene = check_scene(description_of(options), records_directory());
  print(scene_text(scene));
  if (scene.findings.empty()) fmt::print("{}: nothing wrong with it\n", options.file);
  return exit_survived;
}

int scene_run_command(const SceneOptions& options) {
  SceneDescription description = description_of(options);
  if (!options.out.empty()) description.output.directory = options.out;
  Terminal terminal(stdout);
  return run_scene_aloud(description, options.force, options.command, terminal);
}

int scene_draw_command(const SceneOptions& options) {
  const SceneDescription description = description_of(options);
  const fs::path path =
      options.out.empty() ? fs::path(fs::path(options.file).stem().string() + ".png") : fs::path(options.out);
  refuse_picture(path, "--out", options.force);
  const PreparedScene scene = check_scene(description, records_directory());
  write_model_picture(scene_sheet(description, scene.scene), path);
  fmt::print("picture: {}\n", path.string());
  return exit_survived;
}

int describe_command(const DescribeOptions& options) {
  const std::string text = load_text(options.file, "a scene or scenario file");
  const std::vector<Override> overrides = overrides_of(options.set);
  if (describes_a_scene(text, options.file))
    describe_scene(options.file, overrides);
  else
    describe_scenario(options.file, overrides);
  return exit_survived;
}

}  // namespace dougong::app
