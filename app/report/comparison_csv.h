// The numbers of a comparison as CSV, unrounded: every run of every member, and the differences.
#pragma once

#include <string>

#include "app/study/compare/differences.h"

namespace dougong::app {

/// Long: variant, record, view, factor on the motion, member, verdict, metric, value, unit. Members count
/// from 0, the run as described; "half step" is that run with half the step. What did not happen is an empty
/// value.
std::string comparison_csv(const Comparison& comparison);

/// A row for every variant and metric: medians of both, the mean difference with its interval, what was
/// resampled for it, the numerical error, the finding.
std::string differences_csv(const Comparison& comparison, const std::vector<Difference>& differences,
                            const std::vector<CollapseDifference>& collapses);

}  // namespace dougong::app
