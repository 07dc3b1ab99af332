// The section of the report on the numbers: step, energy error, overlaps, stiffness, half the step.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/report/axis.h"
#include "app/report/page.h"
#include "app/report/spread_text.h"
#include "app/report/text.h"

namespace dougong::app {
namespace {

std::string microseconds(double time) {
  return significant(1e6 * time, 3) + " µs";
}

// The step follows the contacts: the bound is that of the start.
std::string step_words(const Numerics& n) {
  std::string words = microseconds(n.step);
  if (n.step_reductions > 0 && n.steps > 0)
    words += " at the shortest, " + microseconds(n.end_time / static_cast<double>(n.steps)) + " in the mean";
  if (std::isinf(n.bound)) return words + ", not bounded by stability";
  if (!(n.bound > 0.0)) return words + ", no bound known";
  if (n.step_reductions > 0) return words + "; bound at the start " + microseconds(n.bound);
  return words + ", " + fixed(n.step / n.bound, 2) + " of the bound " + microseconds(n.bound);
}

std::string outcome_words(const Numerics& n) {
  std::string words = n.outcome + ", " + seconds(n.end_time) + " of " + seconds(n.asked_time);
  return n.outcome_detail.empty() ? words : words + " (" + n.outcome_detail + ")";
}

std::string overlap_words(const Numerics& n) {
  std::string words = length(n.deepest_overlap) + ", " + significant(100 * n.deepest_overlap_ratio, 2) +
                      " % of the smaller block's width";
  return n.deepest_overlap_where.empty() ? words : words + "; " + n.deepest_overlap_where;
}

std::string mean_overlap_words(const Numerics& n) {
  const auto& means = n.mean_overlap_ratio;
  if (means.empty()) return "not kept in this results file";
  return significant(100 * mean_of(means), 2) + " % of the smaller block's width, " +
         significant(100 * std::ranges::max(means), 2) + " % at the most";
}

// Of the joints at rest, against the columns of the blocks' own E between their centroids.
std::string stiffness_words(const RunResult& run, bool bonded) {
  std::size_t count = 0;
  Range stiffness{std::numeric_limits<double>::infinity(), 0.0}, share = stiffness;
  for (const WeightJoint& joint : run.weight_joints) {
    if (joint.bonded != bonded || !(joint.blocks_stiffness > 0.0)) continue;
    ++count;
    const double ratio = joint.stiffness / joint.blocks_stiffness;
    stiffness = joined(stiffness, {joint.stiffness, joint.stiffness});
    share = joined(share, {ratio, ratio});
  }
  if (count == 0) return bonded ? "no bonded faces at rest" : "no faces that touch at rest";
  return fmt::format(
      "{} to {} GN/m over {}; {} to {} times that of the blocks' own E (columns between their "
      "centroids)",
      significant(1e-9 * stiffness.low, 3), significant(1e-9 * stiffness.high, 3), plural(count, "face"),
      significant(share.low, 3), significant(share.high, 3));
}

Html numerics_table(const RunResult& run) {
  const Numerics& n = run.numerics;
  return table("", {{"Quantity", "", false}, {"Value", "", false}},
               {{"Outcome", outcome_words(n)},
                {"Integrator", n.integrator},
                {"Step", step_words(n)},
                {"Steps", std::to_string(n.steps) + ", " + plural(n.step_reductions, "reduction")},
                {"Energy error", energy_error_words(run)},
                {"Deepest overlap", overlap_words(n)},
                {"Mean overlap of what touches", mean_overlap_words(n)},
                {"Contact stiffness used", stiffness_words(run, false)},
                {"Bond stiffness used", stiffness_words(run, true)}});
}

Html warning_list(const RunResult& run) {
  if (run.numerics.warnings.empty()) return raw("<p class=\"fine\">No warnings.</p>\n");
  return raw("<p class=\"bad\">") + text(plural(run.numerics.warnings.size(), "warning") + ":") +
         raw("</p>\n") + list(run.numerics.warnings);
}

std::vector<std::string> half_step_row(const EnsembleSheet& e, std::size_t metric) {
  const double described = e.members.front().values[metric], half = e.half_step.values[metric];
  const auto print = [&](double value) { return metric_text(e.metrics[metric], e.units[metric], value); };
  const std::string change = described != 0.0 && std::isfinite(half / described)
                                 ? significant(100.0 * (half - described) / std::abs(described), 2) + " %"
                                 : "n/a";
  return {e.metrics[metric], print(described), print(half), change};
}

Html half_step_part(const EnsembleSheet& e) {
  const std::size_t rows = std::min(e.half_step.values.size(), e.metrics.size());
  if (!e.half_step.done || e.members.empty() || e.members.front().values.size() < rows)
    return paragraph("Not done in this run: a second run with half the step.");
  std::vector<std::vector<std::string>> table_rows;
  for (std::size_t metric = 0; metric < rows; ++metric) table_rows.push_back(half_step_row(e, metric));
  return paragraph(
             "With half the step: " + half_step_text(e) +
             ". Where blocks slide or rock the motion is chaotic, and half the step makes another draw of "
             "it rather than a better one; an ensemble tells how far draws lie apart.") +
         table("The run as described and with half the step",
               {{"Quantity", "", false}, {"As described", ""}, {"Half the step", ""}, {"Change", ""}},
               table_rows);
}

}  // namespace

std::string energy_error_words(const RunResult& run) {
  const EnergyHistory& e = run.energy;
  const std::string standing = run.response.first_loss_of_support
                                   ? significant(100 * e.standing_error, 2) +
                                         " % of the input until the first block lost its support, "
                                   : "";
  return fmt::format("{}{} % of the input in all, {} % of the energy turned over", standing,
                     significant(100 * e.input_error, 2), significant(100 * e.relative_error, 2));
}

Html page_numerics(const RunResult& run, const std::vector<Picture>& pictures) {
  return warning_list(run) + numerics_table(run) +
         figure_named(pictures, "figures/overlap.svg",
                      "How deep blocks were pressed into each other, against the smaller block's width.",
                      {"figures/overlap.svg", "figures/overlap.png", "overlap.csv"}) +
         heading3("Half the step") + half_step_part(run.ensemble);
}

}  // namespace dougong::app
