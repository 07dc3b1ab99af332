// A key of a scenario or of a scene file: its name, what its value may be, and where the value lives. The
// tables of keys are what reading, writing, the suggestions for mistyped keys and the documents all follow.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/study/quantity.h"
#include "engine/vec2.h"

namespace dougong::app {

/// Least value of what must be above zero.
inline constexpr double above_zero = std::numeric_limits<double>::denorm_min();

/// Where a key's value lives. An unset optional is written "none".
using Slot =
    std::variant<std::string*, bool*, double*, std::optional<double>*, engine::Vec2*,
                 std::optional<engine::Vec2>*, std::vector<engine::Vec2>*, std::vector<std::string>*>;

struct KeyFacts {
  std::string name;                                         // "record.pga", "radius"
  std::string meaning;                                      // one line
  Dimension dimension = Dimension::ratio;                   // of a number
  double least = -std::numeric_limits<double>::infinity();  // SI, of a number; ends included
  double most = std::numeric_limits<double>::infinity();
  std::vector<std::string> choices;  // of a text; empty: any

  std::string section() const { return name.substr(0, name.find('.')); }
  std::string leaf() const { return name.substr(name.find('.') + 1); }
};

template <class Owner>
struct Key : KeyFacts {
  Slot (*slot)(Owner&) = nullptr;
};

/// "acceleration", "whole number", "true or false", "one of a, b", "text", "point (length)".
std::string kind_of(const KeyFacts& key, const Slot& slot);
/// "above 0 kg", "0 .. 0.5", "any".
std::string range_of(const KeyFacts& key, const Slot& slot);
/// The value as TOML: "\"0.4 g\"", "true", "4", "\"none\"", "[\"1 m\", \"2 m\"]".
std::string toml_value(const KeyFacts& key, const Slot& slot);

/// A number as TOML: bare for counts and ratios, else text with its unit.
std::string toml_number(double value, Dimension dimension);
std::string toml_text(const std::string& text);
/// A name as the key of a table: bare where TOML allows it, else in quotes.
std::string toml_key(const std::string& name);

template <class Owner>
std::string toml_value(const Key<Owner>& key, const Owner& owner) {
  Owner copy = owner;  // slots are for writing too
  return toml_value(key, key.slot(copy));
}
template <class Owner>
std::string default_of(const Key<Owner>& key) {
  return toml_value(key, Owner{});
}
template <class Owner>
std::string kind_of(const Key<Owner>& key) {
  Owner owner;
  return kind_of(key, key.slot(owner));
}
template <class Owner>
std::string range_of(const Key<Owner>& key) {
  Owner owner;
  return range_of(key, key.slot(owner));
}

}  // namespace dougong::app
