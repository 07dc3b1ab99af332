#include "structures/shear_drift.h"

#include <algorithm>
#include <cmath>

#include "structures/outline.h"

namespace dougong::structures {
namespace {

using engine::Vec2;

// Of a storey's height: blocks whose lowest corner is that near to the lowest of all stand on its foot.
constexpr double foot_share = 0.01;

double lowest_corner(const engine::Body& body) {
  double low = std::numeric_limits<double>::infinity();
  for (const auto& outline : outlines(body.shape, body.position, body.angle))
    for (const Vec2 corner : outline) low = std::min(low, corner.y);
  return low;
}

std::vector<std::size_t> foot_of(const Building& building, const Storey& storey) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const std::size_t block : storey.storey_blocks)
    lowest = std::min(lowest, lowest_corner(building.scene.bodies[block]));
  std::vector<std::size_t> foot;
  for (const std::size_t block : storey.storey_blocks)
    if (lowest_corner(building.scene.bodies[block]) <= lowest + foot_share * storey.height)
      foot.push_back(block);
  return foot;
}

class Base {
 public:
  Base(const Building& building, const Trajectory& trajectory, const Losses& losses,
       std::vector<std::size_t> blocks)
      : trajectory_(trajectory), losses_(losses), blocks_(std::move(blocks)) {
    for (const std::size_t block : blocks_) {
      const engine::AreaProperties area = engine::area_properties(building.scene.bodies[block].shape);
      inertia_.push_back(losses.masses[block] * area.second_moment / area.area);
    }
  }

  // phi; 0 when nothing of it stands.
  double rotation(std::size_t step) const {
    const Vec2 before = centre(0, step), after = centre(step, step);
    double sine = 0.0, cosine = 0.0;
    for (std::size_t k = 0; k < blocks_.size(); ++k) {
      const std::size_t b = blocks_[k];
      if (losses_.blocks[b].step <= step) continue;
      const Vec2 p = trajectory_.position(0, b) - before, q = trajectory_.position(step, b) - after;
      const double turn = trajectory_.angle(step, b) - trajectory_.angle(0, b);
      sine += losses_.masses[b] * cross(p, q) + inertia_[k] * std::sin(turn);
      cosine += losses_.masses[b] * dot(p, q) + inertia_[k] * std::cos(turn);
    }
    return std::atan2(sine, cosine);
  }

 private:
  // At one time, of the blocks that stand at another.
  Vec2 centre(std::size_t step, std::size_t standing_at) const {
    Vec2 sum;
    double mass = 0.0;
    for (const std::size_t b : blocks_) {
      if (losses_.blocks[b].step <= standing_at) continue;
      sum += losses_.masses[b] * trajectory_.position(step, b), mass += losses_.masses[b];
    }
    return mass > 0.0 ? (1.0 / mass) * sum : sum;
  }

  const Trajectory& trajectory_;
  const Losses& losses_;
  std::vector<std::size_t> blocks_;
  std::vector<double> inertia_;  // kg m2
};

// Of its blocks at the start (m).
double elevation(const Trajectory& trajectory, const Losses& losses, const Storey& storey) {
  double sum = 0.0, mass = 0.0;
  for (const std::size_t block : storey.level_blocks)
    sum += losses.masses[block] * trajectory.position(0, block).y, mass += losses.masses[block];
  return mass > 0.0 ? sum / mass : storey.base + storey.height;
}

}  // namespace

std::vector<double> shear_drift(const Building& building, const Trajectory& trajectory, const Losses& losses,
                                std::size_t index, const std::vector<double>& drift) {
  if (trajectory.times.empty()) return {};
  const Storey& storey = building.storeys[index];
  const bool on_ground = index == 0 || storey.stands_on_ground;
  const Base base(building, trajectory, losses,
                  on_ground ? foot_of(building, storey) : building.storeys[index - 1].level_blocks);
  const double below = on_ground ? storey.base : elevation(trajectory, losses, building.storeys[index - 1]);
  const double lever = (elevation(trajectory, losses, storey) - below) / storey.height;
  std::vector<double> shear;
  for (std::size_t step = 0; step < drift.size(); ++step) {
    const bool stands = step < losses.levels[index].step;
    shear.push_back(stands || shear.empty() ? drift[step] + lever * std::sin(base.rotation(step))
                                            : shear.back());
  }
  return shear;
}

}  // namespace dougong::structures
