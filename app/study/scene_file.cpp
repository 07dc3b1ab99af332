#include "app/study/scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "app/study/key_values.h"
#include "app/study/scene_build.h"
#include "app/study/scene_keys.h"
#include "app/study/scene_override.h"
#include "structures/nearest_name.h"

namespace dougong::app {
namespace {

const std::vector<std::string> sections{"title",   "gravity", "materials", "material_pair", "body",
                                        "terrain", "joint",   "bond",      "storey",        "fields",
                                        "contact", "solve",   "output"};

const std::vector<Entry>* items_of(const Entry& entry) {
  if (const auto* table = std::get_if<TableValue>(&entry.value)) return &table->items;
  if (const auto* list = std::get_if<ListValue>(&entry.value)) return &list->items;
  return nullptr;
}

const Entry* find_item(const std::vector<Entry>& items, const std::string& key) {
  const auto it = std::ranges::find(items, key, &Entry::key);
  return it == items.end() ? nullptr : &*it;
}

// Reads the tree into a description and collects what is wrong.
class Reader {
 public:
  Reader(const Entry& root, std::string source) : root_(root), source_(std::move(source)) {}

  SceneDescription read() {
    for (const Entry& section : *items_of(root_)) read_section(section);
    name_the_nameless();
    if (errors_.empty()) place_problems(build_scene(d_).problems);
    if (!errors_.empty()) throw ScenarioError(std::move(errors_));
    return std::move(d_);
  }

 private:
  void fail(const std::string& where, const std::string& message) { errors_.push_back({where, message}); }

  // --- sections ------------------------------------------------------------------------------------

  void read_section(const Entry& section) {
    if (section.key == "title" || section.key == "gravity") return read_value(section, d_.head, "");
    if (section.key == "materials") return read_materials(section);
    if (section.key == "material_pair") return read_list(section, d_.material_pairs);
    if (section.key == "body") return read_list(section, d_.bodies);
    if (section.key == "terrain") return read_list(section, d_.terrains);
    if (section.key == "joint") return read_list(section, d_.joints);
    if (section.key == "bond") return read_list(section, d_.bonds);
    if (section.key == "storey") return read_list(section, d_.storeys);
    if (section.key == "fields") return read_table(section, d_.fields, "fields");
    if (section.key == "contact") return read_table(section, d_.contact, "contact");
    if (section.key == "solve") return read_table(section, d_.solve, "solve");
    if (section.key == "output") return read_table(section, d_.output, "output");
    fail(section.key_where, unknown(section.key, section.key, sections));
  }

  static std::string unknown(const std::string& full, const std::string& leaf,
                             const std::vector<std::string>& known) {
    const std::string nearest = structures::nearest_name(leaf, known);
    if (!nearest.empty()) return fmt::format("unknown key \"{}\"; did you mean \"{}\"?", full, nearest);
    return fmt::format("unknown key \"{}\"; there are {}", full, fmt::join(known, ", "));
  }

  void read_materials(const Entry& section) {
    const auto* table = std::get_if<TableValue>(&section.value);
    if (!table)
      return fail(section.where, "materials: expected tables [materials.NAME], found another value");
    for (const Entry& item : table->items) {
      d_.materials.emplace_back().name = item.key;
      read_table(item, d_.materials.back(), "materials." + item.key);
    }
  }

  template <class Choice>
  void read_list(const Entry& section, std::vector<Choice>& choices) {
    const auto* list = std::get_if<ListValue>(&section.value);
    if (!list)
      return fail(section.where,
                  fmt::format("{0}: expected a list of tables [[{0}]], found another value", section.key));
    for (const Entry& item : list->items) read_table(item, choices.emplace_back(), section.key);
  }

  template <class Owner>
  void read_table(const Entry& table, Owner& owner, const std::string& name) {
    const auto* items = std::get_if<TableValue>(&table.value);
    if (!items) return fail(table.where, fmt::format("{}: expected a table, found another value", name));
    for (const Entry& entry : items->items)
      if (!read_inner(entry, owner)) read_value(entry, owner, name + ".");
  }

  // --- values --------------------------------------------------------------------------------------

  template <class Owner>
  void read_value(const Entry& entry, Owner& owner, const std::string& prefix) {
    const auto keys = keys_of<Owner>();
    const auto key = std::ranges::find(keys, entry.key, &Key<Owner>::name);
    if (key == keys.end())
      return fail(entry.key_where, unknown(prefix + entry.key, entry.key, names_of<Owner>()));
    try {
      set_key(*key, entry, owner);
    } catch (const QuantityError& error) {
      fail(entry.where, fmt::format("{}{}: {}", prefix, entry.key, error.what()));
    }
  }

