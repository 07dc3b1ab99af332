// How sure a run is: the same run again with small changes (perturbation.h), and once more with half the
// step. Members run in parallel; each is the same whatever the order and the number of threads.
#pragma once

#include <functional>

#include "app/study/execute.h"

namespace dougong::app {

struct EnsembleProgress {
  std::size_t done = 0, total = 0;  // runs
  double part = 0.0;                // of those that go on, together
};
/// Returns false to stop: what is not done is left out. Called by one thread at a time.
using EnsembleObserver = std::function<bool(const EnsembleProgress&)>;

/// Runs that a scenario costs: members, and the one with half the step.
std::size_t runs_of(const Scenario& scenario);

/// What an ensemble keeps of a run.
EnsembleMember member_of(const RunResult& run);

/// The other members of the run `described`, whose preparation it was, and its half step. jobs: threads, at
/// least 1. Throws as prepare_member().
EnsembleSheet run_ensemble(const Preparation& preparation, const RunResult& described, std::size_t jobs,
                           const EnsembleObserver& progress = {});

}  // namespace dougong::app
