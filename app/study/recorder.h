// Writes down a run while it goes: poses, accelerations, reactions, energies, overlaps.
#pragma once

#include "app/study/execute.h"
#include "app/study/run_sheets.h"
#include "structures/joint_response.h"

namespace dougong::app {

class Recorder {
 public:
  /// bonds: as described, to note their damage.
  Recorder(const Preparation& preparation, std::vector<DrawnBond> bonds);

  void note(const engine::Sample& sample);
  Progress progress() const;
  /// Greatest speed of a block relative to the ground at the last sample (m/s).
  double greatest_speed() const { return greatest_speed_; }

  structures::Trajectory trajectory;
  EnergyRecorder energies;
  std::vector<double> overlap_ratio, mean_overlap_ratio;
  std::vector<DrawnBond> bonds;
  structures::JointForceRecorder joints;  // of a building that settled

 private:
  void note_motion(const engine::Sample& sample, std::span<const engine::Frame> frames);
  void note_drift();
  double level_displacement(const std::vector<std::size_t>& blocks) const;

  const Preparation& preparation_;
  double peak_drift_ = 0.0;
  double greatest_speed_ = 0.0;
};

}  // namespace dougong::app
