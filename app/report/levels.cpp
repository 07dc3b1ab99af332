#include "app/report/levels.h"

namespace dougong::app {

std::vector<Level> levels_of(const RunResult& run) {
  std::vector<Level> levels;
  double base = run.model.storeys.empty() ? 0.0 : run.model.storeys.front().base;
  for (std::size_t i = 0; i < run.response.storeys.size(); ++i) {
    const structures::StoreyResponse& storey = run.response.storeys[i];
    if (i < run.model.storeys.size()) base = run.model.storeys[i].base;
    if (!storey.is_base) levels.push_back({base, base + storey.height, &storey});
    base += storey.height;
  }
  return levels;
}

}  // namespace dougong::app
