// What a tradeoff says on the terminal: its reference, its runs as a table, and which one to take.
#pragma once

#include "app/cli/run_text.h"
#include "app/study/tradeoff/tradeoff.h"

namespace dougong::app {

/// Reference, ensemble, other stiffnesses, what was left out.
std::vector<ToneLine> tradeoff_basis_text(const Tradeoff& tradeoff);
/// A line a run: integrator, stiffness, step, cost, error; of a failure its reason.
std::vector<ToneLine> tradeoff_table(const Tradeoff& tradeoff);
/// The recommendation, and what ten times less error would cost.
std::vector<ToneLine> tradeoff_answer_text(const Tradeoff& tradeoff);

}  // namespace dougong::app
