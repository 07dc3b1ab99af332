// The figures of a comparison. A variant has the same letter and colour in all of them.
#pragma once

#include <string>
#include <vector>

#include "app/report/figures.h"
#include "app/study/compare/differences.h"

namespace dougong::app {

/// "A" for the reference, "B", "C" ...; "AA" after "Z".
std::string letter(std::size_t variant);

/// Mean differences in per cent of the reference's mean, with their intervals: a row a metric of the
/// building. Full marks are different, hollow ones not distinguishable or unproven. Empty where there is
/// nothing to draw.
std::vector<NamedFigure> difference_figure(const Comparison& comparison, View view,
                                           const std::vector<Difference>& differences);

/// Peak drift of each storey, median of all runs of each variant and 16 to 84 %; heights from `described`,
/// one run of every variant.
std::vector<NamedFigure> profile_figure(const Comparison& comparison, View view,
                                        const std::vector<RunResult>& described);

/// Ground, roof displacement, drift and base shear of the runs as described on one record, over one time
/// axis. described: by variant; empty results of those that the view does not have.
NamedFigure overlaid_histories(const Comparison& comparison, View view, std::size_t record,
                               const std::vector<RunResult>& described);

}  // namespace dougong::app
