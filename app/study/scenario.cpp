#include "app/study/scenario.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/study/building_scene.h"
#include "app/study/code_screens.h"
#include "app/study/entries.h"
#include "app/study/key_values.h"
#include "app/study/scenario_keys.h"
#include "structures/nearest_name.h"

namespace dougong::app {
namespace {

using structures::Layout;
using structures::LayoutError;

std::string leaf_of(const std::string& name) {
  return name.substr(name.find('.') + 1);
}

/// The key that was probably meant; empty when none is near. In a section that exists, or without one,
/// the last words are compared, for what they share in front says nothing; else the whole names.
std::string nearest_key(const std::string& key, const std::vector<std::string>& known) {
  const std::string section = key.substr(0, key.size() - leaf_of(key).size());
  std::vector<std::string> names, leaves;
  for (const std::string& name : known) {
    if (!name.starts_with(section)) continue;
    names.push_back(name);
    leaves.push_back(leaf_of(name));
  }
  if (names.empty()) return structures::nearest_name(key, known);
  const auto it = std::ranges::find(leaves, structures::nearest_name(leaf_of(key), leaves));
  return it == leaves.end() ? "" : names[static_cast<std::size_t>(it - leaves.begin())];
}

/// Collects what is wrong while it makes a scenario from entries.
class Reader {
 public:
  Reader(std::vector<Entry> entries, std::string source, RecordRule rule)
      : entries_(std::move(entries)), source_(std::move(source)), rule_(rule) {}

  Scenario read() {
    choose_layouts();
    complete_typed_keys();
    keep_last_of_each();
    keep_one_of("record.file", "record.name");
    keep_one_of("layout.file", "layout.name");
    keep_one_of("record.pga", "record.scale");
    for (const Entry& entry : entries_) set(entry);
    require_record();
    require_filter();
    require_codes();
    complete_layouts();
    if (!errors_.empty()) throw ScenarioError(std::move(errors_));
    return scenario_;
  }

 private:
  void fail(const std::string& where, const std::string& message) { errors_.push_back({where, message}); }

  // --- which key is meant ------------------------------------------------------------------------

  /// A section that chooses a layout: its parameters are keys of the section too.
  struct Part {
    std::string section;
    LayoutChoice* choice;
    const Layout* layout = nullptr;  // null: none, or one that does not exist
  };

  Part* part_of(const std::string& key) {
    const auto it = std::ranges::find(parts_, key.substr(0, key.find('.')), &Part::section);
    return it == parts_.end() ? nullptr : &*it;
  }

  /// Its building comes from a file: no layout's parameters are its keys.
  bool names_a_file(const Part& part) const {
    const Entry* entry = find_entry(part.section + ".file");
    return entry && is_set(*entry);
  }

  /// The parameters that are keys depend on the layouts, so their names come first.
  void choose_layouts() {
    for (Part& part : parts_) {
      for (const Entry& entry : entries_) {
        if (entry.key != part.section + ".name" && !(entry.typed && entry.key == part.section)) continue;
        if (const auto* name = std::get_if<std::string>(&entry.value)) part.choice->name = *name;
      }
      const auto known = structures::layouts();
      const auto it = std::ranges::find(known, part.choice->name, &Layout::name);
      part.layout = it == known.end() ? nullptr : &*it;
    }
  }

  std::vector<std::string> known_keys() const {
    std::vector<std::string> names;
    for (const ScenarioKey& key : scenario_keys()) names.push_back(key.name);
    for (const Part& part : parts_)
      if (part.layout)
        for (const auto& parameter : part.layout->parameters)
          names.push_back(part.section + "." + parameter.name);
    return names;
  }

  /// A key of the command line may be the last word of a key, and have - for _.
  void complete_typed_keys() {
    const std::vector<std::string> known = known_keys();
    std::erase_if(entries_, [&](Entry& entry) { return entry.typed && !complete(entry, known); });
  }

