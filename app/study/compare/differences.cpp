#include "app/study/compare/differences.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dougong::app {
namespace {

using structures::VerdictKind;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double significance = 0.05;

/// The runs of reference and variant on one record.
struct Pair {
  const ComparedRun *reference, *variant;
};

std::vector<Pair> pairs_of(const Comparison& c, View view, std::size_t variant) {
  std::vector<Pair> pairs;
  for (std::size_t record = 0; record < c.records.size(); ++record) {
    const Pair pair{c.find(view, 0, record), c.find(view, variant, record)};
    if (pair.reference && pair.variant) pairs.push_back(pair);
  }
  return pairs;
}

double numerical_change(const EnsembleSheet& sheet, const std::string& metric) {
  return std::abs(value_of(sheet, sheet.half_step, metric) - value_of(sheet, sheet.members.front(), metric));
}

/// One metric of one variant against the reference.
class Comparer {
 public:
  Comparer(Difference& d, const std::vector<Pair>& pairs) : d_(d) {
    for (const Pair& pair : pairs) add(pair);
    d_.reference = spread_of(reference_), d_.variant_spread = spread_of(variant_);
    d_.reference_mean = mean_of(reference_);
    d_.interval = bootstrap_mean(differences_);
    d_.numerical = std::max(mean_of(numerical_of_reference_), mean_of(numerical_of_variant_));
    if (numerical_of_reference_.empty() || numerical_of_variant_.empty()) d_.numerical = nan;
    d_.finding = finding();
  }

 private:
  void add(const Pair& pair) {
    const EnsembleSheet &a = pair.reference->sheet, &b = pair.variant->sheet;
    differences_.emplace_back();
    for (std::size_t m = 0; m < std::min(a.members.size(), b.members.size()); ++m) {
      const double x = value_of(a, a.members[m], d_.metric), y = value_of(b, b.members[m], d_.metric);
      if (std::isnan(x) || std::isnan(y)) continue;
      reference_.push_back(x), variant_.push_back(y);
      differences_.back().push_back(y - x);
      ++d_.pairs;
    }
    add_numerical(a, numerical_of_reference_), add_numerical(b, numerical_of_variant_);
  }

  void add_numerical(const EnsembleSheet& sheet, std::vector<double>& changes) const {
    const double change = numerical_change(sheet, d_.metric);
    if (!std::isnan(change)) changes.push_back(change);
  }

  Finding finding() const {
    if (d_.pairs == 0) return Finding::no_pairs;
    const MeanInterval& i = d_.interval;
    if (i.resampled != Resampled::nothing)
      return i.low > 0.0 || i.high < 0.0 ? Finding::different : Finding::not_different;
    const bool covered = i.mean == 0.0 || std::abs(i.mean) <= d_.numerical;
    return covered ? Finding::not_different : Finding::unproven;
  }

  Difference& d_;
  std::vector<double> reference_, variant_, numerical_of_reference_, numerical_of_variant_;
  std::vector<std::vector<double>> differences_;
};

bool has(const EnsembleSheet& sheet, const std::string& metric) {
  return std::ranges::find(sheet.metrics, metric) != sheet.metrics.end();
}

bool has_answer(const EnsembleMember& member) {
  return member.done && (member.verdict == VerdictKind::survived || member.verdict == VerdictKind::collapsed);
}

void count(const Pair& pair, CollapseDifference& d) {
  const auto &a = pair.reference->sheet.members, &b = pair.variant->sheet.members;
  for (std::size_t m = 0; m < std::min(a.size(), b.size()); ++m) {
    if (!has_answer(a[m]) || !has_answer(b[m])) {
      ++d.left_out;
      continue;
    }
    const bool first = a[m].verdict == VerdictKind::collapsed,
               second = b[m].verdict == VerdictKind::collapsed;
    ++(first && second ? d.counts.both
       : first         ? d.counts.first
       : second        ? d.counts.second
                       : d.counts.neither);
  }
}

Finding finding_of(const CollapseDifference& d) {
  if (d.counts.pairs() == 0) return Finding::no_pairs;
  if (d.shares.p_value < significance) return Finding::different;
  // Even if every pair differed the same way, fewer could not show it.
  constexpr std::size_t least_telling = 6;
  const bool same = d.counts.first + d.counts.second == 0;
  return d.counts.pairs() >= least_telling || same ? Finding::not_different : Finding::unproven;
}

template <class Visit>
void for_each_variant(const Comparison& c, Visit visit) {
  for (const View view : c.views)
    for (std::size_t variant = 1; variant < c.variants.size(); ++variant)
      if (const auto pairs = pairs_of(c, view, variant); !pairs.empty()) visit(view, variant, pairs);
}

}  // namespace

double value_of(const EnsembleSheet& sheet, const EnsembleMember& member, const std::string& metric) {
  const auto it = std::ranges::find(sheet.metrics, metric);
  const auto i = static_cast<std::size_t>(it - sheet.metrics.begin());
  const bool holds = member.done && member.verdict != VerdictKind::numerically_invalid;
  return holds && i < member.values.size() ? member.values[i] : nan;
}

std::vector<Difference> differences_of(const Comparison& comparison) {
  std::vector<Difference> all;
  for_each_variant(comparison, [&](View view, std::size_t variant, const std::vector<Pair>& pairs) {
    const EnsembleSheet& sheet = pairs.front().reference->sheet;
    for (std::size_t i = 0; i < sheet.metrics.size(); ++i) {
      if (!has(pairs.front().variant->sheet, sheet.metrics[i])) continue;
      Difference d;
      d.view = view, d.variant = variant, d.metric = sheet.metrics[i], d.unit = sheet.units[i];
      const Comparer fill(d, pairs);
      all.push_back(std::move(d));
    }
  });
  return all;
}

std::vector<CollapseDifference> collapses_of(const Comparison& comparison) {
  std::vector<CollapseDifference> all;
  for_each_variant(comparison, [&](View view, std::size_t variant, const std::vector<Pair>& pairs) {
    CollapseDifference d;
    d.view = view, d.variant = variant;
    for (const Pair& pair : pairs) count(pair, d);
    d.shares = compare_shares(d.counts);
    d.finding = finding_of(d);
    all.push_back(d);
  });
  return all;
}

}  // namespace dougong::app
