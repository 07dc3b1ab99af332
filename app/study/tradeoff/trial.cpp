#include "app/study/tradeoff/trial.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "app/study/run_cost.h"
#include "app/study/stopwatch.h"

namespace dougong::app {
namespace {

// The clock and what else the machine does spoil the time of a shorter run.
constexpr double well_timed = 0.1;  // s
constexpr int most_repeats = 5;

enum class Ended { by_itself, beyond_budget, interrupted };

struct Outcome {
  SceneResult result;
  Ended ended = Ended::by_itself;
};

Outcome run_within(PreparedScene scene, const TrialLimits& limits) {
  Outcome outcome;
  const Stopwatch watch;
  outcome.result = run_scene(scene, "", [&](const SceneProgress& now) {
    if (limits.go_on && !limits.go_on(now.time / now.end_time)) outcome.ended = Ended::interrupted;
    if (watch.cpu() > limits.budget) outcome.ended = Ended::beyond_budget;
    return outcome.ended == Ended::by_itself;
  });
  return outcome;
}

Trial not_run(Trial trial, const PreparedScene& scene, double predicted, const std::string& reason) {
  trial.status = TrialStatus::not_run;
  trial.reason = reason;
  trial.cpu = predicted;
  trial.simulated = scene.drive.end_time;
  return trial;
}

Trial refused(Trial trial, const std::string& reason) {
  trial.status = TrialStatus::refused;
  trial.reason = reason;
  return trial;
}

std::string beyond(double budget, const char* what) {
  return fmt::format("{} the budget of {:.3g} s of processor time", what, budget);
}

Trial judged(Trial trial, Outcome outcome, const TrialLimits& limits) {
  const Numerics& n = outcome.result.run.numerics;
  trial.cpu = outcome.result.run.reproducibility.cpu_seconds;
  trial.simulated = n.end_time;
  trial.step = n.step, trial.steps = n.steps, trial.evaluations = n.evaluations;
  if (!outcome.result.valid) {
    trial.status = n.steps == 0 ? TrialStatus::refused : TrialStatus::failed;
    trial.reason = outcome.result.reason;
  } else if (outcome.ended != Ended::by_itself) {
    trial.status = TrialStatus::not_run;
    trial.reason = outcome.ended == Ended::interrupted
                       ? "interrupted"
                       : beyond(limits.budget, fmt::format("at {:.3g} s it had used", n.end_time).c_str());
  } else {
    trial.status = TrialStatus::completed;
    trial.trajectory = std::move(outcome.result.run.trajectory);
  }
  return trial;
}

double least_time(const PreparedScene& scene, const Trial& trial) {
  double least = trial.cpu, sum = trial.cpu;
  for (int i = 1; i < most_repeats && sum < well_timed; ++i) {
    const double again = run_within(scene, {}).result.run.reproducibility.cpu_seconds;
    least = std::min(least, again), sum += again;
  }
  return least;
}

Trial run(const PreparedScene& scene, Trial trial, const TrialLimits& limits, double predicted) {
  const double estimate = std::max(
      predicted, scene.plan.bound > 0.0
                     ? estimated_cost(scene.model, scene.state, scene.drive, scene.plan, scene.drive.end_time)
                     : 0.0);
  if (estimate > limits.budget)
    return not_run(std::move(trial), scene, estimate,
                   beyond(limits.budget, fmt::format("predicted {:.3g} s, above", estimate).c_str()));
  trial = judged(std::move(trial), run_within(scene, limits), limits);
  if (trial.completed()) trial.cpu = least_time(scene, trial);
  return trial;
}

}  // namespace

std::string_view to_string(TrialStatus status) {
  constexpr std::array<std::string_view, 4> words{"completed", "refused", "failed", "not run"};
  return words[static_cast<std::size_t>(status)];
}

Trial attempt(const PreparedScene& scene, const Way& way, const TrialLimits& limits, double predicted) {
  Trial trial;
  trial.way = way;
  if (limits.go_on && !limits.go_on(0.0)) return not_run(std::move(trial), scene, predicted, "interrupted");
  try {
    return run(integrated_by(scene, way.solve), trial, limits, predicted);
  } catch (const std::invalid_argument& error) {
    return refused(std::move(trial), error.what());
  }
}

}  // namespace dougong::app
