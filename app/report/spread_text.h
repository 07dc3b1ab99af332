// What the members of an ensemble say together, in numbers and in words.
#pragma once

#include <string>
#include <vector>

#include "app/study/run_result.h"
#include "app/study/spread.h"

namespace dougong::app {

/// Verdicts of the members that were run to their end.
struct VerdictCount {
  std::size_t survived = 0, collapsed = 0, undecided = 0, invalid = 0, left_out = 0;
  /// Of those with an answer.
  Share collapse() const { return share_of(collapsed, collapsed + survived); }
};
VerdictCount count_verdicts(const EnsembleSheet& ensemble);

/// Of one metric over the members whose numbers hold.
Spread spread_of_metric(const EnsembleSheet& ensemble, std::size_t metric);

/// A metric's value as it is printed: "2.31 %", "0.412 g", "12.3 mm", "n/a" for what did not happen.
std::string metric_text(const std::string& name, const std::string& unit, double value);

/// "collapsed in 3 of 16 runs: probability 0.19, 95 % interval 0.07 to 0.43"; "run once" without members.
std::string collapse_text(const EnsembleSheet& ensemble);
/// "peak drift 2.1 to 3.4 % (16 to 84 % of 16 runs), numerical error 0.02 %"
std::string drift_spread_text(const EnsembleSheet& ensemble);

/// "peak drift 41.2 % instead of 38.7 %, the same verdict (collapsed)"; empty where it was not run.
std::string half_step_text(const EnsembleSheet& ensemble);

}  // namespace dougong::app
