// From a scenario's record and conditioning to the motion of the ground and the sheet that describes it.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "app/study/run_result.h"
#include "app/study/scenario.h"
#include "seismic/design/design_spectrum.h"
#include "seismic/seismic.h"

namespace dougong::app {

struct MotionInput {
  seismic::RecordSet records;
  seismic::ConditionedMotion conditioned;
  std::shared_ptr<const seismic::GroundMotion> ground;
  std::optional<seismic::DesignSpectrum> design;  // to be drawn beside the motion's
};

/// What a scenario says of the file to read. Throws seismic::InputError.
seismic::ReadOptions read_options(const RecordChoice& choice);
/// Reads the file, or the entry of the catalogue in records_directory. Throws seismic::InputError.
seismic::RecordSet read_scenario_record(const RecordChoice& choice,
                                        const std::filesystem::path& records_directory);
/// Of the sections record and conditioning.
seismic::ConditioningOptions conditioning_options(const Scenario& scenario);
/// Every channel of it, each as long as the file has it. Throws seismic::InputError.
seismic::Channels read_scenario_channels(const RecordChoice& choice,
                                         const std::filesystem::path& records_directory);
/// Throws ScenarioError or seismic::InputError.
MotionInput make_motion(const Scenario& scenario, const std::filesystem::path& records_directory);
/// period: of the building, marked in the spectrum; 0 for none.
MotionSheet motion_sheet(const MotionInput& motion, double period);

}  // namespace dougong::app
