#include "app/study/building_scene.h"
#include "app/study/scenario.h"
#include "structures/compose.h"

namespace dougong::app {
namespace {

structures::Building built(const LayoutChoice& choice) {
  if (!choice.file.empty()) return load_building(choice.file);
  return structures::build_layout(choice.name, choice.parameters);
}

}  // namespace

structures::Building building_of(const Scenario& scenario) {
  structures::Building building = built(scenario.layout);
  if (!scenario.on.name.empty()) {
    const structures::Place place{static_cast<std::size_t>(scenario.on.level), scenario.on.place};
    building = structures::on(std::move(building), built(scenario.on), place);
  }
  if (!scenario.beside.name.empty())
    building = structures::beside(std::move(building), built(scenario.beside), scenario.beside.gap);
  return building;
}

}  // namespace dougong::app
