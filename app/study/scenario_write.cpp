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

std::string parameter_value(const structures::Parameter& parameter, const structures::ParameterValue& value) {
  const bool number = parameter.choices.empty() && !parameter.is_text();
  return number ? toml_number(value.number, parameter.dimension) : toml_text(print_value(parameter, value));
}

std::string parameter_lines(const LayoutChoice& choice, Comments comments) {
  const Layout& layout = structures::find_layout(choice.name);
  const auto values = structures::complete_parameters(layout, choice.parameters);
  std::string text;
  for (const structures::Parameter& parameter : layout.parameters)
    text += line(parameter.name, parameter_value(parameter, values.all().at(parameter.name)),
                 parameter.meaning, comments);
  return text;
}

}  // namespace

std::string to_toml(const Scenario& scenario, Comments comments) {
  std::string text, section;
  for (const ScenarioKey& key : scenario_keys()) {
    if (key.section() != section) text += fmt::format("{}[{}]\n", text.empty() ? "" : "\n", key.section());
    section = key.section();
    text += line(key.leaf(), toml_value(key, scenario), key.meaning, comments);
    for (const auto& [last, choice] :
         {std::pair<const char*, const LayoutChoice*>{"layout.file", &scenario.layout},
          {"on.place", &scenario.on},
          {"beside.gap", &scenario.beside}})
      if (key.name == last && !choice->name.empty() && choice->file.empty())
        text += parameter_lines(*choice, comments);
  }
  return text;
}

}  // namespace dougong::app
