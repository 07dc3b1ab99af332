#include "app/cli/compare_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/report/comparison_text.h"
#include "app/report/spread_text.h"
#include "app/report/text.h"

namespace dougong::app {
namespace {

std::string period_text(double period) {
  return period > 0.0 ? fmt::format("T1 {:.3f} s", period) : "no period found";
}

// fmt counts bytes where a true minus sign has three.
std::string padded(const std::string& text, std::size_t width) {
  std::size_t length = 0;
  for (const char c : text) length += (static_cast<unsigned char>(c) & 0xc0u) != 0x80u;
  return text + std::string(width > length ? width - length : 1, ' ');
}

std::string table_line(const std::string& metric, const std::string& reference, const std::string& variant,
                       const std::string& difference, const std::string& finding) {
  return "  " + padded(metric, 29) + padded(reference, 12) + padded(variant, 12) + padded(difference, 40) +
         finding;
}

Tone tone_of(Finding finding) {
  return finding == Finding::different  ? Tone::good
         : finding == Finding::unproven ? Tone::doubtful
                                        : Tone::plain;
}

std::string share_text(std::size_t events, std::size_t pairs) {
  return pairs > 0 ? fmt::format("{} of {}", events, pairs) : "n/a";
}

ToneLine line_of(const CollapseDifference& d) {
  const std::size_t n = d.counts.pairs();
  return {table_line("collapses", share_text(d.counts.both + d.counts.first, n),
                     share_text(d.counts.both + d.counts.second, n), interval_text(d), finding_text(d)),
          tone_of(d.finding)};
}

ToneLine line_of(const Difference& d) {
  const auto print = [&](double value) { return metric_text(d.metric, d.unit, value); };
  return {table_line(d.metric, print(d.reference.median), print(d.variant_spread.median), interval_text(d),
                     finding_text(d)),
          tone_of(d.finding)};
}

std::string pairs_text(const Comparison& c, const CollapseDifference& d) {
  const std::size_t pairs = d.counts.pairs() + d.left_out;
  std::string text = fmt::format("{}: {} on {}", to_string(d.view), plural(pairs, "pair"),
                                 plural(c.records.size(), "record"));
  if (d.left_out > 0) text += fmt::format("; {} without an answer to whether it collapses", d.left_out);
  return text;
}

}  // namespace

std::vector<ToneLine> variants_text(const std::vector<VariantSheet>& variants) {
  std::vector<ToneLine> lines;
  for (const VariantSheet& v : variants)
    lines.push_back({row(&v == &variants.front() ? "reference" : "variant",
                         fmt::format("{}: {}, {}, {}", v.name, plural(v.blocks, "block"), mass_text(v.mass),
                                     period_text(v.period)))});
  return lines;
}

std::vector<ToneLine> cost_text(const ComparisonCost& cost, std::size_t jobs) {
  std::vector<ToneLine> lines;
  if (cost.kept > 0)
    lines.push_back({row("kept", fmt::format("{} of {} folders are complete from the same inputs: not run "
                                             "again",
                                             cost.kept, cost.cases))});
  if (cost.runs == 0) return lines;
  lines.push_back({row("cost", fmt::format("about {} of processor time for {}, {} at a time",
                                           time_text(cost.seconds), plural(cost.runs, "run"), jobs))});
  if (cost.runs_of_same_sa > 0)
    lines.push_back({row("same Sa(T1)", fmt::format("{} of them, as the periods differ (--same-sa no leaves "
                                                    "them out)",
                                                    cost.runs_of_same_sa))});
  return lines;
}

std::vector<ToneLine> comparison_tables(const Comparison& c, const std::vector<Difference>& differences,
                                        const std::vector<CollapseDifference>& collapses) {
  std::vector<ToneLine> lines;
  for (const CollapseDifference& collapse : collapses) {
    lines.push_back({});
    lines.push_back({c.variants[collapse.variant].name + " against " + c.variants.front().name});
    lines.push_back({"  " + pairs_text(c, collapse), Tone::faint});
    lines.push_back(
        {table_line("", "reference", "variant", "mean difference (95 % interval)", ""), Tone::faint});
    lines.push_back(line_of(collapse));
    for (const Difference& d : of_variant(differences, collapse.view, collapse.variant))
      if (is_of_the_building(d) && d.finding != Finding::no_pairs) lines.push_back(line_of(d));
  }
  return lines;
}

}  // namespace dougong::app
