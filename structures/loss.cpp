#include "structures/loss.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dougong::structures {
namespace {

using engine::Vec2;

double degrees(double angle) {
  return angle * 180.0 / std::numbers::pi;
}

bool is_circle(const engine::Shape& shape) {
  return std::holds_alternative<engine::Circle>(shape);
}

double middle_of(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// Of every block at one output time: its way past the median of its storey (m). A storey of one or
/// two blocks has no neighbours to be compared with.
std::vector<double> ways_out(const Building& building, const Trajectory& trajectory, std::size_t step) {
  std::vector<double> out(trajectory.blocks, 0.0);
  std::vector<double> moved;
  for (const Storey& storey : building.storeys) {
    if (storey.storey_blocks.size() < 3) continue;
    moved.clear();
    for (const std::size_t block : storey.storey_blocks)
      moved.push_back(displacement(trajectory, step, block).x);
    const double median = middle_of(moved);
    for (const std::size_t block : storey.storey_blocks)
      out[block] = std::abs(displacement(trajectory, step, block).x - median);
  }
  return out;
}

/// Of a block that is lost by now; without a reason where it is not.
Loss loss_by(const Trajectory& trajectory, std::size_t step, std::size_t block, const LossLimits& limits,
             double way_out) {
  const double drop = -displacement(trajectory, step, block).y;
  const double turn = trajectory.angle(step, block) - trajectory.angle(0, block);
  const std::size_t last = trajectory.times.size() - 1;
  if (drop > limits.drop)
    return {
        step, step,
        fmt::format("fell {:.2f} m ({:.2f} m at the end)", drop, -displacement(trajectory, last, block).y),
        LossCause::fell};
  if (std::abs(turn) > limits.turn)
    return {step, step, fmt::format("turned {:.0f} deg", degrees(turn)), LossCause::turned};
  if (way_out > limits.slide)
    return {step, step, fmt::format("moved {:.2f} m past its neighbours", way_out),
            LossCause::left_its_place};
  return {};
}

/// Back from the loss to when the block last stood above the beginning of its fall.
std::size_t onset_of(const Trajectory& trajectory, std::size_t step, std::size_t block,
                     const LossLimits& limits) {
  std::size_t onset = step;
  while (onset > 0 && -displacement(trajectory, onset - 1, block).y > onset_of_fall * limits.drop) --onset;
  return onset;
}

double mass_of(const std::vector<std::size_t>& blocks, const std::vector<double>& masses) {
  double sum = 0.0;
  for (const std::size_t block : blocks) sum += masses[block];
  return sum;
}

/// When more than the given part of these blocks' mass was lost.
Loss loss_of_mass(const std::vector<std::size_t>& members, const std::vector<Loss>& blocks,
                  const std::vector<double>& masses, double part) {
  std::vector<std::size_t> order;
  for (const std::size_t block : members)
    if (blocks[block].step != never) order.push_back(block);
  std::ranges::stable_sort(order, {}, [&](std::size_t block) { return blocks[block].step; });
  const double total = mass_of(members, masses);
  double lost = 0.0;
  for (const std::size_t block : order) {
    lost += masses[block];
    // The whole is reached only up to rounding.
    if (lost <= part * total && lost < total * (1.0 - 1e-12)) continue;
    return {blocks[block].step,
            blocks[block].step,
            fmt::format("{:.0f} % of its level's mass was lost", 100.0 * lost / total),
            {}};
  }
  return {};
}

/// When nothing was left of what carries the level within its storey; never without such blocks.
Loss loss_of_carriers(const Storey& storey, const std::vector<Loss>& blocks) {
  Loss loss{0, 0, "everything that carried it was lost", {}};
  std::size_t carriers = 0;
  for (const std::size_t block : storey.storey_blocks) {
    if (std::ranges::find(storey.level_blocks, block) != storey.level_blocks.end()) continue;
    ++carriers;
    if (blocks[block].step == never) return {};
    loss.step = std::max(loss.step, blocks[block].step);
  }
  loss.onset = loss.step;
  return carriers > 0 ? loss : Loss{};
}

void keep_earlier(Loss& loss, const Loss& other) {
  if (other.step < loss.step) loss = other;
}

}  // namespace

Vec2 displacement(const Trajectory& trajectory, std::size_t step, std::size_t block) {
  const Vec2 moved = trajectory.position(step, block) - trajectory.position(0, block);
  return moved - (trajectory.ground_displacement[step] - trajectory.ground_displacement[0]);
}

std::vector<LossLimits> loss_limits(const Building& building, const LossCriteria& criteria) {
  std::vector<LossLimits> limits(building.scene.bodies.size());
  for (std::size_t block = 0; block < limits.size(); ++block) {
    const engine::Shape& shape = building.scene.bodies[block].shape;
    limits[block].drop = criteria.drop_of_width * engine::minimum_width(shape);
    limits[block].slide = criteria.slide_of_length * 2.0 * engine::bounding_radius(shape);
    if (!is_circle(shape)) limits[block].turn = criteria.turn;
  }
  for (const Storey& storey : building.storeys) {
    const double least = criteria.least_drop_of_storey * storey.height;
    const double most = std::max(least, criteria.most_drop_of_storey * storey.height);
    for (const std::size_t block : storey.storey_blocks)
      limits[block].drop = std::clamp(limits[block].drop, least, most);
  }
  return limits;
}

std::vector<Loss> find_block_losses(const Building& building, const Trajectory& trajectory,
                                    const LossCriteria& criteria) {
  const std::vector<LossLimits> limits = loss_limits(building, criteria);
  std::vector<Loss> losses(trajectory.blocks);
  for (std::size_t step = 0; step < trajectory.times.size(); ++step) {
    const std::vector<double> out = ways_out(building, trajectory, step);
    for (std::size_t block = 0; block < trajectory.blocks; ++block) {
      if (losses[block].step != never) continue;
      losses[block] = loss_by(trajectory, step, block, limits[block], out[block]);
      if (losses[block].step != never) losses[block].onset = onset_of(trajectory, step, block, limits[block]);
    }
  }
  return losses;
}

std::vector<Loss> find_level_losses(const Building& building, const std::vector<Loss>& blocks,
                                    const std::vector<double>& masses, const LossCriteria& criteria) {
  std::vector<Loss> levels;
  for (const Storey& storey : building.storeys) {
    Loss loss = loss_of_mass(storey.level_blocks, blocks, masses, criteria.level_mass);
    keep_earlier(loss, loss_of_carriers(storey, blocks));
    if (!levels.empty() && !storey.stands_on_ground && levels.back().step < loss.step)
      loss = {levels.back().step, levels.back().step, "the level below was lost", {}};
    levels.push_back(std::move(loss));
  }
  return levels;
}

std::vector<double> masses_of(const engine::Scene& scene) {
  std::vector<double> masses;
  for (const engine::Body& body : scene.bodies) {
    const double density = scene.materials[body.material].density;
    masses.push_back(body.mass.value_or(engine::mass_properties(body.shape, density, body.thickness).mass));
  }
  return masses;
}

Losses find_losses(const Building& building, const Trajectory& trajectory, const LossCriteria& criteria) {
  Losses losses;
  losses.masses = masses_of(building.scene);
  losses.blocks = find_block_losses(building, trajectory, criteria);
  losses.levels = find_level_losses(building, losses.blocks, losses.masses, criteria);
  return losses;
}

}  // namespace dougong::structures
