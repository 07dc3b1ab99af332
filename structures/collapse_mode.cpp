#include "structures/collapse_mode.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "structures/outline.h"
#include "structures/pounding.h"
#include "structures/rigid_fit.h"

namespace dougong::structures {
namespace {

using engine::Vec2;
using Blocks = std::vector<std::size_t>;

double degrees(double angle) {
  return angle * 180.0 / std::numbers::pi;
}

/// The first lost storey at the time of its loss.
struct Scene {
  const Building& building;
  const Trajectory& trajectory;
  const Losses& losses;
  const ModeCriteria& criteria;
  std::size_t initiation, first, step;  // step: of the loss

  const Storey& storey() const { return building.storeys[first]; }
  double mass_of(const Blocks& blocks) const {
    return std::accumulate(blocks.begin(), blocks.end(), 0.0,
                           [&](double sum, std::size_t b) { return sum + losses.masses[b]; });
  }
  /// Mass-weighted mean; 0 of none.
  template <class Quantity>
  auto mean(const Blocks& blocks, Quantity quantity) const {
    auto sum = 0.0 * quantity(std::size_t{0});
    for (const std::size_t b : blocks) sum += losses.masses[b] * quantity(b);
    const double mass = mass_of(blocks);
    return mass > 0.0 ? (1.0 / mass) * sum : sum;
  }
  Vec2 moved(const Blocks& blocks) const {
    return mean(blocks, [&](std::size_t b) { return displacement(trajectory, step, b); });
  }
  double turn(std::size_t b) const { return trajectory.angle(step, b) - trajectory.angle(0, b); }
  bool lost(std::size_t b) const { return losses.blocks[b].step <= step; }
  Blocks lost_of(Blocks blocks) const {
    std::erase_if(blocks, [&](std::size_t b) { return !lost(b); });
    return blocks;
  }
};

bool stands_on_ground(const Scene& s) {
  return s.first == building_of_storey(s.building, s.first).from;
}

/// The storey's blocks below its level; where it has none, the level below, or nothing on the ground.
Blocks carriers_of(const Scene& s) {
  Blocks carriers;
  for (const std::size_t b : s.storey().storey_blocks)
    if (std::ranges::find(s.storey().level_blocks, b) == s.storey().level_blocks.end()) carriers.push_back(b);
  if (carriers.empty() && !stands_on_ground(s)) carriers = s.building.storeys[s.first - 1].level_blocks;
  return carriers;
}

/// How the level moved on what is below it: to the side, and down (m, positive down).
Vec2 movement_of_level(const Scene& s) {
  const Vec2 below = stands_on_ground(s) ? Vec2{} : s.moved(s.building.storeys[s.first - 1].level_blocks);
  const Vec2 moved = s.moved(s.storey().level_blocks) - below;
  return {moved.x, -moved.y};
}

// --- the questions, in order -----------------------------------------------------------------------

ModeFinding pounding(const Scene& s) {
  const auto touched = touches(s.building, s.trajectory, s.initiation);
  if (touched.empty()) return {};
  const auto& times = s.trajectory.times;
  const double ahead = times[s.initiation] - times[touched.back()];
  if (ahead > s.criteria.pounding_before) return {};
  return {CollapseMode::pounding,
          {fmt::format("The neighbours touched first at {:.2f} s and last {:.2f} s before the first loss of "
                       "support.",
                       times[touched.front()], ahead)}};
}

ModeFinding overturning(const Scene& s) {
  Blocks body;
  const StoreyRange range = building_of_storey(s.building, s.first);
  for (std::size_t i = range.from; i < range.to; ++i)
    if (s.losses.levels[i].step != never) {
      const Blocks& blocks = s.building.storeys[i].storey_blocks;
      body.insert(body.end(), blocks.begin(), blocks.end());
    }
  const RigidFit fit = fit_rigid_motion(s.building, s.trajectory, body, s.losses.masses, s.step);
  const double turned = s.mean(body, [&](std::size_t b) { return s.turn(b); });
  if (std::abs(fit.angle) < s.criteria.least_turn || fit.explained < s.criteria.rigid_share ||
      turned / fit.angle < s.criteria.block_turn)
    return {};
  return {CollapseMode::overturning,
          {fmt::format("What was lost had turned as one body by {:.1f} deg at {:.2f} s: a rigid motion "
                       "explains {:.0f} % of it.",
                       degrees(fit.angle), s.trajectory.times[s.step], 100.0 * fit.explained)}};
}

ModeFinding sliding(const Scene& s) {
  const Blocks gone = s.lost_of(s.storey().storey_blocks);
  Blocks aside = gone;
  std::erase_if(aside, [&](std::size_t b) { return s.losses.blocks[b].cause != LossCause::left_its_place; });
  const double turned = s.mean(aside, [&](std::size_t b) { return std::abs(s.turn(b)); });
  if (aside.empty() || s.mass_of(aside) <= 0.5 * s.mass_of(gone) || turned >= s.criteria.standing_turn)
    return {};
  return {CollapseMode::sliding,
          {fmt::format("{} of the {} blocks that {} had lost by {:.2f} s left their places sideways.",
                       aside.size(), gone.size(), s.storey().name, s.trajectory.times[s.step])}};
}

bool carriers_stand(const Scene& s) {
  const Blocks carriers = carriers_of(s);
  if (carriers.empty()) return stands_on_ground(s);
  const double turned = s.mean(carriers, [&](std::size_t b) { return std::abs(s.turn(b)); });
  const double down = -s.moved(carriers).y, level_down = -s.moved(s.storey().level_blocks).y;
  return turned < s.criteria.standing_turn && s.mass_of(s.lost_of(carriers)) <= 0.5 * s.mass_of(carriers) &&
         down <= 0.5 * std::abs(level_down);
}

double width_of(const Scene& s, const Blocks& blocks) {
  Extent box;
  bool any = false;
  for (const std::size_t b : blocks)
    for (const Outline& outline :
         outlines(s.building.scene.bodies[b].shape, s.trajectory.position(0, b), s.trajectory.angle(0, b))) {
      box = any ? joined(box, extent_of(outline)) : extent_of(outline);
      any = true;
    }
  return box.width();
}

ModeFinding loss_on_standing_carriers(const Scene& s) {
  if (!carriers_stand(s)) return {};
  const Blocks fallen = s.lost_of(s.storey().level_blocks);
  if (fallen.empty()) return {};
  const std::string stood = "What carries " + s.storey().name + " stood";
  double widest = 0.0;
  for (const std::size_t b : fallen) widest = std::max(widest, width_of(s, {b}));
  const double share = widest / width_of(s, s.storey().storey_blocks);
  return {share >= s.criteria.floor_width ? CollapseMode::out_of_support : CollapseMode::partial_wall,
          {fmt::format("{}; blocks of its level fell, the widest {:.0f} % of the storey's width.", stood,
                       100.0 * share)}};
}

ModeFinding pancake(const Scene& s) {
  const Vec2 moved = movement_of_level(s);
  if (moved.y <= 0.0 || moved.y < std::abs(moved.x)) return {};
  return {CollapseMode::pancake,
          {fmt::format("The level of {} had come down by {:.2f} m and gone aside by {:.2f} m at {:.2f} s.",
                       s.storey().name, moved.y, std::abs(moved.x), s.trajectory.times[s.step])}};
}

/// Displacements between the storeys (m) just before the loss, the base of isolators left out.
ModeFinding sidesway(const Scene& s) {
  const StoreyRange range = building_of_storey(s.building, s.first);
  double below = 0.0, sum = 0.0, most = 0.0;
  std::size_t worst = s.first, storeys = 0;
  for (std::size_t i = range.from; i < range.to; ++i) {
    const Storey& storey = s.building.storeys[i];
    const double at = s.moved(storey.level_blocks).x, size = std::abs(at - below);
    below = at;
    if (storey.is_base) continue;
    ++storeys, sum += size;
    if (size > most) most = size, worst = i;
  }
  const double share = sum > 0.0 ? most / sum : 0.0;
  const bool soft = storeys > 1 && share >= s.criteria.soft_share;
  return {soft ? CollapseMode::soft_storey : CollapseMode::sway,
          {fmt::format("{} had {:.0f} % of the displacement between the {} storeys at {:.2f} s.",
                       s.building.storeys[worst].name, 100.0 * share, storeys, s.trajectory.times[s.step])}};
}

ModeFinding without_lost_storey(const Losses& losses) {
  const auto fallen = std::ranges::count_if(losses.blocks, [](const Loss& l) { return l.step != never; });
  if (fallen == 0) return {};
  return {CollapseMode::partial,
          {fmt::format("No storey was lost; {} of {} blocks were.", fallen, losses.blocks.size())}};
}

}  // namespace

std::string to_string(CollapseMode mode) {
  constexpr const char* names[] = {"none",           "partial",      "pounding", "overturning", "sliding",
                                   "out of support", "partial wall", "pancake",  "soft storey", "sway"};
  return names[static_cast<std::size_t>(mode)];
}

std::size_t first_lost(const Losses& losses) {
  const auto first = std::ranges::min_element(losses.levels, {}, &Loss::step);
  return first == losses.levels.end() || first->step == never
             ? never
             : static_cast<std::size_t>(first - losses.levels.begin());
}

StoreyRange building_of_storey(const Building& building, std::size_t storey) {
  StoreyRange range{storey, storey + 1};
  while (range.from > 0 && !building.storeys[range.from].stands_on_ground) --range.from;
  while (range.to < building.storeys.size() && !building.storeys[range.to].stands_on_ground) ++range.to;
  return range;
}

ModeFinding find_mode(const Building& building, const Trajectory& trajectory, const Losses& losses,
                      std::size_t initiation, const ModeCriteria& criteria) {
  const std::size_t first = first_lost(losses);
  if (first == never) return without_lost_storey(losses);
  const Scene s{building, trajectory, losses, criteria, initiation, first, losses.levels[first].step};
  for (const auto question : {pounding, overturning, sliding, loss_on_standing_carriers, pancake})
    if (ModeFinding found = question(s); found.mode != CollapseMode::none) return found;
  return sidesway(s);
}

}  // namespace dougong::structures
