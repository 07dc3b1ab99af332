#include "app/study/modes_study.h"

#include <algorithm>
#include <cmath>

namespace dougong::app {

ModesResult modes_of(const Scenario& scenario, std::size_t count) {
  ModesResult result;
  result.building = building_of(scenario);
  checked_findings(result.building);
  result.model = model_sheet(result.building);
  const engine::Model model = engine::compile(result.building.scene);
  engine::State state = engine::initial_state(model, result.building.scene);
  result.settle = engine::settle(model, state);
  if (result.settle.settled) result.modes = engine::horizontal_modes(model, state, count);
  return result;
}

double horizontal_size(const engine::Mode& mode, std::size_t blocks) {
  double size = 0.0;
  for (std::size_t i = 0; i < blocks; ++i) size = std::max(size, std::abs(mode.shape[i]));
  return size > 0.0 ? size : 1.0;
}

}  // namespace dougong::app
