#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/model_picture.h"
#include "app/cli/terminal.h"
#include "app/report/text.h"
#include "app/study/prepare.h"
#include "app/study/quantity.h"

namespace dougong::app {
namespace {

std::string printed(const structures::Parameter& p, double value) {
  return print_quantity(value, p.dimension);
}

void print_parameters(const structures::Layout& layout, const structures::ParameterMap& values) {
  fmt::print("{:<20}{:>12}{:>12}   {:<26}{}\n", "parameter", "value", "default", "range", "meaning");
  for (const structures::Parameter& p : layout.parameters)
    fmt::print("{:<20}{:>12}{:>12}   {:<26}{}\n", p.name, printed(p, values.at(p.name)),
               printed(p, p.standard), printed(p, p.least) + " .. " + printed(p, p.most), p.meaning);
}

}  // namespace

int layouts_command() {
  fmt::print("{:<20}{:>8}{:>9}{:>10}   {}\n", "layout", "blocks", "storeys", "mass", "what it is");
  for (const structures::Layout& layout : structures::layouts()) {
    const ModelSheet sheet = model_sheet(structures::build_layout(layout.name));
    fmt::print("{:<20}{:>8}{:>9}{:>10}   {}\n", layout.name, sheet.blocks.size(), sheet.storeys.size(),
               mass_text(sheet.mass), layout.summary);
  }
  fmt::print("\nParameters and a picture of one: dougong layout show NAME\n");
  return exit_survived;
}

int layout_show_command(const LayoutShowOptions& options) {
  std::vector<Override> overrides{{"layout.name", options.name, "layout show"}};
  for (const std::string& text : options.set) overrides.push_back(parse_override(text));
  const Scenario scenario = scenario_from(overrides, RecordRule::optional);
  const structures::Layout& layout = structures::find_layout(scenario.layout.name);
  const std::filesystem::path path = options.picture.empty() ? layout.name + ".png" : options.picture;
  refuse_picture(path, "--picture", options.force);
  const structures::Building building = structures::build_layout(layout.name, scenario.layout.parameters);
  const ModelSheet sheet = model_sheet(building);

  fmt::print("{}: {}\n{}\n\n", layout.name, layout.summary, layout.counting);
  print_parameters(layout, scenario.layout.parameters);
  fmt::print("\n{} blocks, {}, {} storeys\n", sheet.blocks.size(), mass_text(sheet.mass),
             sheet.storeys.size());
  for (const structures::Finding& finding : structures::check_model(building))
    fmt::print("{}: {}\n", to_string(finding.severity), finding.message);
  write_model_picture(sheet, path);
  fmt::print("picture: {}\n", path.string());
  return exit_survived;
}

}  // namespace dougong::app
