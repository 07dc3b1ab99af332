// What the variants of a comparison differ in: for every metric the paired differences to the reference,
// their mean with its interval (bootstrap.h), and whether that is more than chance or the numbers explain.
//
//   d[record][member] = metric(variant, record, member) - metric(reference, record, member)
//
// Runs whose numbers failed, and metrics of what did not happen in one of the two, make no pair.
#pragma once

#include "app/study/bootstrap.h"
#include "app/study/compare/comparison.h"
#include "app/study/paired_shares.h"
#include "app/study/spread.h"

namespace dougong::app {

enum class Finding {
  different,      // the interval leaves 0 out
  not_different,  // it does not; or without one: the numerical error covers the difference
  unproven,       // too few runs for an interval
  no_pairs
};

struct Difference {
  View view = View::same_motion;
  std::size_t variant = 0;
  std::string metric, unit;
  std::size_t pairs = 0;
  Spread reference, variant_spread;  // of the runs in pairs
  double reference_mean = 0.0;
  MeanInterval interval;   // of the mean difference
  double numerical = 0.0;  // mean over the records of |with half the step - as described|, the larger
                           // of the two; not a number where that is not known
  Finding finding = Finding::no_pairs;
};
/// By view, variant, metric in the order of the reference; metrics that only one of the two has are left out.
std::vector<Difference> differences_of(const Comparison& comparison);

struct CollapseDifference {
  View view = View::same_motion;
  std::size_t variant = 0;
  PairedCounts counts;                  // "yes": collapsed; first: the reference alone
  std::size_t left_out = 0;             // pairs without an answer: one is undecided or numerically invalid
  PairedShares shares;                  // variant less reference
  Finding finding = Finding::no_pairs;  // by the test, at 5 %
};
std::vector<CollapseDifference> collapses_of(const Comparison& comparison);

/// The value of a metric in a member; not a number where it has none or its numbers failed.
double value_of(const EnsembleSheet& sheet, const EnsembleMember& member, const std::string& metric);

}  // namespace dougong::app
