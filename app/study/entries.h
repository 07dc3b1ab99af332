// The keys and values of a TOML text as they were written, each with the place it was written at, before
// anyone knows what they mean.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "app/study/override.h"

namespace dougong::app {

struct Entry;
struct ListValue {
  std::vector<Entry> items;
};
/// In the order of the file.
struct TableValue {
  std::vector<Entry> items;
};
/// A value of a kind that no key takes: a date.
struct OtherValue {
  std::string kind;
};

struct Entry {
  std::string key;  // dotted where tables were flattened
  std::variant<std::string, std::int64_t, double, bool, ListValue, TableValue, OtherValue> value;
  std::string where;         // of the value, for messages
  std::string key_where;     // of the key
  std::uint32_t line = 0;    // of the key in the file; 0 on the command line
  std::uint32_t column = 0;  // too
  bool typed = false;        // on the command line: text whose meaning the key decides
};

/// The largest text that is read (bytes): a scene of a hundred thousand bodies has a tenth of it.
inline constexpr std::uintmax_t largest_text_file = std::uintmax_t{256} << 20;
/// The bytes of a text file. Throws ScenarioError for what is not there, a folder, or too large a file.
std::string load_text(const std::filesystem::path& path, const std::string& expected);

/// The whole text as one table. Throws ScenarioError for text that is not TOML.
Entry entry_tree(const std::string& text, const std::string& source);
/// The values of all tables with dotted keys, in the order of the file. Throws ScenarioError.
std::vector<Entry> entries_of_toml(const std::string& text, const std::string& source);
/// A value in quotes is unquoted, one in brackets read as TOML; the key is left as it was typed.
Entry entry_of_override(const Override& change);

}  // namespace dougong::app
