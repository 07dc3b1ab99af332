// Which run of a tradeoff to take: the cheapest whose error is within the target, and within it for good.
//
// A coarse run may come near the reference by luck, so every finer run of its series (integrator and
// stiffness) must be within the target too. The target is the one asked for, unless the motion or the
// reference knows less: below twice the spread of a chaotic motion, and below what the reference resolves,
// nothing is gained.
#pragma once

#include <optional>
#include <vector>

#include "app/study/tradeoff/trial.h"

namespace dougong::app {

struct JudgedTrial : Trial {
  double error = std::numeric_limits<double>::quiet_NaN();      // -, against the scene's reference
  double numerical = std::numeric_limits<double>::quiet_NaN();  // -, against that of its own stiffness
};

/// Index of the cheapest run that is within the target for good; none if no run is.
std::optional<std::size_t> cheapest_within(double target, const std::vector<JudgedTrial>& trials);

}  // namespace dougong::app
