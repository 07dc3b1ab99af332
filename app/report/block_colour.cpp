#include "app/report/block_colour.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/report/axis.h"
#include "app/report/camera.h"
#include "engine/scene.h"

namespace dougong::app {
namespace {

/// By the positions one output before and after.
double speed_of(const RunResult& run, std::size_t step, std::size_t block) {
  const auto& t = run.trajectory;
  const std::size_t from = step > 0 ? step - 1 : 0, to = std::min(step + 1, t.times.size() - 1);
  if (from == to) return 0.0;
  const engine::Vec2 way = pose_at(t, to, block, 1.0).position - pose_at(t, from, block, 1.0).position;
  return engine::norm(way) / (t.times[to] - t.times[from]);
}

double force_of(const RunResult& run, std::size_t step, std::size_t block) {
  return std::abs(run.trajectory.acceleration(step, block)) / engine::standard_gravity;
}

bool lost(const RunResult& run, std::size_t step, std::size_t block) {
  const double now = run.trajectory.times[step];
  return std::ranges::any_of(run.response.losses, [&](const structures::BlockLoss& loss) {
    return loss.block == block && loss.time <= now;
  });
}

}  // namespace

std::vector<std::string> block_colours() {
  return {"displacement", "speed", "force", "damage"};
}

BlockColour block_colour_named(const std::string& name) {
  const auto names = block_colours();
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) throw std::invalid_argument("no such colour of blocks: " + name);
  return static_cast<BlockColour>(found - names.begin());
}

double coloured_by(const RunResult& run, BlockColour colour, std::size_t step, std::size_t block) {
  switch (colour) {
    case BlockColour::displacement:
      return moved(run.trajectory, step, block);
    case BlockColour::speed:
      return speed_of(run, step, block);
    case BlockColour::force:
      return force_of(run, step, block);
    case BlockColour::damage:
      return lost(run, step, block) ? 1.0 : 0.0;
  }
  return 0.0;
}

ColourScale colour_scale(const RunResult& run, BlockColour colour, const std::vector<std::size_t>& steps) {
  if (colour == BlockColour::damage) return {1.0, "(lost)", "blocks that lost their support"};
  double largest = 0.0;
  for (const std::size_t step : steps)
    for (std::size_t block = 0; block < run.trajectory.blocks; ++block) {
      const double value = coloured_by(run, colour, step, block);
      if (std::isfinite(value)) largest = std::max(largest, value);
    }
  largest = largest > 0.0 ? round_up(largest) : 1.0;
  if (colour == BlockColour::speed) return {largest, "m/s", "speed relative to the ground"};
  return {largest, "of its weight", "horizontal inertial force of each block"};
}

}  // namespace dougong::app
