// Static analyses of a building: how much of its weight it bears sideways, and how it would go.
//
//   tilt      gravity turned as on a tilting table; lambda = tan(theta)
//   pushover  horizontal forces in a pattern, lambda = base shear over weight, with the capacity curve
//
// Both bracket the collapse multiplier by trials (structures/collapse_multiplier.h) and give the mechanism.
#pragma once

#include <functional>
#include <optional>

#include "app/study/prepare.h"
#include "structures/load_pattern.h"
#include "structures/mechanism.h"
#include "structures/pushover.h"

namespace dougong::app {

struct StaticChoice {
  std::optional<structures::LoadPattern> pattern;  // of a pushover; none: a tilt
  std::vector<structures::Direction> sides{structures::Direction::left, structures::Direction::right};
  double precision = 0.005;    // (falls - stands) / falls
  double first_step = 0.1;     // of lambda
  double largest = 2.0;        // lambda at which the search ends
  double hold_time = 5.0;      // s
  double target_drift = 0.05;  // -, of the roof over the height: where the capacity curve ends
};

struct SideResult {
  structures::Direction side = structures::Direction::right;
  structures::CollapseMultiplier found;
  structures::Mechanism mechanism;
  structures::CapacityCurve curve;  // of a pushover that found a multiplier; else without points
};

struct StaticResult {
  StaticChoice choice;
  ModelSheet model;
  structures::Building building;
  std::vector<structures::Finding> findings;
  double height = 0.0;  // m, of the roof above the foot
  double weight = 0.0;  // N
  std::vector<SideResult> sides;
  bool interrupted = false;
};

struct StaticProgress {
  structures::Direction side = structures::Direction::right;
  std::string doing;   // "trial 7: lambda 0.312 falls"
  double share = 0.0;  // of the whole, a guess
};

/// progress returns whether to go on. Throws ModelError and what building_of() throws.
StaticResult run_statics(const Scenario& scenario, const StaticChoice& choice,
                         const std::function<bool(const StaticProgress&)>& progress = {});

/// "tilt", "pushover".
std::string kind_of(const StaticChoice& choice);
std::string to_string(structures::Direction side);  // "left", "right"

}  // namespace dougong::app
