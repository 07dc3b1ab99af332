#include "structures/collapse.h"

#include <algorithm>

#include "structures/pounding.h"

namespace dougong::structures {
namespace {

using Blocks = std::vector<std::size_t>;

Blocks lost_blocks(const Losses& losses) {
  Blocks lost;
  for (std::size_t b = 0; b < losses.blocks.size(); ++b)
    if (losses.blocks[b].step != never) lost.push_back(b);
  return lost;
}

Blocks blocks_of_lost_storeys(const Building& building, const Losses& losses) {
  Blocks blocks;
  for (std::size_t i = 0; i < building.storeys.size(); ++i)
    if (losses.levels[i].step != never) {
      const Blocks& more = building.storeys[i].storey_blocks;
      blocks.insert(blocks.end(), more.begin(), more.end());
    }
  return blocks;
}

/// `never` where none of them was lost.
std::size_t first_onset(const Blocks& blocks, const Losses& losses) {
  std::size_t first = never;
  for (const std::size_t b : blocks) first = std::min(first, losses.blocks[b].onset);
  return first;
}

std::size_t initiation_of(const Building& building, const Losses& losses) {
  const std::size_t of_storeys = first_onset(blocks_of_lost_storeys(building, losses), losses);
  return of_storeys != never ? of_storeys : first_onset(lost_blocks(losses), losses);
}

/// When the storey was lost that was lost first; the first block when no storey was.
std::size_t first_loss(const Losses& losses) {
  if (const std::size_t level = first_lost(losses); level != never) return losses.levels[level].step;
  return std::ranges::min_element(losses.blocks, {}, &Loss::step)->step;
}

/// Mean lift of the blocks by mass, relative to the ground and to the start (m): U over their weight.
double lift(const Trajectory& trajectory, const Losses& losses, const Blocks& blocks, std::size_t step) {
  double sum = 0.0;
  for (const std::size_t b : blocks) sum += losses.masses[b] * displacement(trajectory, step, b).y;
  return sum;
}

std::size_t no_return_of(const Building& building, const Trajectory& trajectory, const Losses& losses) {
  const std::size_t first = first_lost(losses);
  const Blocks blocks = first != never ? building.storeys[first].storey_blocks : lost_blocks(losses);
  std::size_t step = first_loss(losses);
  const auto u = [&](std::size_t k) { return lift(trajectory, losses, blocks, k); };
  while (step > 0 && u(step) < 0.0) --step;
  std::size_t crest = step;
  for (; step > 0 && u(step) > 0.0; --step)
    if (u(step) > u(crest)) crest = step;
  return crest;
}

std::optional<double> completion(const Trajectory& trajectory, const Losses& losses) {
  std::optional<double> complete;
  for (const Loss& level : losses.levels)
    if (level.step != never) complete = std::max(complete.value_or(0.0), trajectory.times[level.step]);
  return complete;
}

double total_area(const std::vector<Void>& voids) {
  double area = 0.0;
  for (const Void& space : voids) area += space.area;
  return area;
}

std::vector<Outline> all_outlines(const Building& building, const Trajectory& trajectory, std::size_t step) {
  std::vector<Outline> all;
  for (auto& block : block_outlines(building, trajectory, step))
    all.insert(all.end(), block.begin(), block.end());
  return all;
}

void describe_debris(const Building& building, const Trajectory& trajectory, const Losses& losses,
                     Collapse& collapse) {
  collapse.footprint = footprint(building, trajectory, losses);
  collapse.falls = falls(building, trajectory, losses);
  for (const Fall& fall : collapse.falls) collapse.impact_energy += fall.energy;
  const Footprint& f = collapse.footprint;
  const Extent around{{f.face_left - f.height, f.foot}, {f.face_right + f.height, f.foot + f.height}};
  collapse.voids = voids(all_outlines(building, trajectory, trajectory.times.size() - 1), around);
  collapse.void_area = total_area(collapse.voids);
  collapse.void_area_before = total_area(voids(all_outlines(building, trajectory, 0), around));
}

}  // namespace

Collapse describe_collapse(const Building& building, const Trajectory& trajectory,
                           const LossCriteria& criteria, const ModeCriteria& mode) {
  require_matching(building, trajectory);
  Collapse collapse;
  if (trajectory.times.empty()) return collapse;
  const auto& times = trajectory.times;
  const Losses losses = find_losses(building, trajectory, criteria);
  const std::size_t initiation = initiation_of(building, losses);
  const auto touched = touches(building, trajectory, std::min(initiation, times.size() - 1));
  if (!touched.empty()) collapse.first_touch = times[touched.front()];
  if (initiation == never) return collapse;
  ModeFinding found = find_mode(building, trajectory, losses, initiation, mode);
  collapse.mode = found.mode;
  collapse.reasons = std::move(found.reasons);
  collapse.initiation = times[initiation];
  collapse.no_return = times[no_return_of(building, trajectory, losses)];
  collapse.complete = completion(trajectory, losses);
  describe_debris(building, trajectory, losses, collapse);
  return collapse;
}

}  // namespace dougong::structures
