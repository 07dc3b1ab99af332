#include "structures/response.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "structures/loss.h"
#include "structures/shear_drift.h"

namespace dougong::structures {
namespace {

using engine::Vec2;

void require_size(const char* what, std::size_t found, std::size_t expected) {
  if (found == expected) return;
  throw std::invalid_argument(fmt::format("trajectory: expected {} {}, found {}", expected, what, found));
}

double sum_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum;
}

/// Everything the histories are made from.
struct Run {
  const Building& building;
  const Trajectory& trajectory;
  const Losses losses;

  std::size_t steps() const { return trajectory.times.size(); }
};

void widen(Envelope& envelope, double value, double time) {
  if (value > envelope.positive.value) envelope.positive = {value, time};
  if (value < envelope.negative.value) envelope.negative = {value, time};
}

/// Both peaks of a history before the given step.
Envelope envelope_of(const std::vector<double>& history, const std::vector<double>& times,
                     std::size_t end = never) {
  Envelope envelope;
  for (std::size_t step = 0; step < std::min(end, history.size()); ++step)
    widen(envelope, history[step], times[step]);
  return envelope;
}

/// Mass-weighted mean over the level's blocks that are still connected. A level that is not lost has
/// some; should none be left, the mean is that of nothing, 0.
template <class Quantity>
double level_mean(const Run& run, const Storey& storey, std::size_t step, Quantity quantity) {
  double sum = 0.0, mass = 0.0;
  for (const std::size_t block : storey.level_blocks) {
    if (run.losses.blocks[block].step <= step) continue;
    sum += run.losses.masses[block] * quantity(block);
    mass += run.losses.masses[block];
  }
  return mass > 0.0 ? sum / mass : 0.0;
}

void add_floor_histories(const Run& run, const Storey& storey, std::size_t lost, StoreyResponse& response) {
  for (std::size_t step = 0; step < run.steps(); ++step) {
    const bool stands = step < lost;
    const double kept = response.floor_displacement.empty() ? 0.0 : response.floor_displacement.back();
    const double displaced =
        level_mean(run, storey, step, [&](std::size_t b) { return displacement(run.trajectory, step, b).x; });
    const double acceleration =
        level_mean(run, storey, step, [&](std::size_t b) { return run.trajectory.acceleration(step, b); });
    response.floor_displacement.push_back(stands ? displaced : kept);
    response.floor_acceleration.push_back(stands ? acceleration : 0.0);
  }
}

/// below is null for the first storey of a building or neighbour: the ground.
void add_drift(const Run& run, const StoreyResponse* below, std::size_t lost, StoreyResponse& response) {
  for (std::size_t step = 0; step < run.steps(); ++step) {
    const double base = below ? below->floor_displacement[step] : 0.0;
    const double kept = response.drift.empty() ? 0.0 : response.drift.back();
    response.drift.push_back(step < lost ? (response.floor_displacement[step] - base) / response.height
                                         : kept);
  }
}

double residual_of(const std::vector<double>& history, const std::vector<double>& times) {
  double sum = 0.0;
  std::size_t count = 0;
  // A hair of slack: output times are sums of rounded intervals.
  for (std::size_t step = 0; step < times.size(); ++step) {
    if (times[step] < times.back() - residual_window * (1.0 + 1e-9)) continue;
    sum += history[step];
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

void add_mass_lost(const Run& run, const Storey& storey, StoreyResponse& response) {
  for (const std::size_t block : storey.storey_blocks) response.original_mass += run.losses.masses[block];
  for (std::size_t step = 0; step < run.steps(); ++step) {
    double lost = 0.0;
    for (const std::size_t block : storey.storey_blocks)
      if (run.losses.blocks[block].step <= step) lost += run.losses.masses[block];
    response.mass_lost.push_back(response.original_mass > 0.0 ? lost / response.original_mass : 0.0);
  }
}

StoreyResponse storey_response(const Run& run, std::size_t index, const StoreyResponse* below) {
  const Storey& storey = run.building.storeys[index];
  const Loss& loss = run.losses.levels[index];
  const std::vector<double>& times = run.trajectory.times;
  StoreyResponse response;
  response.name = storey.name;
  response.height = storey.height;
  response.is_base = storey.is_base;
  add_floor_histories(run, storey, loss.step, response);
  add_drift(run, below, loss.step, response);
  response.shear_drift = shear_drift(run.building, run.trajectory, run.losses, index, response.drift);
  add_mass_lost(run, storey, response);
  response.peak_drift = envelope_of(response.drift, times, loss.step);
  response.peak_shear_drift = envelope_of(response.shear_drift, times, loss.step);
  response.peak_acceleration = envelope_of(response.floor_acceleration, times, loss.step);
  if (loss.step != never) {
    response.lost_at = times[loss.step];
    response.lost_because = loss.reason;
  }
  const bool frozen = loss.step != never;
  response.residual_drift =
      frozen && !response.drift.empty() ? response.drift.back() : residual_of(response.drift, times);
  return response;
}

void add_storeys(const Run& run, Response& response) {
  response.storeys.reserve(run.building.storeys.size());
  for (std::size_t i = 0; i < run.building.storeys.size(); ++i) {
    const bool on_ground = i == 0 || run.building.storeys[i].stands_on_ground;
    response.storeys.push_back(storey_response(run, i, on_ground ? nullptr : &response.storeys[i - 1]));
  }
  if (response.storeys.empty()) return;
  response.roof_displacement = response.storeys.back().floor_displacement;
  response.peak_roof_displacement =
      envelope_of(response.roof_displacement, response.times, run.losses.levels.back().step);
}

void add_base_shear(const Run& run, Response& response) {
  response.weight = sum_of(run.losses.masses) * engine::norm(run.building.scene.gravity);
  for (const Vec2 reaction : run.trajectory.ground_reaction) response.base_shear.push_back(reaction.x);
  // Afterwards the ground feels debris, not a building.
  std::size_t first_loss = never;
  for (const Loss& loss : run.losses.levels) first_loss = std::min(first_loss, loss.step);
  response.peak_base_shear = envelope_of(response.base_shear, response.times, first_loss);
  if (response.weight == 0.0) return;  // without gravity there is nothing to compare with
  const auto over_weight = [&](Peak peak) { return Peak{peak.value / response.weight, peak.time}; };
  response.peak_base_shear_ratio = {over_weight(response.peak_base_shear.positive),
                                    over_weight(response.peak_base_shear.negative)};
}

void add_overturning_moment(const Run& run, Response& response) {
  if (run.building.storeys.empty()) return;
  const double foot = run.building.storeys.front().base;
  std::size_t first_loss = never;
  for (std::size_t i = 0; i < run.building.storeys.size(); ++i) {
    const Storey& storey = run.building.storeys[i];
    response.height = std::max(response.height, storey.base + storey.height - foot);
    first_loss = std::min(first_loss, run.losses.levels[i].step);
  }
  for (std::size_t step = 0; step < run.steps(); ++step) {
    const double ground = run.trajectory.ground_displacement[step].y;
    double moment = 0.0;
    for (std::size_t block = 0; block < run.trajectory.blocks; ++block)
      moment += run.losses.masses[block] * run.trajectory.acceleration(step, block) *
                (run.trajectory.position(step, block).y - ground - foot);
    response.overturning_moment.push_back(moment);
  }
  response.peak_overturning_moment = envelope_of(response.overturning_moment, response.times, first_loss);
}

void add_losses(const Run& run, Response& response) {
  double lost = 0.0;
  std::size_t onset = never;
  for (std::size_t block = 0; block < run.losses.blocks.size(); ++block) {
    const Loss& loss = run.losses.blocks[block];
    if (loss.step == never) continue;
    response.losses.push_back({block, response.times[loss.step], loss.reason});
    lost += run.losses.masses[block];
    onset = std::min(onset, loss.onset);
  }
  std::ranges::stable_sort(response.losses, {}, &BlockLoss::time);
  if (onset != never) response.first_loss_of_support = response.times[onset];
  const double total = sum_of(run.losses.masses);
  response.fallen_mass_fraction = total > 0.0 ? lost / total : 0.0;
}

/// The lean at which a block that stands alone topples: atan(width / height) of its outline as it
/// stood at the start. 0 for a circle, which has none.
double toppling_angle(const engine::Shape& shape, double angle) {
  const auto* polygon = std::get_if<engine::ConvexPolygon>(&shape);
  if (!polygon) return 0.0;
  Vec2 low, high;
  for (const Vec2 vertex : polygon->vertices()) {
    const Vec2 corner = engine::rotated(vertex, angle);
    low = {std::min(low.x, corner.x), std::min(low.y, corner.y)};
    high = {std::max(high.x, corner.x), std::max(high.y, corner.y)};
  }
  return std::atan2(high.x - low.x, high.y - low.y);
}

Lean greatest_lean(const Run& run) {
  Lean greatest;
  for (std::size_t block = 0; block < run.trajectory.blocks; ++block) {
    if (run.losses.blocks[block].step != never) continue;
    const engine::Body& body = run.building.scene.bodies[block];
    const double start = run.trajectory.angle(0, block);
    const Lean lean{body.name, run.trajectory.angle(run.steps() - 1, block) - start,
                    toppling_angle(body.shape, start)};
    if (greatest.block.empty() || lean.ratio() > greatest.ratio()) greatest = lean;
  }
  return greatest;
}

}  // namespace

void require_matching(const Building& building, const Trajectory& trajectory) {
  const std::size_t nt = trajectory.times.size(), nb = building.scene.bodies.size();
  require_size("blocks", trajectory.blocks, nb);
  require_size("numbers in the poses", trajectory.poses.size(), 3 * nt * nb);
  require_size("ground displacements", trajectory.ground_displacement.size(), nt);
  require_size("ground reactions", trajectory.ground_reaction.size(), nt);
  require_size("accelerations", trajectory.accelerations.size(), nt * nb);
}

const StoreyResponse* storey_of_peak_drift(const Response& response) {
  const auto magnitude = [](const StoreyResponse& s) { return std::abs(s.peak_drift.largest().value); };
  const StoreyResponse* worst = nullptr;
  for (const StoreyResponse& storey : response.storeys)
    if (!storey.is_base && (!worst || magnitude(storey) > magnitude(*worst))) worst = &storey;
  return worst;
}

const StoreyResponse* storey_of_residual_drift(const Response& response) {
  const StoreyResponse* worst = nullptr;
  for (const StoreyResponse& storey : response.storeys)
    if (!storey.is_base && !storey.lost_at &&
        (!worst || std::abs(storey.residual_drift) > std::abs(worst->residual_drift)))
      worst = &storey;
  return worst;
}

Response compute_response(const Building& building, const Trajectory& trajectory,
                          const LossCriteria& criteria) {
  require_matching(building, trajectory);
  const Run run{building, trajectory, find_losses(building, trajectory, criteria)};

  Response response;
  response.times = trajectory.times;
  response.blocks = trajectory.blocks;
  add_storeys(run, response);
  add_base_shear(run, response);
  add_overturning_moment(run, response);
  if (run.steps() == 0) return response;
  add_losses(run, response);
  response.greatest_lean = greatest_lean(run);
  return response;
}

Trajectory at_steps(const Trajectory& whole, const std::vector<std::size_t>& steps) {
  Trajectory part;
  part.blocks = whole.blocks;
  const auto row = [&](const auto& from, auto& to, std::size_t step, std::size_t width) {
    const auto first = from.begin() + static_cast<std::ptrdiff_t>(step * width);
    to.insert(to.end(), first, first + static_cast<std::ptrdiff_t>(width));
  };
  for (const std::size_t step : steps) {
    row(whole.times, part.times, step, 1);
    row(whole.poses, part.poses, step, 3 * whole.blocks);
    row(whole.ground_displacement, part.ground_displacement, step, 1);
    row(whole.ground_reaction, part.ground_reaction, step, 1);
    row(whole.accelerations, part.accelerations, step, whole.blocks);
  }
  return part;
}

std::optional<double> total_loss(const Building& building, const Trajectory& trajectory,
                                 const LossCriteria& criteria) {
  require_matching(building, trajectory);
  std::size_t last = 0;
  for (const Loss& loss : find_losses(building, trajectory, criteria).levels)
    last = std::max(last, loss.step);
  if (building.storeys.empty() || last == never) return std::nullopt;
  return trajectory.times[last];
}

}  // namespace dougong::structures
