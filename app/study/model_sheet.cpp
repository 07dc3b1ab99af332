// What the report and the terminal say of the model.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "app/study/prepare.h"
#include "app/study/run_sheets.h"

namespace dougong::app {
namespace {

void add_storeys(const structures::Building& building, ModelSheet& sheet) {
  for (std::size_t s = 0; s < building.storeys.size(); ++s) {
    const structures::Storey& storey = building.storeys[s];
    StoreySheet row{storey.name, storey.base, storey.height, 0.0, storey.storey_blocks.size()};
    for (const std::size_t block : storey.storey_blocks) {
      row.mass += sheet.blocks[block].mass;
      sheet.blocks[block].storey = static_cast<int>(s);
    }
    sheet.storeys.push_back(row);
  }
}

/// Of the layout's own, or of what stands on or beside it ("on.storeys").
std::string meaning_of(const structures::Building& building, const std::string& name) {
  const std::size_t dot = name.find('.');
  const std::string parameter = dot == std::string::npos ? name : name.substr(dot + 1);
  const auto companion = building.parameters.find(name.substr(0, dot) + ".name");
  const structures::Layout* known = structures::known_layout(
      dot == std::string::npos || companion == building.parameters.end() ? building.layout
                                                                         : companion->second);
  const structures::Parameter* p = known ? known->parameter(parameter) : nullptr;
  return p ? p->meaning : "";
}

std::string summary_of(const structures::Building& building) {
  const structures::Layout* known = structures::known_layout(building.layout);
  std::string summary = known ? known->summary : "a building by hand";
  for (const auto& [key, words] :
       {std::pair{"on.name", "with a layout on a floor: "}, {"beside.name", "beside it: "}})
    if (const auto it = building.parameters.find(key); it != building.parameters.end())
      summary += fmt::format("; {}{}", words, it->second);
  return summary;
}

std::vector<std::string> modelled_terms(const Preparation& p) {
  std::vector<std::string> terms{
      fmt::format("{} rigid blocks with three degrees of freedom each, large displacements and rotations",
                  p.model.body_count),
      "contact of every block with every other and the ground: springs from the Young's moduli and block "
      "heights in "
      "series, dashpots from the damping ratio, never tensile",
      "Coulomb friction with an elastic spring: a block that sticks does not creep",
      "uniform gravity of 9.80665 m/s2",
      p.motion.ground->vertical()
          ? "ground motion, horizontal and vertical, as absolute displacement of the ground"
          : "ground motion, horizontal, as absolute displacement of the ground"};
  if (!p.building.scene.bonds.empty())
    terms.push_back(
        fmt::format("{} bonded faces, each of two springs with the stiffness of the blocks between them, "
                    "that yield, soften "
                    "or break",
                    p.building.scene.bonds.size()));
  if (!p.building.scene.joints.empty())
    terms.push_back(
        fmt::format("{} joints: springs and dashpots that never break", p.building.scene.joints.size()));
  return terms;
}

/// What the bonds leave out.
std::string missing_of_bonds(const engine::Scene& scene) {
  if (scene.bonds.empty()) return "mortar, ties, reinforcement and other bonds: the assembly is dry";
  const bool crush = std::ranges::any_of(
      scene.bonds, [](const auto& bond) { return std::isfinite(bond.compressive_strength); });
  const std::string crushing =
      crush ? "crushing of a face that has cracked, which is told and changes nothing" : "crushing";
  return crushing + ", and rupture of what yields: a ductile bond never tears";
}

std::vector<std::string> missing_terms(const Preparation& p) {
  std::vector<std::string> terms{
      "deformation, cracking and crushing within a block: blocks are rigid, their elasticity acts at the "
      "contacts",
      "out-of-plane motion and torsion: the model is plane", missing_of_bonds(p.building.scene),
      "soil flexibility and soil-structure interaction: the ground is rigid and moves as prescribed"};
  if (!p.motion.ground->vertical()) terms.push_back("vertical ground motion");
  return terms;
}

}  // namespace

std::string storey_of(const ModelSheet& model, const DrawnBond& bond) {
  const int storey = bond.owner < model.blocks.size() ? model.blocks[bond.owner].storey : -1;
  return storey < 0 ? "" : model.storeys.at(static_cast<std::size_t>(storey)).name;
}

ModelSheet model_sheet(const structures::Building& building) {
  ModelSheet sheet;
  sheet.layout = building.layout;
  sheet.title = summary_of(building);
  for (const auto& [name, value] : building.parameters)
    sheet.parameters.push_back({name, value, meaning_of(building, name)});
  for (const engine::Material& m : building.scene.materials) sheet.materials.push_back(material_sheet(m));
  for (const engine::Body& body : building.scene.bodies) {
    sheet.blocks.push_back(drawn_shape(body, building.scene));
    sheet.mass += sheet.blocks.back().mass;
  }
  for (const engine::Terrain& terrain : building.scene.terrains)
    sheet.terrains.push_back(drawn_shape(terrain, building.scene));
  draw_connections(building.scene, sheet);
  add_storeys(building, sheet);
  return sheet;
}

ModelSheet model_sheet(const Preparation& p) {
  ModelSheet sheet = model_sheet(p.building);
  sheet.contact_points = p.contact_points;
  sheet.period = p.period;
  sheet.period_participation = p.participation;
  sheet.modelled = modelled_terms(p);
  sheet.not_modelled = missing_terms(p);
  for (const structures::Finding& finding : p.findings)
    sheet.findings.push_back(to_string(finding.severity) + ": " + finding.message);
  return sheet;
}

}  // namespace dougong::app
