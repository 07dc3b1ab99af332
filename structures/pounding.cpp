#include "structures/pounding.h"

#include <algorithm>
#include <limits>

#include "structures/outline.h"

namespace dougong::structures {
namespace {

using Blocks = std::vector<std::size_t>;

/// The blocks of each building, left to right.
std::vector<Blocks> neighbours(const Building& building) {
  std::vector<Blocks> all;
  for (const Storey& storey : building.storeys) {
    if (all.empty() || storey.stands_on_ground) all.emplace_back();
    all.back().insert(all.back().end(), storey.storey_blocks.begin(), storey.storey_blocks.end());
  }
  return all;
}

/// Blocks with the circles that hold them.
class Reach {
 public:
  Reach(const Building& building, const Trajectory& trajectory, std::size_t step)
      : building_(building), trajectory_(trajectory), step_(step) {}

  double low(std::size_t b) const { return x(b) - radius(b); }
  double high(std::size_t b) const { return x(b) + radius(b); }
  bool near(std::size_t a, std::size_t b) const {
    return engine::norm(trajectory_.position(step_, a) - trajectory_.position(step_, b)) <
           radius(a) + radius(b) + touching_gap;
  }
  bool touch(std::size_t a, std::size_t b) const {
    if (!near(a, b)) return false;
    for (const Outline& p : outlines_of(a))
      for (const Outline& q : outlines_of(b))
        if (separation(placed(p), placed(q), touching_gap).gap < touching_gap) return true;
    return false;
  }

 private:
  double x(std::size_t b) const { return trajectory_.position(step_, b).x; }
  double radius(std::size_t b) const { return engine::bounding_radius(building_.scene.bodies[b].shape); }
  std::vector<Outline> outlines_of(std::size_t b) const {
    return outlines(building_.scene.bodies[b].shape, trajectory_.position(step_, b),
                    trajectory_.angle(step_, b));
  }

  const Building& building_;
  const Trajectory& trajectory_;
  std::size_t step_;
};

/// Only blocks that reach over the neighbour's side can touch.
bool any_touch(const Reach& reach, const Blocks& left, const Blocks& right) {
  double right_begins = std::numeric_limits<double>::infinity(), left_ends = -right_begins;
  for (const std::size_t b : right) right_begins = std::min(right_begins, reach.low(b));
  for (const std::size_t a : left) left_ends = std::max(left_ends, reach.high(a));
  if (left_ends + touching_gap < right_begins) return false;
  Blocks facing;
  for (const std::size_t b : right)
    if (reach.low(b) < left_ends + touching_gap) facing.push_back(b);
  return std::ranges::any_of(left, [&](std::size_t a) {
    return reach.high(a) + touching_gap > right_begins &&
           std::ranges::any_of(facing, [&](std::size_t b) { return reach.touch(a, b); });
  });
}

}  // namespace

std::vector<std::size_t> touches(const Building& building, const Trajectory& trajectory, std::size_t last) {
  std::vector<std::size_t> steps;
  const std::vector<Blocks> buildings = neighbours(building);
  if (buildings.size() < 2) return steps;
  for (std::size_t step = 0; step <= last && step < trajectory.times.size(); ++step) {
    const Reach reach(building, trajectory, step);
    for (std::size_t i = 1; i < buildings.size(); ++i)
      if (any_touch(reach, buildings[i - 1], buildings[i])) {
        steps.push_back(step);
        break;
      }
  }
  return steps;
}

}  // namespace dougong::structures
