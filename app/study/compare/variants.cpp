#include "app/study/compare/variants.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <set>

#include "app/study/entries.h"

namespace dougong::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* origin = "--vary";

std::string trimmed(std::string text) {
  text.erase(0, text.find_first_not_of(' '));
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

// Splits at the commas that no bracket and no quote holds.
std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts(1);
  int depth = 0;
  char quote = '\0';
  for (const char c : text) {
    if (c == ',' && depth == 0 && quote == '\0') {
      parts.emplace_back();
      continue;
    }
    if (quote != '\0')
      quote = c == quote ? '\0' : quote;
    else if (c == '"' || c == '\'')
      quote = c;
    else
      depth += (c == '[' || c == '{') - (c == ']' || c == '}');
    parts.back() += c;
  }
  for (std::string& part : parts) part = trimmed(part);
  return parts;
}

// What follows the number that a text begins with; the whole text when it begins with none.
std::string after_number(const std::string& text) {
  double number = 0.0;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), number).ptr;
  return trimmed(std::string(end, text.data() + text.size()));
}

void share_unit(std::vector<std::string>& values) {
  const std::string unit = after_number(values.back());
  if (unit.empty() || unit == values.back()) return;
  for (std::string& value : values)
    if (after_number(value).empty()) value += " " + unit;
}

// --- tables of a file ----------------------------------------------------------------------------------

class FileReader {
 public:
  explicit FileReader(const fs::path& path) : folder_(path.parent_path()) {}

  std::vector<Variant> variants(const Entry& list) {
    std::vector<Variant> found;
    for (const Entry& item : std::get<ListValue>(list.value).items) {
      if (const auto* table = std::get_if<TableValue>(&item.value))
        found.push_back(variant(*table, item.where));
      else
        fail(item.where, "expected a table [[variant]]");
    }
    if (!errors_.empty()) throw ScenarioError(std::move(errors_));
    return found;
  }

 private:
  void fail(const std::string& where, const std::string& message) { errors_.push_back({where, message}); }

  Variant variant(const TableValue& table, const std::string& where) {
    Variant made;
    for (const Entry& entry : table.items) {
      if (entry.key == "name")
        made.name = text_of(entry, "a name in quotes");
      else if (entry.key == "set")
        made.overrides = overrides_of(entry);
      else
        fail(entry.key_where, fmt::format("unknown key \"{}\" of a variant; it has name and set", entry.key));
    }
    if (made.name.empty()) fail(where, "a variant without a name");
    return made;
  }

  std::string text_of(const Entry& entry, const char* expected) {
    if (const auto* text = std::get_if<std::string>(&entry.value)) return *text;
    fail(entry.where, fmt::format("{}: expected {}", entry.key, expected));
    return {};
  }

  std::vector<Override> overrides_of(const Entry& entry) {
    const auto* list = std::get_if<ListValue>(&entry.value);
    if (!list) {
      fail(entry.where, "set: expected a list of texts [\"key=value\", ...]");
      return {};
    }
    std::vector<Override> overrides;
    for (const Entry& item : list->items) add(item, overrides);
    return overrides;
  }

  void add(const Entry& item, std::vector<Override>& overrides) {
    const std::string text = text_of(item, "\"key=value\" in quotes");
    if (text.empty()) return;
    try {
      Override change = parse_override(text, item.where);
      if (change.key == "layout.file" && !change.value.empty())
        change.value = (folder_ / change.value).string();
      overrides.push_back(std::move(change));
    } catch (const ScenarioError& error) {
      errors_.insert(errors_.end(), error.messages().begin(), error.messages().end());
    }
  }

  fs::path folder_;
  std::vector<LocatedMessage> errors_;
};

}  // namespace

std::vector<Variant> variants_of_key(const std::string& text) {
  const Override all = parse_override(text, origin);
  std::vector<std::string> values = split(all.value);
  if (std::ranges::find(values, "") != values.end())
    throw ScenarioError({{fmt::format("{} {}", origin, text), "expected key = value, value ..."}});
  share_unit(values);
  std::vector<Variant> variants;
  for (const std::string& value : values)
    variants.push_back(
        {fmt::format("{} = {}", all.key, value),
         {{all.key, value, value == all.value ? origin : fmt::format("{} {} =", origin, all.key)}}});
  return variants;
}

std::vector<Variant> variants_of_file(const fs::path& scenario) {
  const std::string text = load_text(scenario, "a scenario file");
  for (const Entry& entry : entries_of_toml(text, scenario.string()))
    if (entry.key == "variant" && std::holds_alternative<ListValue>(entry.value))
      return FileReader(scenario).variants(entry);
  return {};
}

std::vector<Variant> crossed(const std::vector<Variant>& first, const std::vector<Variant>& second) {
  if (first.empty() || second.empty()) return first.empty() ? second : first;
  std::vector<Variant> all;
  for (const Variant& a : first)
    for (const Variant& b : second) {
      all.push_back({a.name + ", " + b.name, a.overrides});
      all.back().overrides.insert(all.back().overrides.end(), b.overrides.begin(), b.overrides.end());
    }
  return all;
}

std::string folder_name(const std::string& name) {
  std::string folder;
  for (const char c : name) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '_';
    if (plain)
      folder += c;
    else if (!folder.empty() && folder.back() != '-')
      folder += '-';
  }
  while (!folder.empty() && folder.back() == '-') folder.pop_back();
  // "." and ".." are other folders.
  return folder.find_first_not_of('.') == std::string::npos ? "_" + folder : folder;
}

std::vector<std::string> told_apart(std::vector<std::string> names) {
  std::set<std::string> taken;
  for (std::string& name : names) {
    std::string other = name;
    for (int i = 2; !taken.insert(other).second; ++i) other = fmt::format("{}-{}", name, i);
    name = other;
  }
  return names;
}

}  // namespace dougong::app
