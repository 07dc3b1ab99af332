#include "app/study/scene_override.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/study/scene_keys.h"
#include "structures/nearest_name.h"

namespace dougong::app {
namespace {

std::vector<std::string> words_of(const std::string& key) {
  std::vector<std::string> words;
  for (std::size_t from = 0; from <= key.size();) {
    const std::size_t dot = std::min(key.find('.', from), key.size());
    words.push_back(key.substr(from, dot - from));
    from = dot + 1;
  }
  return words;
}

/// "section.key" for every key of a section there is once.
std::vector<std::string> single_keys() {
  std::vector<std::string> names;
  for (const DocumentedKey& key : documented_scene_keys()) {
    const bool single = key.section == "solve" || key.section == "output" || key.section == "fields" ||
                        key.section == "contact" || key.section.empty();
    if (single) names.push_back(key.section.empty() ? key.name : key.section + "." + key.name);
  }
  return names;
}

std::string leaf_of(const std::string& name) {
  return name.substr(name.find('.') + 1);
}

class Overrider {
 public:
  Overrider(Entry& root, const Override& change) : root_(root), entry_(entry_of_override(change)) {}

  void apply() {
    std::vector<std::string> words = words_of(completed(entry_.key));
    Entry* here = &root_;
    for (std::size_t i = 0; i + 1 < words.size(); ++i) here = &inner(*here, words[i]);
    set(*here, words.back());
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw ScenarioError({{entry_.key_where, message}});
  }

  /// A single word may be the last one of a key that is there once, and have - for _.
  std::string completed(const std::string& typed) const {
    if (typed.find('.') != std::string::npos) return typed;
    std::string word = typed;
    std::ranges::replace(word, '-', '_');
    std::vector<std::string> leaves, meant;
    for (const std::string& name : single_keys()) {
      leaves.push_back(leaf_of(name));
      if (leaf_of(name) == word) meant.push_back(name);
    }
    if (meant.size() == 1) return meant.front();
    const std::string nearest = structures::nearest_name(word, leaves);
    fail(fmt::format("unknown key \"{}\"{}", typed,
                     nearest.empty() ? "; write it in full: solve.duration, body.NAME.mass"
                                     : fmt::format("; did you mean \"{}\"?", nearest)));
  }

  Entry& inner(Entry& here, const std::string& word) const {
    if (auto* list = std::get_if<ListValue>(&here.value)) return listed(here.key, *list, word);
    auto* table = std::get_if<TableValue>(&here.value);
    if (!table) fail(fmt::format("\"{}\" holds a value, not keys", here.key));
    const auto it = std::ranges::find(table->items, word, &Entry::key);
    if (it != table->items.end()) return *it;
    table->items.push_back(made(word, TableValue{}));
    return table->items.back();
  }

  /// By its name, or by its number counted from one.
  Entry& listed(const std::string& section, ListValue& list, const std::string& word) const {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < list.items.size(); ++i) {
      names.push_back(name_of_item(list.items[i], section, i));
      if (names.back() == word || std::to_string(i + 1) == word) return list.items[i];
    }
    const std::string nearest = structures::nearest_name(word, names);
    fail(fmt::format("there is no {} \"{}\"{}", section, word,
                     nearest.empty() ? "" : fmt::format("; did you mean \"{}\"?", nearest)));
  }

  static std::string name_of_item(const Entry& item, const std::string& section, std::size_t i) {
    if (const auto* table = std::get_if<TableValue>(&item.value))
      for (const Entry& entry : table->items)
        if (const auto* name = std::get_if<std::string>(&entry.value); name && entry.key == "name")
          return *name;
    return fmt::format("{}{}", section, i + 1);
  }

  Entry made(const std::string& key, decltype(Entry::value) value) const {
    Entry entry = entry_;
    entry.key = key;
    entry.value = std::move(value);
    return entry;
  }

  void set(Entry& here, const std::string& key) const {
    auto* table = std::get_if<TableValue>(&here.value);
    if (!table) fail(fmt::format("expected a key of \"{}\": {}.NAME.KEY", here.key, here.key));
    std::erase_if(table->items, [&](const Entry& entry) { return entry.key == key; });
    table->items.push_back(made(key, entry_.value));
  }

  Entry& root_;
  Entry entry_;
};

}  // namespace

void apply_scene_overrides(Entry& root, const std::vector<Override>& overrides) {
  std::vector<LocatedMessage> errors;
  for (const Override& change : overrides) {
    try {
      Overrider(root, change).apply();
    } catch (const ScenarioError& error) {
      errors.insert(errors.end(), error.messages().begin(), error.messages().end());
    }
  }
  if (!errors.empty()) throw ScenarioError(std::move(errors));
}

}  // namespace dougong::app
