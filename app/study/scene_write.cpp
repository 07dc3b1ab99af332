#include <fmt/format.h>

#include "app/study/scene_file.h"
#include "app/study/scene_keys.h"

namespace dougong::app {
namespace {

/// "key = value" of everything that is not as by default, each on its line or all in braces.
template <class Owner>
std::vector<std::string> changed_values(const Owner& owner) {
  std::vector<std::string> values;
  for (const Key<Owner>& key : keys_of<Owner>()) {
    const std::string value = toml_value(key, owner);
    if (value != default_of(key)) values.push_back(fmt::format("{} = {}", key.name, value));
  }
  return values;
}

template <class Owner>
std::string lines_of(const Owner& owner) {
  std::string text;
  for (const std::string& value : changed_values(owner)) text += value + "\n";
  return text;
}

std::string in_braces(const std::vector<std::string>& values) {
  return fmt::format("{{ {} }}", fmt::join(values, ", "));
}

std::string inner_lines(const BodyChoice& body) {
  if (body.shape.parts.empty()) return "";
  std::string text = "parts = [\n";
  for (const PartChoice& part : body.shape.parts) text += "  " + in_braces(changed_values(part)) + ",\n";
  return text + "]\n";
}

std::string inner_lines(const TerrainChoice& terrain) {
  if (!terrain.motion) return "";
  std::vector<std::string> values = changed_values(*terrain.motion);
  if (terrain.motion->harmonic)
    values.push_back("harmonic = " + in_braces(changed_values(*terrain.motion->harmonic)));
  return "motion = " + in_braces(values) + "\n";
}

template <class Choice>
std::string inner_lines(const Choice&) {
  return "";
}

template <class Choice>
std::string list_text(const std::string& section, const std::vector<Choice>& choices) {
  std::string text;
  for (const Choice& choice : choices)
    text += fmt::format("\n[[{}]]\n{}{}", section, lines_of(choice), inner_lines(choice));
  return text;
}

template <class Owner>
std::string table_text(const std::string& section, const Owner& owner) {
  const std::string lines = lines_of(owner);
  return lines.empty() ? "" : fmt::format("\n[{}]\n{}", section, lines);
}

}  // namespace

std::string to_toml(const SceneDescription& d) {
  std::string text = lines_of(d.head);
  for (const MaterialChoice& material : d.materials)
    text += fmt::format("\n[materials.{}]\n{}", toml_key(material.name), lines_of(material));
  text += list_text("material_pair", d.material_pairs) + list_text("body", d.bodies) +
          list_text("terrain", d.terrains) + list_text("joint", d.joints) + list_text("bond", d.bonds) +
          list_text("storey", d.storeys);
  return text + table_text("fields", d.fields) + table_text("contact", d.contact) +
         table_text("solve", d.solve) + table_text("output", d.output);
}

}  // namespace dougong::app
