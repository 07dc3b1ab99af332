// Which of a run's output times hold what: the histories have an entry at every one, the states of all blocks
// are kept as often as a film shows them.
#pragma once

#include "app/study/run_result.h"

namespace dougong::app {

/// Of the histories and energies (s): of a building those of its response, of a free scene those of its
/// states.
const std::vector<double>& output_times(const RunResult& run);

/// Index of the time nearest to this one, the earlier of two as near; times ascending, at least one.
std::size_t nearest_step(const std::vector<double>& times, double time);

/// Of the output times the first at or after each tick of `rate` (Hz) from the first time on, those of the
/// moments, and the last: where the states of a run are kept. Ascending, none twice.
std::vector<std::size_t> kept_steps(const std::vector<double>& times, double rate,
                                    const std::vector<Moment>& moments);

}  // namespace dougong::app