  /// Also says what is wrong; false then.
  bool complete(Entry& entry, const std::vector<std::string>& known) {
    std::ranges::replace(entry.key, '-', '_');
    if (entry.key.find('.') != std::string::npos) return true;
    // A section alone stands for the key that names its choice.
    if (part_of(entry.key) || entry.key == "record") entry.key += ".name";
    if (entry.key == "output") entry.key += ".directory";
    if (entry.key.find('.') != std::string::npos) return true;
    std::vector<std::string> meant;
    for (const std::string& name : known)
      if (leaf_of(name) == entry.key) meant.push_back(name);
    // A parameter is the building's own unless the section is said.
    if (std::ranges::find(meant, "layout." + entry.key) != meant.end() && entry.key != "name")
      meant = {"layout." + entry.key};
    if (meant.size() == 1) {
      entry.key = meant.front();
      return true;
    }
    if (meant.empty())
      fail(entry.key_where, unknown_key(entry.key, known));
    else
      fail(entry.key_where,
           fmt::format("\"{}\" may be {}; write it in full", entry.key, fmt::join(meant, " or ")));
    return false;
  }

  std::string unknown_key(const std::string& key, const std::vector<std::string>& known) const {
    const std::string nearest = nearest_key(key, known);
    if (!nearest.empty()) return fmt::format("unknown key \"{}\"; did you mean \"{}\"?", key, nearest);
    const auto part = std::ranges::find(parts_, key.substr(0, key.find('.')), &Part::section);
    if (part == parts_.end() || !part->layout) return fmt::format("unknown key \"{}\"", key);
    std::vector<std::string> names;
    for (const auto& parameter : part->layout->parameters) names.push_back(parameter.name);
    return fmt::format("unknown key \"{}\"; layout {} has {}", key, part->layout->name,
                       fmt::join(names, ", "));
  }

  // --- which of several values counts -------------------------------------------------------------

  void keep_last_of_each() {
    std::vector<Entry> kept;
    for (Entry& entry : entries_) {
      std::erase_if(kept, [&](const Entry& earlier) { return earlier.key == entry.key; });
      kept.push_back(std::move(entry));
    }
    entries_ = std::move(kept);
  }

  const Entry* find_entry(const std::string& key) const {
    const auto it = std::ranges::find(entries_, key, &Entry::key);
    return it == entries_.end() ? nullptr : &*it;
  }

  void keep_one_of(const std::string& first, const std::string& second) {
    const Entry *a = find_entry(first), *b = find_entry(second);
    if (!a || !b || !is_set(*a) || !is_set(*b)) return;
    if (a->typed == b->typed) {
      fail(b->where,
           fmt::format("{} and {} exclude each other; the other is set at {}", second, first, a->where));
      return;
    }
    const std::string weaker = a->typed ? second : first;
    std::erase_if(entries_, [&](const Entry& entry) { return entry.key == weaker; });
  }

  // --- what the value is --------------------------------------------------------------------------

  void set(const Entry& entry) {
    try {
      if (const ScenarioKey* key = find_key(entry.key)) return set_key(*key, entry, scenario_);
      if (Part* part = part_of(entry.key)) {
        if (part->choice->name.empty() || names_a_file(*part))
          return fail(entry.key_where,
                      fmt::format("{}: of a layout that {}.name does not name", entry.key, part->section));
        if (!part->layout) return;  // the unknown layout is reported; its parameters cannot be judged
        if (const auto* parameter = part->layout->parameter(leaf_of(entry.key)))
          return set_parameter(*part, *parameter, entry);
      }
      fail(entry.key_where, unknown_key(entry.key, known_keys()));
    } catch (const LayoutError& error) {
      fail(entry.where, error.what());
    } catch (const QuantityError& error) {
      fail(entry.where, fmt::format("{}: {}", entry.key, error.what()));
    }
  }

  static std::string word_of(const Entry& entry, const structures::Parameter& parameter) {
    if (const auto* word = std::get_if<std::string>(&entry.value)) return *word;
    throw QuantityError(fmt::format("expected {}, in quotes", kind_of(parameter)));
  }

  static structures::ParameterValue value_of(const structures::Parameter& parameter, const Entry& entry) {
    if (parameter.is_text()) return word_of(entry, parameter);
    if (parameter.choices.empty()) return number_of(entry, parameter.dimension);
    return structures::value_of_word(parameter, word_of(entry, parameter));
  }

  /// The layout judges the value itself.
  static void set_parameter(const Part& part, const structures::Parameter& parameter, const Entry& entry) {
    const structures::ParameterValue value = value_of(parameter, entry);
    structures::complete_parameters(*part.layout, {{parameter.name, value}});
    part.choice->parameters[parameter.name] = value;
  }

  // --- what belongs together ----------------------------------------------------------------------

  /// Judged by what was written, so that a key with a mistake is not reported twice.
  void require_record() {
    const Entry *file = find_entry("record.file"), *name = find_entry("record.name");
    if (rule_ == RecordRule::optional || (file && is_set(*file)) || (name && is_set(*name))) return;
    fail(source_, "no record: give record.file (a path) or record.name (of the catalogue)");
  }

