// What a run will cost, found out before it starts.
#pragma once

#include "engine/drive.h"

namespace dougong::app {

/// Seconds of one processor for `duration` simulated, measured on a trial of a few hundred steps on a copy:
/// what the machine at hand really needs.
double estimated_cost(const engine::Model& model, const engine::State& state,
                      const engine::DriveOptions& drive, const engine::StepPlan& plan, double duration);

/// A run that cannot keep its output is found out before it starts: throws std::invalid_argument when
/// `samples` times `values` doubles, held twice (as computed and for the report), exceed the memory.
void refuse_too_much_output(double samples, double values, std::size_t bodies);

/// Throws std::invalid_argument for a step above the stability bound.
void refuse_unstable_step(const engine::DriveOptions& drive, const engine::StepPlan& plan);

}  // namespace dougong::app
