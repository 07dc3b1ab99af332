#include "app/report/levels.h"

namespace dougong::app {

namespace {

std::vector<Level> all_levels(const RunResult& run) {
  std::vector<Level> levels;
  double base = run.model.storeys.empty() ? 0.0 : run.model.storeys.front().base;
  for (std::size_t i = 0; i < run.response.storeys.size(); ++i) {
    const structures::StoreyResponse& storey = run.response.storeys[i];
    if (i < run.model.storeys.size()) base = run.model.storeys[i].base;
    levels.push_back({base, base + storey.height, &storey});
    base += storey.height;
  }
  return levels;
}

}  // namespace

std::vector<Level> levels_of(const RunResult& run) {
  std::vector<Level> levels = all_levels(run);
  std::erase_if(levels, [](const Level& level) { return level.storey->is_base; });
  return levels;
}

std::optional<Level> raft_of(const RunResult& run) {
  for (const Level& level : all_levels(run))
    if (level.storey->is_base) return level;
  return std::nullopt;
}

}  // namespace dougong::app
