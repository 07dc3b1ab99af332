// The section of the report that says how sure it is: the members of the ensemble and the run with half the
// step.
#include <fmt/format.h>

#include <cmath>

#include "app/report/page.h"
#include "app/report/spread_text.h"
#include "app/report/text.h"

namespace dougong::app {
namespace {

std::vector<std::string> row_of(const EnsembleSheet& e, std::size_t metric) {
  const auto print = [&](double value) { return metric_text(e.metrics[metric], e.units[metric], value); };
  const auto value_of = [&](const EnsembleMember& member) {
    return member.done && metric < member.values.size() ? print(member.values[metric]) : "not run";
  };
  const Spread s = spread_of_metric(e, metric);
  return {e.metrics[metric],      value_of(e.members.front()),
          value_of(e.half_step),  print(s.low),
          print(s.median),        print(s.high),
          print(s.least),         print(s.most),
          std::to_string(s.count)};
}

Html metrics_table(const EnsembleSheet& e) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t metric = 0; metric < e.metrics.size(); ++metric) rows.push_back(row_of(e, metric));
  return table("Sizes without sign, before any loss of the storey",
               {{"Quantity", "", false},
                {"As described", ""},
                {"Half the step", ""},
                {"16 %", ""},
                {"Median", ""},
                {"84 %", ""},
                {"Least", ""},
                {"Most", ""},
                {"Runs", ""}},
               rows);
}

Html changes_table(const EnsembleSheet& e) {
  std::vector<std::vector<std::string>> rows;
  for (const NamedValue& p : e.perturbations) rows.push_back({p.name, p.value, p.meaning});
  return table("What was changed, at most",
               {{"Change", "", false}, {"Amount", "", false}, {"Of what", "", false}}, rows);
}

// Whether more accuracy would buy anything: the change by half the step against the spread.
std::string advice(const EnsembleSheet& e) {
  if (!e.half_step.done || e.half_step.values.empty() || e.members.front().values.empty()) return "";
  const Spread s = spread_of_metric(e, 0);
  const double change = std::abs(e.half_step.values[0] - e.members.front().values[0]);
  const double spread = 0.5 * (s.high - s.low);
  const auto print = [&](double value) { return metric_text(e.metrics[0], e.units[0], value); };
  return fmt::format(
      "Half the step changes the {} by {}, small changes of the building by {} (half the distance from 16 to "
      "84 "
      "%): {}",
      e.metrics[0], print(change), print(spread),
      change < spread ? "a smaller step would not make the answer surer."
                      : "the step matters more than what is not known of the building; take a smaller one.");
}

}  // namespace

Html page_spread(const RunResult& run, const std::vector<Picture>& pictures) {
  const EnsembleSheet& e = run.ensemble;
  if (e.members.size() < 2)
    return paragraph(
        "Not known from this run: the building was shaken once. Blocks that slide or rock move chaotically, "
        "so "
        "small changes of the building or of the step may change the numbers, and near a collapse the "
        "verdict. "
        "ensemble.n = 16 runs it again with small changes." +
        (e.half_step.done ? " With half the step: " + half_step_text(e) + "." : std::string()));
  Html out = paragraph("The building " + collapse_text(e) + ".");
  const std::string words = advice(e);
  if (!words.empty()) out += paragraph(words);
  out += figure_named(
      pictures, "figures/ensemble.svg",
      "Every run of the ensemble, and how far small changes and the step move its peak drift.",
      {"figures/ensemble.svg", "figures/ensemble.png", "ensemble.csv", "ensemble_roof_drift.csv"});
  return out + metrics_table(e) + changes_table(e);
}

}  // namespace dougong::app
