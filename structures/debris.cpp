#include "structures/debris.h"

#include <algorithm>
#include <cmath>

namespace dougong::structures {
namespace {

using engine::Vec2;

Vec2 place_on_ground(const Trajectory& t, std::size_t step, std::size_t block) {
  return t.position(step, block) - (t.ground_displacement[step] - t.ground_displacement[0]);
}

std::vector<double> inertias_of(const engine::Scene& scene, const std::vector<double>& masses) {
  std::vector<double> inertias;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    const engine::Body& body = scene.bodies[i];
    const auto of_shape = engine::mass_properties(body.shape, 1.0, 1.0);
    inertias.push_back(body.inertia.value_or(masses[i] * of_shape.inertia / of_shape.mass));
  }
  return inertias;
}

void add_debris(const std::vector<Outline>& block, double middle, double mass, Footprint& f) {
  for (const Outline& outline : block) {
    const Extent box = extent_of(outline);
    f.left.reach = std::max(f.left.reach, f.face_left - box.low.x);
    f.right.reach = std::max(f.right.reach, box.high.x - f.face_right);
  }
  if (middle < f.face_left) f.left.mass += mass;
  if (middle > f.face_right) f.right.mass += mass;
}

/// The block's motion over one output interval as a hit: its speed and energy, at the interval's end.
Fall moving(const Trajectory& t, std::size_t step, std::size_t block, double mass, double inertia) {
  const double dt = t.times[step] - t.times[step - 1];
  const Vec2 v = (1.0 / dt) * (place_on_ground(t, step, block) - place_on_ground(t, step - 1, block));
  const double spin = (t.angle(step, block) - t.angle(step - 1, block)) / dt;
  return {block, 0.0, t.times[step], engine::norm(v),
          0.5 * mass * engine::dot(v, v) + 0.5 * inertia * spin * spin};
}

Fall fall_of(const Trajectory& t, const Loss& loss, std::size_t block, double mass, double inertia) {
  Fall fall{block, t.times[loss.onset], t.times[loss.step], 0.0, 0.0};
  for (std::size_t step = loss.onset + 1; step < t.times.size(); ++step) {
    const Fall now = moving(t, step, block, mass, inertia);
    if (now.energy > fall.energy) fall = {block, fall.support_lost, now.hit, now.speed, now.energy};
  }
  return fall;
}

}  // namespace

std::vector<std::vector<Outline>> block_outlines(const Building& building, const Trajectory& trajectory,
                                                 std::size_t step) {
  std::vector<std::vector<Outline>> out;
  for (std::size_t block = 0; block < trajectory.blocks; ++block)
    out.push_back(outlines(building.scene.bodies[block].shape, place_on_ground(trajectory, step, block),
                           trajectory.angle(step, block)));
  return out;
}

Extent extent_of_building(const Building& building, const Trajectory& trajectory, std::size_t step) {
  Outline points;
  for (const auto& block : block_outlines(building, trajectory, step))
    for (const Outline& outline : block) points.insert(points.end(), outline.begin(), outline.end());
  return extent_of(points);
}

Footprint footprint(const Building& building, const Trajectory& trajectory, const Losses& losses) {
  const Extent stood = extent_of_building(building, trajectory, 0);
  Footprint f{stood.low.x, stood.high.x, stood.low.y, stood.height(), {}, {}, 0};
  const std::size_t last = trajectory.times.size() - 1;
  const auto lie = block_outlines(building, trajectory, last);
  for (std::size_t block = 0; block < trajectory.blocks; ++block) {
    if (losses.blocks[block].step == never) continue;
    const Vec2 middle = place_on_ground(trajectory, last, block);
    if (middle.y < f.foot - f.height)
      ++f.over_the_edge;
    else
      add_debris(lie[block], middle.x, losses.masses[block], f);
  }
  return f;
}

std::vector<Fall> falls(const Building& building, const Trajectory& trajectory, const Losses& losses) {
  const std::vector<double> inertias = inertias_of(building.scene, losses.masses);
  std::vector<Fall> all;
  for (std::size_t block = 0; block < trajectory.blocks; ++block)
    if (losses.blocks[block].step != never)
      all.push_back(fall_of(trajectory, losses.blocks[block], block, losses.masses[block], inertias[block]));
  std::ranges::stable_sort(all, {}, &Fall::support_lost);
  return all;
}

}  // namespace dougong::structures
