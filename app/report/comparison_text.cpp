#include "app/report/comparison_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "app/report/spread_text.h"
#include "app/report/text.h"
#include "app/study/metrics.h"

namespace dougong::app {
namespace {

std::string with_sign(double value, const std::string& size) {
  if (!std::isfinite(value)) return "n/a";
  if (size.find_first_of("123456789") == std::string::npos) return size;
  return value > 0.0 ? "+" + size : value < 0.0 ? "−" + size : size;
}

Resampled resampled_of(const std::vector<Difference>& differences) {
  Resampled most = Resampled::nothing;
  for (const Difference& d : differences) most = std::max(most, d.interval.resampled);
  return most;
}

}  // namespace

std::string finding_text(const Difference& d) {
  switch (d.finding) {
    case Finding::different:
      return "different";
    case Finding::not_different:
      return "not distinguishable";
    case Finding::unproven:
      return d.pairs == 1 ? "one run proves nothing" : "too few runs to tell";
    case Finding::no_pairs:
      return "no pairs";
  }
  return "";
}

std::string finding_text(const CollapseDifference& d) {
  Difference same;
  same.finding = d.finding, same.pairs = d.counts.pairs();
  return finding_text(same);
}

std::string resampled_text(Resampled what) {
  return what == Resampled::groups ? "records" : what == Resampled::values ? "members" : "nothing";
}

std::string difference_text(const Difference& d, double value) {
  return with_sign(value, metric_text(d.metric, d.unit, std::abs(value)));
}

std::string interval_text(const Difference& d) {
  const std::string mean = difference_text(d, d.interval.mean);
  if (d.interval.resampled == Resampled::nothing || d.pairs == 0) return mean;
  return fmt::format("{} ({} to {})", mean, difference_text(d, d.interval.low),
                     difference_text(d, d.interval.high));
}

std::string counts_text(const CollapseDifference& d) {
  const std::size_t n = d.counts.pairs();
  if (n == 0) return "no pair with an answer";
  return fmt::format("{} of {} against {} of {}", d.counts.both + d.counts.second, n,
                     d.counts.both + d.counts.first, n);
}

std::string interval_text(const CollapseDifference& d) {
  if (d.counts.pairs() == 0) return "n/a";
  return fmt::format("{} ({} to {}), p = {}", signed_fixed(d.shares.difference, 2),
                     signed_fixed(d.shares.low, 2), signed_fixed(d.shares.high, 2),
                     significant(d.shares.p_value, 2));
}

std::string method_text(const Comparison& comparison, const std::vector<Difference>& differences) {
  const std::string pairs =
      "Every run of a variant is paired with the run of the reference on the same record with the same small "
      "changes. “Different” says that a difference is no chance, not that it matters: its size does that. ";
  const std::string bootstrap =
      "The interval of 95 % of their mean difference is the expanded percentile interval of a bootstrap with "
      "9999 resamples of ";
  switch (resampled_of(differences)) {
    case Resampled::groups:
      return pairs + bootstrap +
             fmt::format("the {} records: it speaks of records like these.", comparison.records.size());
    case Resampled::values:
      return pairs + bootstrap +
             "the members of the ensemble: it speaks of these records only, and of buildings that differ by "
             "the small changes. Of other records it says nothing; five or more records do.";
    case Resampled::nothing:
      return pairs +
             "There are too few runs for an interval: at least five members of an ensemble (--ensemble 16) "
             "or "
             "five records. Blocks that slide or rock move chaotically, so one run proves nothing: a "
             "difference counts as not distinguishable where half the step changes the numbers by as much, "
             "and as unproven otherwise.";
  }
  return pairs;
}

std::string multiplicity_text(const std::vector<Difference>& differences) {
  const auto count = std::ranges::count_if(
      differences, [](const Difference& d) { return d.interval.resampled != Resampled::nothing; });
  if (count < 10) return "";
  return fmt::format(
      "{} differences were looked at. If none of them were real, about {:.0f} would still be called "
      "different: one in twenty.",
      count, std::max(1.0, 0.05 * static_cast<double>(count)));
}

bool is_of_the_building(const Difference& d) {
  static const std::vector<Metric> building = metrics_of(structures::Response{});
  return d.unit == "bonds" || std::ranges::find(building, d.metric, &Metric::name) != building.end();
}

std::vector<Difference> of_view(const std::vector<Difference>& differences, View view) {
  std::vector<Difference> some;
  std::ranges::copy_if(differences, std::back_inserter(some),
                       [&](const Difference& d) { return d.view == view; });
  return some;
}

std::vector<Difference> of_variant(const std::vector<Difference>& differences, View view,
                                   std::size_t variant) {
  std::vector<Difference> some = of_view(differences, view);
  std::erase_if(some, [&](const Difference& d) { return d.variant != variant; });
  return some;
}

const CollapseDifference* find_collapse(const std::vector<CollapseDifference>& collapses, View view,
                                        std::size_t variant) {
  const auto it = std::ranges::find_if(
      collapses, [&](const CollapseDifference& d) { return d.view == view && d.variant == variant; });
  return it == collapses.end() ? nullptr : &*it;
}

}  // namespace dougong::app
