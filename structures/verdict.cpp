#include "structures/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace dougong::structures {
namespace {

using Outcome = NumericalEvidence::Outcome;
using Sentences = std::vector<std::string>;

std::string percent(double ratio) {
  return fmt::format("{:.3g} %", 100.0 * ratio);
}

/// A drift as engineers read it: "1.23 % (1/81)".
std::string drift_text(double drift) {
  if (std::abs(drift) < 1e-6) return percent(drift);
  return fmt::format("{} ({}1/{:.0f})", percent(drift), drift < 0.0 ? "-" : "", 1.0 / std::abs(drift));
}

std::string detail_of(const NumericalEvidence& numerics) {
  return numerics.outcome_detail.empty() ? "" : ": " + numerics.outcome_detail;
}

// --- what makes the numbers worthless -----------------------------------------------------------

Sentences numerical_faults(const NumericalEvidence& numerics, const VerdictCriteria& criteria) {
  Sentences faults;
  if (!numerics.finite)
    faults.push_back(fmt::format("numbers stopped being finite by {:.2f} s", numerics.end_time));
  if (numerics.outcome == Outcome::diverged)
    faults.push_back(fmt::format("the run diverged at {:.2f} s{}", numerics.end_time, detail_of(numerics)));
  // Written so that a ratio that is not a number is a fault too.
  if (!(numerics.energy_error_ratio <= criteria.energy_error))
    faults.push_back(fmt::format("the energy error is {} of the energy turned over, beyond {}",
                                 percent(numerics.energy_error_ratio), percent(criteria.energy_error)));
  if (!(numerics.deepest_overlap_ratio <= criteria.overlap))
    faults.push_back(fmt::format(
        "blocks sank into each other by {} of the smaller one's width, beyond {}{}",
        percent(numerics.deepest_overlap_ratio), percent(criteria.overlap),
        numerics.deepest_overlap_where.empty() ? "" : " (" + numerics.deepest_overlap_where + ")"));
  return faults;
}

// --- what is a collapse --------------------------------------------------------------------------

std::vector<const StoreyResponse*> lost_storeys(const Response& response) {
  std::vector<const StoreyResponse*> lost;
  for (const StoreyResponse& storey : response.storeys)
    if (storey.lost_at) lost.push_back(&storey);
  std::ranges::stable_sort(lost, {}, [](const StoreyResponse* storey) { return *storey->lost_at; });
  return lost;
}

std::string fallen_text(const Response& response) {
  return fmt::format("{} of {} blocks fell, {} of the mass", response.losses.size(), response.blocks,
                     percent(response.fallen_mass_fraction));
}

std::optional<std::string> collapse_headline(const Response& response, const VerdictCriteria& criteria) {
  const auto lost = lost_storeys(response);
  if (!lost.empty()) {
    const std::string others =
        lost.size() == 1 ? ""
                         : fmt::format(", and {} of {} storeys in all", lost.size(), response.storeys.size());
    return fmt::format("Collapsed: storey {} was lost first, at {:.2f} s{}.", lost.front()->name,
                       *lost.front()->lost_at, others);
  }
  if (response.fallen_mass_fraction > criteria.fallen_mass)
    return fmt::format("Collapsed in part: {} of the mass fell, from {:.2f} s on, though no storey was lost.",
                       percent(response.fallen_mass_fraction), response.losses.front().time);
  return std::nullopt;
}

// --- what leaves the end open --------------------------------------------------------------------

/// Mean of a history from one time up to, but not including, another; nothing outside the run.
std::optional<double> mean_between(const std::vector<double>& history, const std::vector<double>& times,
                                   double from, double to) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t step = 0; step < times.size(); ++step) {
    if (times[step] < from || times[step] >= to) continue;
    sum += history[step];
    ++count;
  }
  if (count == 0 || from < times.front()) return std::nullopt;
  return sum / static_cast<double>(count);
}

/// By how much the drift's magnitude grew over the last window.
double growth_of(const StoreyResponse& storey, const std::vector<double>& times) {
  if (times.empty()) return 0.0;
  const double middle = times.back() - residual_window;
  const auto before = mean_between(storey.drift, times, middle - residual_window, middle);
  const auto after = mean_between(storey.drift, times, middle, times.back());
  return before && after ? std::abs(*after) - std::abs(*before) : 0.0;
}

void add_early_end(const NumericalEvidence& numerics, Sentences& doubts) {
  const std::string when = fmt::format("at {:.2f} s of {:.2f} s", numerics.end_time, numerics.asked_time);
  if (numerics.outcome == Outcome::interrupted)
    doubts.push_back(fmt::format("the run was interrupted {}{}", when, detail_of(numerics)));
  else if (numerics.outcome == Outcome::stopped)
    doubts.push_back(fmt::format("the run was stopped {}{}", when, detail_of(numerics)));
  else if (numerics.end_time < numerics.asked_time * (1.0 - 1e-6))
    doubts.push_back(fmt::format("the run ended early, {}", when));
}

Sentences open_ends(const Response& response, const NumericalEvidence& numerics,
                    const VerdictCriteria& criteria) {
  Sentences doubts;
  add_early_end(numerics, doubts);
  if (response.times.empty()) doubts.push_back("no output was recorded");
  if (!(numerics.greatest_speed_at_end <= criteria.speed_at_end))
    doubts.push_back(fmt::format("a block still moves at {:.3g} m/s at the end, beyond {:.3g} m/s",
                                 numerics.greatest_speed_at_end, criteria.speed_at_end));
  const Lean& lean = response.greatest_lean;
  if (!(lean.ratio() <= criteria.lean))
    doubts.push_back(fmt::format(
        "block {} leans {:.1f} deg at the end and would topple alone beyond {:.1f} deg", lean.block,
        lean.angle * 180.0 / std::numbers::pi, criteria.lean * lean.limit * 180.0 / std::numbers::pi));
  for (const StoreyResponse& storey : response.storeys)
    if (const double growth = growth_of(storey, response.times);
        !storey.is_base && growth > criteria.drift_growth)
      doubts.push_back(fmt::format("the drift of {} still grows, by {} over the last {:.3g} s", storey.name,
                                   percent(growth), residual_window));
  return doubts;
}

