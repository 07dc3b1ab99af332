// The numbers behind the figures as CSV: one header row with names and units, one row an output time,
// doubles that read back exactly. A lost storey has empty cells from its loss on, and its `lost`
// column turns from 0 to 1: a frozen or meaningless drift never looks like a result.
#pragma once

#include <string>

#include "app/study/run_result.h"

namespace dougong::app {

std::string drift_csv(const RunResult& run);         // time; drift and lost of every storey
std::string acceleration_csv(const RunResult& run);  // time; absolute floor acceleration and lost
std::string roof_and_base_shear_csv(const RunResult& run);
std::string energy_csv(const RunResult& run);
std::string motion_csv(const RunResult& run);

}  // namespace dougong::app
