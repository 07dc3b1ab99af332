#include <fmt/format.h>

#include "app/study/key.h"
#include "app/study/scenario.h"
#include "app/study/scenario_keys.h"

namespace dougong::app {
namespace {

using structures::Layout;

std::string line(const std::string& name, const std::string& value, const std::string& meaning,
                 Comments comments) {
  const std::string comment = comments == Comments::meanings ? "  # " + meaning : "";
  return fmt::format("{} = {}{}\n", name, value, comment);
}

std::string parameter_lines(const LayoutChoice& choice, Comments comments) {
  const Layout& layout = structures::find_layout(choice.name);
  const auto values = structures::complete_parameters(layout, choice.parameters);
  std::string text;
  for (const structures::Parameter& parameter : layout.parameters)
    text += line(parameter.name, toml_number(values(parameter.name), parameter.dimension), parameter.meaning,
                 comments);
  return text;
}

}  // namespace

std::string to_toml(const Scenario& scenario, Comments comments) {
  std::string text, section;
  for (const ScenarioKey& key : scenario_keys()) {
    if (key.section() != section) text += fmt::format("{}[{}]\n", text.empty() ? "" : "\n", key.section());
    section = key.section();
    text += line(key.leaf(), toml_value(key, scenario), key.meaning, comments);
    if (key.name == "layout.name") text += parameter_lines(scenario.layout, comments);
  }
  return text;
}

}  // namespace dougong::app