  template <class Owner>
  static std::vector<std::string> names_of() {
    std::vector<std::string> names;
    for (const auto& key : keys_of<Owner>()) names.push_back(key.name);
    if constexpr (std::is_same_v<Owner, BodyChoice>) names.emplace_back("parts");
    if constexpr (std::is_same_v<Owner, TerrainChoice>) names.emplace_back("motion");
    if constexpr (std::is_same_v<Owner, MotionChoice>) names.emplace_back("harmonic");
    return names;
  }

  // Tables within a table.

  template <class Owner>
  bool read_inner(const Entry&, Owner&) {
    return false;
  }
  bool read_inner(const Entry& entry, BodyChoice& body) {
    if (entry.key != "parts") return false;
    read_list(entry, body.shape.parts);
    return true;
  }
  bool read_inner(const Entry& entry, TerrainChoice& terrain) {
    if (entry.key != "motion") return false;
    read_table(entry, terrain.motion.emplace(), "motion");
    return true;
  }
  bool read_inner(const Entry& entry, MotionChoice& motion) {
    if (entry.key != "harmonic") return false;
    read_table(entry, motion.harmonic.emplace(), "harmonic");
    return true;
  }

  // --- names and places ----------------------------------------------------------------------------

  template <class Choice>
  static void name_list(std::vector<Choice>& choices, const std::string& kind) {
    for (std::size_t i = 0; i < choices.size(); ++i)
      if (choices[i].name.empty()) choices[i].name = fmt::format("{}{}", kind, i + 1);
  }
  void name_the_nameless() {
    name_list(d_.bodies, "body");
    name_list(d_.terrains, "terrain");
    name_list(d_.joints, "joint");
    name_list(d_.bonds, "bond");
    name_list(d_.storeys, "storey");
  }

  void place_problems(const std::vector<SceneProblem>& problems) {
    for (const SceneProblem& problem : problems) fail(place_of(problem), text_of(problem));
  }

  std::string text_of(const SceneProblem& p) const {
    const std::string owner = owner_name(p);
    const std::string key = p.section.empty() ? "" : p.section + (p.key.empty() ? "" : "." + p.key);
    return fmt::format("{}{}{}{}", key, owner.empty() ? "" : fmt::format(" of {}", owner),
                       key.empty() ? "" : ": ", p.message);
  }

  std::string owner_name(const SceneProblem& p) const {
    if (p.section == "body") return d_.bodies[p.index].name;
    if (p.section == "terrain") return d_.terrains[p.index].name;
    if (p.section == "joint") return d_.joints[p.index].name;
    if (p.section == "bond") return d_.bonds[p.index].name;
    return "";
  }

  /// Of the value, or of what holds it, or of the file.
  std::string place_of(const SceneProblem& p) const {
    const Entry* section = find_item(*items_of(root_), p.section);
    if (!section) return source_;
    const bool listed = p.section != "output" && p.section != "solve" && p.section != "contact";
    const auto* items = items_of(*section);
    const Entry* thing = listed && items && p.index < items->size() ? &(*items)[p.index] : section;
    return innermost(*thing, p.key).where;
  }

  /// The value of "motion.pga" in a thing, or the last of its tables that is there.
  static const Entry& innermost(const Entry& thing, const std::string& key) {
    const auto* values = items_of(thing);
    const std::size_t dot = key.find('.');
    const Entry* value = values ? find_item(*values, key.substr(0, dot)) : nullptr;
    if (!value) return thing;
    return dot == std::string::npos ? *value : innermost(*value, key.substr(dot + 1));
  }

  const Entry& root_;
  std::string source_;
  SceneDescription d_;
  std::vector<LocatedMessage> errors_;
};

/// A path in a scene file is meant from where that file lies.
void find_files_beside(const std::filesystem::path& scene_file, SceneDescription& description) {
  const std::filesystem::path folder = scene_file.parent_path();
  for (TerrainChoice& terrain : description.terrains) {
    if (!terrain.motion) continue;
    if (!terrain.motion->table.empty()) terrain.motion->table = (folder / terrain.motion->table).string();
    if (names_a_file(terrain.motion->source))
      terrain.motion->source = (folder / terrain.motion->source).string();
  }
}

}  // namespace

SceneDescription read_scene(const std::string& text, const std::string& source,
                            const std::vector<Override>& overrides) {
  Entry root = entry_tree(text, source);
  apply_scene_overrides(root, overrides);
  return Reader(root, source).read();
}

SceneDescription load_scene(const std::filesystem::path& path, const std::vector<Override>& overrides) {
  SceneDescription d = read_scene(load_text(path, "a scene file"), path.string(), overrides);
  find_files_beside(path, d);
  if (d.head.title.empty()) d.head.title = path.stem().string();
  return d;
}

bool describes_a_scene(const std::string& text, const std::string& source) {
  const Entry root = entry_tree(text, source);
  const std::set<std::string> of_scenarios{"layout",       "on",   "beside", "record",
                                           "conditioning", "loss", "verdict"};
  return std::ranges::none_of(*items_of(root),
                              [&](const Entry& entry) { return of_scenarios.contains(entry.key); });
}

}  // namespace dougong::app
