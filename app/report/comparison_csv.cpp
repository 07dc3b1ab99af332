#include "app/report/comparison_csv.h"

#include <cmath>

#include "app/report/comparison_text.h"
#include "app/report/csv.h"
#include "app/report/text.h"

namespace dougong::app {
namespace {

std::string cell(double value) {
  return "," + (std::isfinite(value) ? exact(value) : std::string());
}
std::string cell(std::size_t value) {
  return "," + std::to_string(value);
}
std::string cell(const std::string& text) {
  return "," + csv_text(text);
}

std::string member_rows(const std::string& start, const std::string& name, const EnsembleSheet& sheet,
                        const EnsembleMember& member) {
  std::string out;
  if (!member.done) return out;
  for (std::size_t i = 0; i < std::min(sheet.metrics.size(), member.values.size()); ++i)
    out += start + "," + name + cell(structures::to_string(member.verdict)) + cell(sheet.metrics[i]) +
           cell(member.values[i]) + cell(sheet.units[i]) + "\n";
  return out;
}

std::string rows_of(const Comparison& c, View view, const ComparedRun& run) {
  const std::string start = csv_text(c.variants[run.variant].name) + cell(c.records[run.record]) +
                            cell(to_string(view)) + cell(run.factor);
  std::string out;
  for (std::size_t m = 0; m < run.sheet.members.size(); ++m)
    out += member_rows(start, std::to_string(m), run.sheet, run.sheet.members[m]);
  return out + member_rows(start, "half step", run.sheet, run.sheet.half_step);
}

std::string start_of(const Comparison& c, View view, std::size_t variant, const std::string& metric) {
  return csv_text(c.variants[variant].name) + cell(c.variants.front().name) + cell(to_string(view)) +
         cell(metric);
}

std::string row(const Comparison& c, const Difference& d) {
  return start_of(c, d.view, d.variant, d.metric) + cell(d.unit) + cell(d.pairs) + cell(d.reference.median) +
         cell(d.variant_spread.median) + cell(d.reference_mean) + cell(d.interval.mean) +
         cell(d.interval.low) + cell(d.interval.high) + cell(resampled_text(d.interval.resampled)) +
         cell(d.numerical) + cell(finding_text(d)) + "\n";
}

double share(std::size_t events, std::size_t pairs) {
  return pairs > 0 ? static_cast<double>(events) / static_cast<double>(pairs) : std::nan("");
}

std::string row(const Comparison& c, const CollapseDifference& d) {
  const std::size_t n = d.counts.pairs();
  const double none = std::nan("");
  return start_of(c, d.view, d.variant, "collapse") + ",1" + cell(n) + cell(none) + cell(none) +
         cell(share(d.counts.both + d.counts.first, n)) + cell(d.shares.difference) + cell(d.shares.low) +
         cell(d.shares.high) + cell("none: Newcombe") + cell(none) + cell(finding_text(d)) + "\n";
}

}  // namespace

std::string comparison_csv(const Comparison& comparison) {
  std::string out = "variant,record,view,factor (1),member,verdict,metric,value,unit\n";
  for (const View view : comparison.views)
    for (std::size_t v = 0; v < comparison.variants.size(); ++v)
      for (std::size_t r = 0; r < comparison.records.size(); ++r)
        if (const ComparedRun* run = comparison.find(view, v, r)) out += rows_of(comparison, view, *run);
  return out;
}

std::string differences_csv(const Comparison& comparison, const std::vector<Difference>& differences,
                            const std::vector<CollapseDifference>& collapses) {
  std::string out =
      "variant,reference,view,metric,unit,pairs,median of reference,median of variant,mean of reference,"
      "mean difference,low 95 %,high 95 %,resampled,numerical error,finding\n";
  for (const CollapseDifference& d : collapses) out += row(comparison, d);
  for (const Difference& d : differences) out += row(comparison, d);
  return out;
}

}  // namespace dougong::app
