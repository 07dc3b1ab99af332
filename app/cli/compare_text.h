// What a comparison says on the terminal: the variants and the cost before it starts, then its differences.
#pragma once

#include "app/cli/run_text.h"
#include "app/study/compare/differences.h"

namespace dougong::app {

/// A line a variant: what it is, its period.
std::vector<ToneLine> variants_text(const std::vector<VariantSheet>& variants);
/// How many runs the cases are, how many of them are kept from before, and what the others cost.
struct ComparisonCost {
  std::size_t cases = 0, kept = 0;
  std::size_t runs = 0;             // that are left
  std::size_t runs_of_same_sa = 0;  // of these
  double seconds = 0.0;             // of one processor
};
std::vector<ToneLine> cost_text(const ComparisonCost& cost, std::size_t jobs);
/// A table a view and variant: of the building's metrics, not of the storeys'.
std::vector<ToneLine> comparison_tables(const Comparison& comparison,
                                        const std::vector<Difference>& differences,
                                        const std::vector<CollapseDifference>& collapses);

}  // namespace dougong::app
