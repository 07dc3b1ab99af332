// Everything that happens before the ground moves: build, check, read the record, settle, find the
// period, choose the step. The program prints it, and execute() starts from it.
#pragma once

#include <stdexcept>

#include "app/study/motion_input.h"
#include "engine/drive.h"
#include "engine/modes.h"
#include "engine/settle.h"
#include "structures/layouts/layout.h"
#include "structures/model_check.h"

namespace dougong::app {

struct Preparation {
  Scenario scenario;
  structures::Building building;
  std::vector<structures::Finding> findings;
  MotionInput motion;
  engine::Model model;
  engine::State state;  // settled
  engine::SettleReport settle;
  double period = 0.0;         // s, of the horizontal mode that carries most mass; 0 when there is none
  double participation = 0.0;  // of the mass
  std::string accuracy;        // what the dial chose and why; empty where the integrator was named
  engine::DriveOptions drive;
  engine::StepPlan plan;
  std::size_t contact_points = 0;  // touching
  double duration = 0.0;           // s, asked for
  double estimated_seconds = 0.0;  // of one processor, measured on a short trial
};

/// A model that cannot be run: the model check's errors, one a line.
class ModelError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws LayoutError, ModelError, seismic::InputError, std::invalid_argument.
Preparation prepare(const Scenario& scenario, const std::filesystem::path& records_directory);
/// The same with the changes of that member of the scenario's ensemble; 0: none. `described` may have been
/// run. What it costs is not estimated. Throws std::invalid_argument.
Preparation prepare_member(const Preparation& described, std::size_t member);

/// The warnings of the model check. Throws ModelError for its errors.
std::vector<structures::Finding> checked_findings(const structures::Building& building);

/// The building of a scenario or of a layout alone, checked; without a motion. Throws as above.
ModelSheet model_sheet(const structures::Building& building);
ModelSheet model_sheet(const Preparation& preparation);

}  // namespace dougong::app
