// One run of a tradeoff: what it cost, where everything went, or why it failed. A failure is a result.
#pragma once

#include <functional>

#include "app/study/scene_run.h"
#include "app/study/tradeoff/way.h"

namespace dougong::app {

enum class TrialStatus {
  completed,
  refused,  // before the first step: no stable step, or one above the bound
  failed,   // the numbers: energy, overlap, a motion that is not finite
  not_run,  // too dear, or interrupted
};
std::string_view to_string(TrialStatus status);

struct Trial {
  Way way;
  TrialStatus status = TrialStatus::not_run;
  std::string reason;      // of all but the completed
  double cpu = 0.0;        // s of processor time, spent; or predicted, of one that was not run
  double simulated = 0.0;  // s, reached; asked for, of one that was not run
  double step = 0.0;       // s, the smallest; of an adaptive one the longest between two looks for contacts
  std::size_t steps = 0, evaluations = 0;
  structures::Trajectory trajectory;  // of the completed

  bool completed() const { return status == TrialStatus::completed; }
  double cpu_per_second() const { return simulated > 0.0 ? cpu / simulated : 0.0; }
};

/// What a run may cost, and whether somebody asked to stop. Called at output times with the part that is
/// done.
struct TrialLimits {
  double budget = std::numeric_limits<double>::infinity();  // s of processor time
  std::function<bool(double done)> go_on;
};

/// Runs the scene, whose stiffness is that of the way already. `predicted`: s, by an earlier run; the greater
/// of it and of a short trial decides whether it is started. A run of some milliseconds is timed repeatedly,
/// and the shortest time counts.
Trial attempt(const PreparedScene& scene, const Way& way, const TrialLimits& limits, double predicted = 0.0);

}  // namespace dougong::app
