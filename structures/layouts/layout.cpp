#include "structures/layouts/layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/material_presets.h"
#include "structures/layouts/fittings.h"
#include "structures/layouts/parts.h"
#include "structures/nearest_name.h"

namespace dougong::structures {
namespace {

std::string sentence(const std::string& subject, const std::string& expected, const std::string& found,
                     const std::string& nearest) {
  std::string text = fmt::format("{}: expected {}, found {}", subject, expected, found);
  if (!nearest.empty()) text += fmt::format("; did you mean \"{}\"?", nearest);
  return text;
}

template <class Items>
LayoutError unknown(const std::string& subject, const std::string& kind, const std::string& found,
                    const Items& known) {
  std::vector<std::string> names;
  for (const auto& item : known) names.push_back(item.name);
  return {subject, fmt::format("{} ({})", kind, fmt::join(names, ", ")), "\"" + found + "\"",
          nearest_name(found, names)};
}

void check_word(const Parameter& parameter, double value) {
  if (value >= 0.0 && value <= parameter.most && value == std::floor(value)) return;
  throw LayoutError(parameter.name, fmt::format("one of {}", fmt::join(parameter.choices, ", ")),
                    print_number(value));
}

void check_number(const Parameter& parameter, double value) {
  const auto print = [&](double v) { return print_value(v, parameter.dimension); };
  if (!parameter.choices.empty()) return check_word(parameter, value);
  const bool within = parameter.least <= value && value <= parameter.most;  // false for NaN
  const bool whole = parameter.dimension != Dimension::count || value == std::floor(value);
  if (within && whole) return;
  const char* kind = parameter.dimension == Dimension::count ? "a whole number" : "a value";
  throw LayoutError(parameter.name,
                    fmt::format("{} from {} to {}", kind, print(parameter.least), print(parameter.most)),
                    print(value));
}

void check_value(const Parameter& parameter, const ParameterValue& value) {
  const bool wants_text = parameter.is_text(), has_text = !value.text.empty();
  if (wants_text != has_text)
    throw LayoutError(parameter.name, "a value that is " + kind_of(parameter),
                      has_text     ? "\"" + value.text + "\""
                      : wants_text ? "none"
                                   : "an empty text");
  if (!wants_text) check_number(parameter, value.number);
}

/// What a chosen material says takes the place of the layout's own defaults.
void take_material(const Layout& layout, const ParameterMap& given, ParameterMap& values) {
  const Parameter* chosen = layout.parameter("material");
  const auto it = given.find("material");
  if (!chosen || it == given.end() || it->second.number == 0.0) return;
  check_value(*chosen, it->second);
  const auto* preset =
      engine::find_material_preset(chosen->choices[static_cast<std::size_t>(it->second.number)]);
  values["young_modulus"] = preset->material.young_modulus;
  values["density"] = preset->material.density;
  values["friction"] = preset->material.friction_coefficient;
  values["damping_ratio"] = preset->material.damping_ratio;
}

std::map<std::string, std::string> words_of(const Layout& layout, const ParameterMap& values) {
  std::map<std::string, std::string> words;
  for (const Parameter& parameter : layout.parameters)
    if (parameter.is_text() || !parameter.choices.empty())
      words[parameter.name] = print_value(parameter, values.at(parameter.name));
  return words;
}

}  // namespace

Parameter choice(std::string name, std::vector<std::string> words, std::string meaning) {
  const double last = static_cast<double>(words.size()) - 1.0;
  return {std::move(name), Dimension::count, 0.0, 0.0, last, std::move(meaning), std::move(words)};
}

Parameter text(std::string name, std::string standard, std::string meaning) {
  Parameter parameter{.name = std::move(name), .meaning = std::move(meaning)};
  parameter.text = std::move(standard);
  return parameter;
}

ParameterValue standard_of(const Parameter& parameter) {
  return parameter.is_text() ? ParameterValue(parameter.text) : ParameterValue(parameter.standard);
}

std::string kind_of(const Parameter& parameter) {
  if (parameter.is_text()) return "text";
  return parameter.choices.empty() ? std::string(name_of(parameter.dimension))
                                   : fmt::format("one of {}", fmt::join(parameter.choices, ", "));
}

std::string print_value(const Parameter& parameter, const ParameterValue& value) {
  if (parameter.is_text()) return value.text;
  return parameter.choices.empty() ? print_value(value.number, parameter.dimension)
                                   : parameter.choices.at(static_cast<std::size_t>(value.number));
}

double value_of_word(const Parameter& parameter, const std::string& word) {
  const auto it = std::ranges::find(parameter.choices, word);
  if (it != parameter.choices.end()) return static_cast<double>(it - parameter.choices.begin());
  throw LayoutError(parameter.name, kind_of(parameter), "\"" + word + "\"",
                    nearest_name(word, parameter.choices));
}

LayoutError::LayoutError(std::string subject_, std::string expected_, std::string found_,
                         std::string nearest_)
    : std::invalid_argument(sentence(subject_, expected_, found_, nearest_)),
      subject(std::move(subject_)),
      expected(std::move(expected_)),
      found(std::move(found_)),
      nearest(std::move(nearest_)) {}

const Parameter* Layout::parameter(const std::string& wanted) const {
  const auto it = std::ranges::find(parameters, wanted, &Parameter::name);
  return it == parameters.end() ? nullptr : &*it;
}

const Layout* known_layout(const std::string& name) {
  const auto it = std::ranges::find(layouts(), name, &Layout::name);
  return it == layouts().end() ? nullptr : &*it;
}

const Layout& find_layout(const std::string& name) {
  const Layout* known = known_layout(name);
  if (!known) throw unknown("layout", "a known layout", name, layouts());
  return *known;
}

ParameterValues complete_parameters(const Layout& layout, const ParameterMap& given) {
  ParameterMap values;
  for (const Parameter& parameter : layout.parameters) values[parameter.name] = standard_of(parameter);
  take_material(layout, given, values);
  for (const auto& [name, value] : given) {
    const Parameter* parameter = layout.parameter(name);
    if (!parameter) throw unknown("layout " + layout.name, "one of its parameters", name, layout.parameters);
    check_value(*parameter, value);
    values[name] = value;
  }
  auto words = words_of(layout, values);
  return {std::move(values), std::move(words)};
}

Building build_layout(const std::string& name, const ParameterMap& parameters) {
  const Layout& layout = find_layout(name);
  const ParameterValues values = complete_parameters(layout, parameters);
  Building building = fitted(layout.generate(values), values);
  building.layout = layout.name;
  for (const Parameter& parameter : layout.parameters)
    building.parameters[parameter.name] = print_value(parameter, values.all().at(parameter.name));
  return building;
}

}  // namespace dougong::structures
