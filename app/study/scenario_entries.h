// The keys and values of a scenario as they were written, each with the place it was written at, before
// anyone knows what they mean.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "app/study/scenario.h"

namespace dougong::app {

/// A value of a kind that no key takes: an array, a date.
struct OtherValue {
  std::string kind;
};

struct Entry {
  std::string key;  // dotted
  std::variant<std::string, std::int64_t, double, bool, OtherValue> value;
  std::string where;       // of the value, for messages
  std::string key_where;   // of the key
  std::uint32_t line = 0;  // of the key in the file; 0 on the command line
  bool typed = false;      // on the command line: text whose meaning the key decides
};

/// In the order of the file. Throws ScenarioError for text that is not TOML.
std::vector<Entry> entries_of_toml(const std::string& text, const std::string& source);
/// A value in quotes is unquoted; the key is left as it was typed.
Entry entry_of_override(const Override& change);

}  // namespace dougong::app
