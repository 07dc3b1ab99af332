#include "app/study/scenario_entries.h"

#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <sstream>

namespace dougong::app {
namespace {

std::string where(const std::string& source, const toml::source_region& region) {
  return fmt::format("{}:{}:{}", source, region.begin.line, region.begin.column);
}

std::string kind_name(const toml::node& node) {
  std::ostringstream name;
  name << node.type();
  return name.str();
}

Entry entry_of_node(std::string key, const toml::key& written, const toml::node& node,
                    const std::string& source) {
  Entry entry{std::move(key), OtherValue{kind_name(node)}, where(source, node.source()),
              where(source, written.source())};
  entry.line = written.source().begin.line;
  if (const auto* text = node.as_string()) entry.value = text->get();
  if (const auto* integer = node.as_integer()) entry.value = integer->get();
  if (const auto* number = node.as_floating_point()) entry.value = number->get();
  if (const auto* flag = node.as_boolean()) entry.value = flag->get();
  return entry;
}

void add_entries(const toml::table& table, const std::string& prefix, const std::string& source,
                 std::vector<Entry>& entries) {
  for (const auto& [key, node] : table) {
    const std::string name = prefix + std::string(key.str());
    // An empty table still has a name that may be mistyped.
    if (const toml::table* inner = node.as_table(); inner && !inner->empty())
      add_entries(*inner, name + ".", source, entries);
    else
      entries.push_back(entry_of_node(name, key, node, source));
  }
}

}  // namespace

std::vector<Entry> entries_of_toml(const std::string& text, const std::string& source) {
  std::vector<Entry> entries;
  try {
    add_entries(toml::parse(text, source), "", source, entries);
  } catch (const toml::parse_error& error) {
    throw ScenarioError({{where(source, error.source()), std::string(error.description())}});
  }
  // The parser sorts by name; a reader of messages goes from top to bottom.
  std::ranges::stable_sort(entries, {}, &Entry::line);
  return entries;
}

Entry entry_of_override(const Override& change) {
  const std::string place = change.origin == "--set" ? fmt::format("--set {}={}", change.key, change.value)
                                                     : fmt::format("{} {}", change.origin, change.value);
  Entry entry{change.key, change.value, place, place, 0, true};
  const std::string& value = change.value;
  if (value.size() < 2 || (value.front() != '"' && value.front() != '\'')) return entry;
  try {
    const toml::table table = toml::parse("value = " + value);
    if (const auto* text = table["value"].as_string()) entry.value = text->get();
  } catch (const toml::parse_error&) {
    // Not a TOML string after all: taken as it was typed.
  }
  return entry;
}

}  // namespace dougong::app
