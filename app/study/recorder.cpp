#include "app/study/recorder.h"

#include <algorithm>
#include <cmath>

namespace dougong::app {

Recorder::Recorder(const Preparation& preparation, std::vector<DrawnBond> described)
    : bonds(std::move(described)), preparation_(preparation) {
  trajectory.blocks = preparation.model.body_count;
  if (preparation.settle.settled)
    joints = {structures::face_loads(preparation.model, preparation.state), preparation.model,
              preparation.state};
}

void Recorder::note(const engine::Sample& sample) {
  const auto frames = engine::frames_of(preparation_.model, sample.state);
  note_motion(sample, frames);
  joints.note(preparation_.model, sample.state, frames);
  energies.note(preparation_.model, sample.state);
  note_damage(preparation_.model, sample.state, bonds);
  note_drift();
}

void Recorder::note_motion(const engine::Sample& sample, std::span<const engine::Frame> frames) {
  const engine::Model& model = preparation_.model;
  const std::size_t n = model.body_count;
  const engine::MotionSample ground = preparation_.motion.ground->at(sample.state.time);
  trajectory.times.push_back(sample.state.time);
  trajectory.ground_displacement.push_back(ground.displacement);
  trajectory.ground_reaction.push_back(sample.terrain_reaction);
  greatest_speed_ = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const engine::Vec2 p = frames[i].position() + model.origin;
    trajectory.poses.insert(trajectory.poses.end(), {p.x, p.y, frames[i].angle});
    trajectory.accelerations.push_back(sample.accelerations[i]);
    greatest_speed_ = std::max(greatest_speed_, engine::norm(frames[i].velocity() - ground.velocity));
  }
  const OverlapRatios overlap = overlap_ratios(sample.state.contacts.points, frames);
  overlap_ratio.push_back(overlap.deepest), mean_overlap_ratio.push_back(overlap.mean);
}

double Recorder::level_displacement(const std::vector<std::size_t>& blocks) const {
  double moment = 0.0, mass = 0.0;
  for (const std::size_t block : blocks) {
    const double m = preparation_.model.mass[block];
    moment +=
        m * (trajectory.position(trajectory.times.size() - 1, block).x - trajectory.position(0, block).x);
    mass += m;
  }
  return mass > 0.0 ? moment / mass - trajectory.ground_displacement.back().x : 0.0;
}

void Recorder::note_drift() {
  double below = 0.0;
  for (const structures::Storey& storey : preparation_.building.storeys) {
    const double above = level_displacement(storey.level_blocks);
    const double drift = (above - below) / storey.height;
    if (!storey.is_base && std::abs(drift) > std::abs(peak_drift_)) peak_drift_ = drift;
    below = above;
  }
}

Progress Recorder::progress() const {
  Progress p;
  p.time = trajectory.times.back();
  p.end_time = preparation_.duration;
  p.peak_drift = peak_drift_;
  p.energy_error = energies.energy.relative_error;
  return p;
}

}  // namespace dougong::app