// --- evidence ------------------------------------------------------------------------------------

const char* outcome_text(Outcome outcome) {
  switch (outcome) {
    case Outcome::completed:
      return "completed";
    case Outcome::diverged:
      return "diverged";
    case Outcome::interrupted:
      return "was interrupted";
    case Outcome::stopped:
      return "was stopped";
  }
  return "ended";
}

Sentences numerical_evidence(const NumericalEvidence& numerics, const VerdictCriteria& criteria) {
  Sentences lines;
  lines.push_back(fmt::format("The run {} at {:.2f} s of {:.2f} s{}.", outcome_text(numerics.outcome),
                              numerics.end_time, numerics.asked_time, detail_of(numerics)));
  lines.push_back(fmt::format("Energy error {} of the energy turned over (bound {}).",
                              percent(numerics.energy_error_ratio), percent(criteria.energy_error)));
  lines.push_back(
      fmt::format("Deepest overlap {} of the smaller block's width (bound {}){}.",
                  percent(numerics.deepest_overlap_ratio), percent(criteria.overlap),
                  numerics.deepest_overlap_where.empty() ? "" : ", " + numerics.deepest_overlap_where));
  return lines;
}

std::string peak_drift_text(const StoreyResponse& storey) {
  const Peak peak = storey.peak_drift.largest();
  return fmt::format("peak drift {} in {} at {:.2f} s", drift_text(peak.value), storey.name, peak.time);
}

std::string residual_text(const Response& response) {
  const StoreyResponse* storey = storey_of_residual_drift(response);
  return storey ? fmt::format("residual drift {} in {}", drift_text(storey->residual_drift), storey->name)
                : "no storey stands at the end";
}

Sentences structural_evidence(const Response& response) {
  Sentences lines;
  for (const StoreyResponse* storey : lost_storeys(response))
    lines.push_back(fmt::format("Storey {} was lost at {:.2f} s: {}; its drift was {} before.", storey->name,
                                *storey->lost_at, storey->lost_because, drift_text(storey->residual_drift)));
  if (response.first_loss_of_support)
    lines.push_back(
        fmt::format("The first block lost its support at {:.2f} s.", *response.first_loss_of_support));
  lines.push_back(fallen_text(response) + ".");
  if (const StoreyResponse* storey = storey_of_peak_drift(response))
    lines.push_back(
        fmt::format("Largest drifts: {}; {}.", peak_drift_text(*storey), residual_text(response)));
  const Peak shear = response.peak_base_shear.largest(), ratio = response.peak_base_shear_ratio.largest();
  lines.push_back(fmt::format("Peak base shear {:.4g} kN at {:.2f} s, {:.3g} of the weight.",
                              shear.value / 1e3, shear.time, ratio.value));
  if (const Lean& lean = response.greatest_lean; !lean.block.empty())
    lines.push_back(fmt::format(
        "At the end {} leans most, {:.3g} deg of the {:.3g} deg at which it topples alone.", lean.block,
        lean.angle * 180.0 / std::numbers::pi, lean.limit * 180.0 / std::numbers::pi));
  return lines;
}

std::string survival_headline(const Response& response) {
  const std::string fallen = response.losses.empty() ? "no block fell" : fallen_text(response);
  const StoreyResponse* storey = storey_of_peak_drift(response);
  if (!storey) return fmt::format("Survived: {}.", fallen);
  return fmt::format("Survived: {}, {}; {}.", peak_drift_text(*storey), residual_text(response), fallen);
}

}  // namespace

Verdict judge(const Response& response, const NumericalEvidence& numerics, const VerdictCriteria& criteria) {
  Verdict verdict;
  verdict.evidence = numerical_evidence(numerics, criteria);
  if (const Sentences faults = numerical_faults(numerics, criteria); !faults.empty()) {
    verdict.kind = VerdictKind::numerically_invalid;
    verdict.headline = fmt::format("Numerically invalid: {}.", fmt::join(faults, "; "));
    if (!response.losses.empty())
      verdict.evidence.push_back(
          fmt::format("{} in this run; that is not counted as collapse.", fallen_text(response)));
    return verdict;
  }
  const Sentences structural = structural_evidence(response);
  verdict.evidence.insert(verdict.evidence.begin(), structural.begin(), structural.end());
  if (const auto headline = collapse_headline(response, criteria)) {
    verdict.kind = VerdictKind::collapsed;
    verdict.headline = *headline;
  } else if (const Sentences doubts = open_ends(response, numerics, criteria); !doubts.empty()) {
    verdict.kind = VerdictKind::undecided;
    verdict.headline = fmt::format("Undecided: {}.", fmt::join(doubts, "; "));
  } else {
    verdict.kind = VerdictKind::survived;
    verdict.headline = survival_headline(response);
  }
  return verdict;
}

std::string to_string(VerdictKind kind) {
  switch (kind) {
    case VerdictKind::survived:
      return "survived";
    case VerdictKind::collapsed:
      return "collapsed";
    case VerdictKind::numerically_invalid:
      return "numerically invalid";
    case VerdictKind::undecided:
      return "undecided";
  }
  return "undecided";
}

}  // namespace dougong::structures
