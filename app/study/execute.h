// Runs what was prepared and gathers what it leaves behind.
#pragma once

#include <functional>

#include "app/study/prepare.h"

namespace dougong::app {

struct Progress {
  double time = 0.0, end_time = 0.0;  // s
  double peak_drift = 0.0;            // -, largest interstorey drift ratio so far, signed
  double energy_error = 0.0;          // -, of the energy turned over so far
};
/// Returns false to interrupt the run: what was reached is kept and marked as partial.
using ProgressObserver = std::function<bool(const Progress&)>;

/// What there is of a run that goes on, as if it had been interrupted here.
using SnapshotObserver = std::function<void(const RunResult&)>;

/// Snapshots come as output.save_every of the scenario says. Throws std::invalid_argument when the step that
/// was asked for is above the stability bound.
RunResult execute(Preparation& preparation, const std::string& command, const ProgressObserver& progress = {},
                  const SnapshotObserver& snapshot = {});

}  // namespace dougong::app
