// The keys of a scenario: one table that reading, writing, the suggestions for mistyped keys and
// docs/scenario.md all follow. The defaults are those of the Scenario struct.
//
// The parameters of a layout are keys of the section [layout] too; they come from the layout's table.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "app/study/quantity.h"
#include "app/study/scenario.h"

namespace dougong::app {

/// Where a key's value lives. An unset optional is written "none".
using Slot = std::variant<std::string*, bool*, double*, std::optional<double>*>;

struct ScenarioKey {
  std::string name;  // "record.pga"
  Slot (*slot)(Scenario&) = nullptr;
  std::string meaning;                                      // one line
  Dimension dimension = Dimension::ratio;                   // of a number
  double least = -std::numeric_limits<double>::infinity();  // SI, of a number; ends included
  double most = std::numeric_limits<double>::infinity();
  std::vector<std::string> choices;  // of a text; empty: any

  std::string section() const { return name.substr(0, name.find('.')); }
  std::string leaf() const { return name.substr(name.find('.') + 1); }
};

std::span<const ScenarioKey> scenario_keys();
const ScenarioKey* find_key(const std::string& name);

/// "acceleration", "whole number", "true or false", "one of a, b", "text".
std::string kind_of(const ScenarioKey& key);
/// The key's value as TOML: "\"0.4 g\"", "true", "4", "\"none\"".
std::string toml_value(const ScenarioKey& key, const Scenario& scenario);
std::string default_of(const ScenarioKey& key);

/// A number as TOML: bare for counts and ratios, else text with its unit.
std::string toml_number(double value, Dimension dimension);
std::string toml_text(const std::string& text);

}  // namespace dougong::app