  /// What a filter that is switched off would not look at.
  void require_filter() {
    if (scenario_.conditioning.filter) return;
    for (const char* name : {"conditioning.high_pass", "conditioning.low_pass", "conditioning.filter_order",
                             "conditioning.filter_phase"}) {
      const Entry* entry = find_entry(name);
      const ScenarioKey& key = *find_key(name);
      if (entry && is_set(*entry) && toml_value(key, scenario_) != default_of(key))
        fail(entry->where, fmt::format("{}: of the filter, which is switched off", name));
    }
  }

  void require_codes() {
    try {
      chosen_screens(scenario_.screening.codes);
    } catch (const std::invalid_argument& error) {
      const Entry* entry = find_entry("screening.codes");
      fail(entry ? entry->where : source_, fmt::format("screening.codes: {}", error.what()));
    }
  }

  /// Builds each once, then all of it: only layouts know which values do not fit each other.
  void complete_layouts() {
    for (Part& part : parts_) complete_layout(part);
    if (!errors_.empty() || (scenario_.on.name.empty() && scenario_.beside.name.empty())) return;
    try {
      building_of(scenario_);
    } catch (const LayoutError& error) {
      const Entry* entry = find_entry(error.subject);
      fail(entry ? entry->where : source_, error.what());
    }
  }

  void complete_layout(Part& part) {
    LayoutChoice& choice = *part.choice;
    if (choice.name.empty() && part.section != "layout") return;
    if (!choice.file.empty()) return complete_file(choice);
    try {
      structures::find_layout(choice.name);
      if (!errors_.empty()) return;
      structures::build_layout(choice.name, choice.parameters);
      choice.parameters = structures::complete_parameters(*part.layout, choice.parameters).all();
    } catch (const LayoutError& error) {
      fail(place_of(part, error.subject), error.what());
    }
  }

  void complete_file(LayoutChoice& choice) {
    choice.name.clear();
    if (!errors_.empty()) return;
    try {
      load_building(choice.file);
    } catch (const ScenarioError& error) {
      errors_.insert(errors_.end(), error.messages().begin(), error.messages().end());
    }
  }

  std::string place_of(const Part& part, const std::string& subject) const {
    if (const Entry* entry = find_entry(part.section + "." + subject)) return entry->where;
    if (const Entry* entry = find_entry(part.section + ".name")) return entry->where;
    return source_;
  }

  std::vector<Entry> entries_;
  std::string source_;
  RecordRule rule_;
  Scenario scenario_;
  std::vector<Part> parts_{
      {"layout", &scenario_.layout}, {"on", &scenario_.on}, {"beside", &scenario_.beside}};
  std::vector<LocatedMessage> errors_;
};

/// A path in a scenario file is meant from where that file lies.
void find_files_beside(const std::filesystem::path& scenario_file, std::vector<Entry>& entries) {
  for (Entry& entry : entries) {
    const bool is_path = entry.key == "record.file" || entry.key == "layout.file";
    auto* text = is_path ? std::get_if<std::string>(&entry.value) : nullptr;
    if (text && !text->empty()) *text = (scenario_file.parent_path() / *text).string();
  }
}

Scenario read_entries(std::vector<Entry> entries, const std::string& source,
                      const std::vector<Override>& overrides, RecordRule rule) {
  for (const Override& change : overrides) entries.push_back(entry_of_override(change));
  return Reader(std::move(entries), source, rule).read();
}

}  // namespace

Scenario read_scenario(const std::string& text, const std::string& source,
                       const std::vector<Override>& overrides, RecordRule rule) {
  return read_entries(entries_of_toml(text, source), source, overrides, rule);
}

Scenario load_scenario(const std::filesystem::path& path, const std::vector<Override>& overrides,
                       RecordRule rule, const std::vector<std::string>& others) {
  const std::string text = load_text(path, "a scenario file");
  std::vector<Entry> entries = entries_of_toml(text, path.string());
  std::erase_if(entries,
                [&](const Entry& entry) { return std::ranges::find(others, entry.key) != others.end(); });
  find_files_beside(path, entries);
  return read_entries(std::move(entries), path.string(), overrides, rule);
}

Scenario scenario_from(const std::vector<Override>& overrides, RecordRule rule) {
  return read_entries({}, "command line", overrides, rule);
}

}  // namespace dougong::app
