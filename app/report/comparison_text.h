// What a comparison says in words, the same on the page, in the tables and on the terminal.
#pragma once

#include <string>

#include "app/study/compare/differences.h"

namespace dougong::app {

/// "different", "not distinguishable", "one run proves nothing" ...
std::string finding_text(const Difference& difference);
std::string finding_text(const CollapseDifference& difference);
/// "records", "members", "nothing"
std::string resampled_text(Resampled what);

/// With its sign and unit: "+0.53 %", "−12.3 mm".
std::string difference_text(const Difference& difference, double value);
/// "+0.53 % (0.12 to 0.91)"; the mean difference alone without an interval.
std::string interval_text(const Difference& difference);
/// "3 of 16 against 15 of 16"
std::string counts_text(const CollapseDifference& difference);
/// "−0.75 (−0.90 to −0.43), p = 0.0005"
std::string interval_text(const CollapseDifference& difference);

/// What the intervals of a comparison speak of, and how they were made. One paragraph.
std::string method_text(const Comparison& comparison, const std::vector<Difference>& differences);
/// "12 comparisons; by chance alone about one in twenty ..."; empty where there are few.
std::string multiplicity_text(const std::vector<Difference>& differences);

/// What of a metric is the whole building's: shown first. False for "S2 peak drift".
bool is_of_the_building(const Difference& difference);
/// The differences of one view, and of one variant in it.
std::vector<Difference> of_view(const std::vector<Difference>& differences, View view);
std::vector<Difference> of_variant(const std::vector<Difference>& differences, View view,
                                   std::size_t variant);
const CollapseDifference* find_collapse(const std::vector<CollapseDifference>& collapses, View view,
                                        std::size_t variant);

}  // namespace dougong::app
