#include "app/report/spread_text.h"

#include <fmt/format.h>

#include <cmath>

#include "app/report/text.h"
#include "engine/scene.h"

namespace dougong::app {
namespace {

using structures::VerdictKind;

bool holds(const EnsembleMember& member) {
  return member.done && member.verdict != VerdictKind::numerically_invalid;
}

}  // namespace

VerdictCount count_verdicts(const EnsembleSheet& ensemble) {
  VerdictCount count;
  for (const EnsembleMember& member : ensemble.members) {
    if (!member.done)
      ++count.left_out;
    else if (member.verdict == VerdictKind::survived)
      ++count.survived;
    else if (member.verdict == VerdictKind::collapsed)
      ++count.collapsed;
    else
      ++(member.verdict == VerdictKind::undecided ? count.undecided : count.invalid);
  }
  return count;
}

Spread spread_of_metric(const EnsembleSheet& ensemble, std::size_t metric) {
  std::vector<double> values;
  for (const EnsembleMember& member : ensemble.members)
    if (holds(member) && metric < member.values.size()) values.push_back(member.values[metric]);
  return spread_of(std::move(values));
}

std::string metric_text(const std::string& name, const std::string& unit, double value) {
  if (!std::isfinite(value)) return "n/a";
  if (unit == "m") return length(value);
  if (unit == "s") return seconds(value);
  if (unit == "bonds") return significant(value, 3);
  if (unit == "m/s2") return significant(value / engine::standard_gravity, 3) + " g";
  if (name.find("over") != std::string::npos) return significant(value, 3);
  return significant(100.0 * value, 3) + " %";
}

std::string collapse_text(const EnsembleSheet& ensemble) {
  if (ensemble.members.size() < 2) return "run once";
  const VerdictCount count = count_verdicts(ensemble);
  const Share share = count.collapse();
  std::string text =
      fmt::format("collapsed in {} of {} runs: probability {:.2f}, 95 % interval {:.2f} to {:.2f}",
                  share.events, share.trials, share.value(), share.low, share.high);
  if (share.trials == 0) text = "no run gave an answer";
  if (count.undecided > 0) text += fmt::format("; {} undecided", count.undecided);
  if (count.invalid > 0) text += fmt::format("; {} numerically invalid", count.invalid);
  if (count.left_out > 0) text += fmt::format("; {} not run to their end", count.left_out);
  return text;
}

std::string drift_spread_text(const EnsembleSheet& ensemble) {
  if (ensemble.members.size() < 2 || ensemble.metrics.empty()) return "";
  const auto print = [&](double value) { return metric_text(ensemble.metrics[0], ensemble.units[0], value); };
  const Spread s = spread_of_metric(ensemble, 0);
  std::string text = fmt::format("{} {} to {} (16 and 84 % of {} runs), median {}", ensemble.metrics[0],
                                 print(s.low), print(s.high), s.count, print(s.median));
  if (holds(ensemble.half_step)) text += "; with half the step " + print(ensemble.half_step.values.at(0));
  return text;
}

std::string half_step_text(const EnsembleSheet& e) {
  if (!e.half_step.done || e.members.empty() || e.metrics.empty()) return "";
  const EnsembleMember &half = e.half_step, &described = e.members.front();
  const auto print = [&](const EnsembleMember& member) {
    return metric_text(e.metrics[0], e.units[0], member.values.at(0));
  };
  const std::string verdict =
      half.verdict == described.verdict
          ? "the same verdict (" + structures::to_string(half.verdict) + ")"
          : structures::to_string(half.verdict) + " instead of " + structures::to_string(described.verdict);
  return fmt::format("{} {} instead of {}, {}", e.metrics[0], print(half), print(described), verdict);
}

}  // namespace dougong::app
