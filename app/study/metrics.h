// The numbers by which runs are compared: of one run each a value, the same list for every run of a building.
#pragma once

#include "app/study/run_result.h"

namespace dougong::app {

struct Metric {
  std::string name;    // "peak drift", "S2 peak drift"
  std::string unit;    // "1", "m", "m/s2", "s", "bonds"
  double value = 0.0;  // sizes without sign; not a number for what did not happen
};

/// Of the whole building first, then of each storey from below. Drifts and accelerations are those before a
/// storey's loss.
std::vector<Metric> metrics_of(const structures::Response& response);
/// The same with the bonds that cracked and broke, of a building that has bonds; behind those of the
/// building.
std::vector<Metric> metrics_of(const RunResult& run);

}  // namespace dougong::app
