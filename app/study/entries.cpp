#include "app/study/entries.h"

#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>
#include <tuple>

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

// Makes entries of nodes; the place of a value is what `place` says of its node.
class TreeMaker {
 public:
  explicit TreeMaker(std::string source) : source_(std::move(source)) {}

  Entry entry(std::string key, const toml::source_region& written, const toml::node& node) const {
    Entry made;
    made.key = std::move(key);
    made.value = value_of(made.key, node);
    made.where = where(source_, node.source());
    made.key_where = where(source_, written);
    made.line = written.begin.line, made.column = written.begin.column;
    return made;
  }

 private:
  using Value = decltype(Entry::value);

  Value value_of(const std::string& key, const toml::node& node) const {
    if (const auto* text = node.as_string()) return text->get();
    if (const auto* integer = node.as_integer()) return integer->get();
    if (const auto* number = node.as_floating_point()) return number->get();
    if (const auto* flag = node.as_boolean()) return flag->get();
    if (const auto* table = node.as_table()) return table_of(*table);
    if (const auto* array = node.as_array()) return list_of(key, *array);
    return OtherValue{kind_name(node)};
  }

  // The parser sorts by name; a reader of messages goes from top to bottom.
  TableValue table_of(const toml::table& table) const {
    TableValue value;
    for (const auto& [key, node] : table)
      value.items.push_back(entry(std::string(key.str()), key.source(), node));
    std::ranges::stable_sort(value.items, {},
                             [](const Entry& item) { return std::tuple(item.line, item.column); });
    return value;
  }

  ListValue list_of(const std::string& key, const toml::array& array) const {
    ListValue value;
    for (const toml::node& node : array) value.items.push_back(entry(key, node.source(), node));
    return value;
  }

  std::string source_;
};

// An empty table still has a name that may be mistyped.
void flatten(const std::string& prefix, const std::vector<Entry>& items, std::vector<Entry>& flat) {
  for (const Entry& item : items) {
    const auto* table = std::get_if<TableValue>(&item.value);
    if (table && !table->items.empty()) {
      flatten(prefix + item.key + ".", table->items, flat);
      continue;
    }
    flat.push_back(item);
    flat.back().key = prefix + item.key;
  }
}

void mark_typed(Entry& entry, const std::string& place) {
  entry.where = entry.key_where = place;
  entry.line = entry.column = 0;
  entry.typed = true;
  if (auto* list = std::get_if<ListValue>(&entry.value))
    for (Entry& item : list->items) mark_typed(item, place);
  if (auto* table = std::get_if<TableValue>(&entry.value))
    for (Entry& item : table->items) mark_typed(item, place);
}

}  // namespace

std::string load_text(const std::filesystem::path& path, const std::string& expected) {
  const auto refuse = [&](const std::string& found) {
    throw ScenarioError({{path.string(), fmt::format("expected {}, found {}", expected, found)}});
  };
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) refuse("a folder");
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse("nothing that can be read");
  const auto size = std::filesystem::file_size(path, error);
  if (!error && size > largest_text_file)
    refuse(fmt::format("a file of {} MB; at most {} MB are read", size >> 20, largest_text_file >> 20));
  return {std::istreambuf_iterator<char>(file), {}};
}

Entry entry_tree(const std::string& text, const std::string& source) {
  try {
    const toml::table table = toml::parse(text, source);
    return TreeMaker(source).entry("", table.source(), table);
  } catch (const toml::parse_error& error) {
    throw ScenarioError({{where(source, error.source()), std::string(error.description())}});
  }
}

std::vector<Entry> entries_of_toml(const std::string& text, const std::string& source) {
  const Entry tree = entry_tree(text, source);
  std::vector<Entry> entries;
  flatten("", std::get<TableValue>(tree.value).items, entries);
  std::ranges::stable_sort(entries, {}, &Entry::line);
  return entries;
}

Entry entry_of_override(const Override& change) {
  const std::string place = change.origin == "--set" ? fmt::format("--set {}={}", change.key, change.value)
                                                     : fmt::format("{} {}", change.origin, change.value);
  Entry entry{change.key, change.value, place, place, 0, 0, true};
  const std::string& value = change.value;
  if (value.size() < 2 || std::string_view("\"'[{").find(value.front()) == std::string_view::npos)
    return entry;
  try {
    const toml::table table = toml::parse("value = " + value);
    Entry parsed = TreeMaker("").entry(change.key, table.source(), *table.get("value"));
    mark_typed(parsed, place);
    return parsed;
  } catch (const toml::parse_error&) {
    // Not TOML after all: taken as it was typed.
  }
  return entry;
}

}  // namespace dougong::app
