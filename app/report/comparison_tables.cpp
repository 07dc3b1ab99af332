// The tables of a comparison: variants, the heat table, the differences one by one.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/colour.h"
#include "app/report/comparison_figures.h"
#include "app/report/comparison_page.h"
#include "app/report/comparison_text.h"
#include "app/report/spread_text.h"
#include "app/report/text.h"

namespace dougong::app {
namespace {

constexpr double strongest = 1.0;  // difference over the mean of the reference, where the colour is full

std::string lettered(const Comparison& c, std::size_t variant) {
  return letter(variant) + "  " + c.variants[variant].name;
}

// Blue is less than the reference, vermillion more, white equal: Okabe and Ito's.
Colour shade(double relative) {
  const double share = 0.62 * std::clamp(std::abs(relative) / strongest, 0.08, 1.0);
  return mixed(ink::white, relative < 0.0 ? category(0) : category(1), share);
}

// A column is narrower than the word.
std::string hyphened(std::string words) {
  const std::string word = "distinguishable";
  if (const auto at = words.find(word); at != std::string::npos)
    words.replace(at, word.size(), "distin\u00ADguishable");
  return words;
}

std::string heat_cell(const std::string& value, const std::string& more, const Colour* colour) {
  const std::string style =
      colour ? fmt::format(" style=\"background:{};color:#14161a\"", to_hex(*colour)) : std::string();
  return fmt::format("<td class=\"heat\"{}><b>{}</b><small>{}</small></td>", style, escape_markup(value),
                     escape_markup(hyphened(more)));
}

std::string heat_cell(const Difference& d) {
  if (d.finding == Finding::no_pairs) return heat_cell("n/a", "no pairs", nullptr);
  const std::string median = metric_text(d.metric, d.unit, d.variant_spread.median);
  if (d.finding != Finding::different) return heat_cell(median, finding_text(d), nullptr);
  const double relative = d.reference_mean > 0.0 ? d.interval.mean / d.reference_mean : 0.0;
  const Colour colour = shade(d.reference_mean > 0.0 ? relative : std::copysign(strongest, d.interval.mean));
  const std::string more =
      d.reference_mean > 0.0 ? signed_fixed(100.0 * relative, 0) + " %" : difference_text(d, d.interval.mean);
  return heat_cell(median, more, &colour);
}

std::string heat_cell(const CollapseDifference& d) {
  const std::size_t n = d.counts.pairs();
  if (n == 0) return heat_cell("n/a", "no pairs", nullptr);
  const std::string value = fmt::format("{} of {}", d.counts.both + d.counts.second, n);
  if (d.finding != Finding::different) return heat_cell(value, finding_text(d), nullptr);
  const Colour colour = shade(d.shares.difference);
  return heat_cell(value, signed_fixed(100.0 * d.shares.difference, 0) + " points", &colour);
}

/// Metrics of the building that some variant has pairs of.
std::vector<Difference> columns_of(const std::vector<Difference>& differences, View view) {
  std::vector<Difference> columns;
  for (const Difference& d : differences)
    if (d.view == view && is_of_the_building(d) && d.pairs > 0 &&
        std::ranges::find(columns, d.metric, &Difference::metric) == columns.end())
      columns.push_back(d);
  return columns;
}

std::string heat_head(const std::vector<Difference>& columns) {
  std::string out =
      "<thead><tr><th scope=\"col\">Variant</th><th scope=\"col\" class=\"heat\">collapses</th>";
  for (const Difference& d : columns)
    out += "<th scope=\"col\" class=\"heat\">" + escape_markup(d.metric) + "</th>";
  return out + "</tr></thead>\n";
}

std::string reference_row(const ComparisonPage& page, View view, const std::vector<Difference>& columns) {
  const CollapseDifference* collapse = find_collapse(page.collapses, view, columns.front().variant);
  const std::size_t n = collapse ? collapse->counts.pairs() : 0;
  std::string out =
      "<tr><th scope=\"row\">" + escape_markup(lettered(page.comparison, 0)) + "</th>" +
      (n > 0 ? heat_cell(fmt::format("{} of {}", collapse->counts.both + collapse->counts.first, n),
                         "reference", nullptr)
             : heat_cell("n/a", "reference", nullptr));
  for (const Difference& d : columns)
    out += heat_cell(metric_text(d.metric, d.unit, d.reference.median), "reference", nullptr);
  return out + "</tr>\n";
}

std::string heat_row(const ComparisonPage& page, const CollapseDifference& collapse,
                     const std::vector<Difference>& columns) {
  std::string out = "<tr><th scope=\"row\">" + escape_markup(lettered(page.comparison, collapse.variant)) +
                    "</th>" + heat_cell(collapse);
  const auto own = of_variant(page.differences, collapse.view, collapse.variant);
  for (const Difference& column : columns) {
    const auto it = std::ranges::find(own, column.metric, &Difference::metric);
    out += it == own.end() ? heat_cell("n/a", "it has none", nullptr) : heat_cell(*it);
  }
  return out + "</tr>\n";
}

Html heat_table(const ComparisonPage& page, View view) {
  const auto columns = columns_of(page.differences, view);
  if (columns.empty()) return {};
  std::string out = "<div class=\"scroll\"><table class=\"heat\">\n<caption>" +
                    escape_markup(to_string(view)) +
                    ": medians; below them the mean difference to the reference, over its mean</caption>\n" +
                    heat_head(columns) + "<tbody>\n" + reference_row(page, view, columns);
  for (const CollapseDifference& collapse : page.collapses)
    if (collapse.view == view) out += heat_row(page, collapse, columns);
  return raw(out + "</tbody></table></div>\n");
}

std::vector<std::string> row_of(const Difference& d) {
  const auto print = [&](double value) { return metric_text(d.metric, d.unit, value); };
  const bool has_interval = d.interval.resampled != Resampled::nothing;
  return {d.metric,
          print(d.reference.median),
          print(d.variant_spread.median),
          difference_text(d, d.interval.mean),
          has_interval ? difference_text(d, d.interval.low) : "–",
          has_interval ? difference_text(d, d.interval.high) : "–",
          print(d.numerical),
          std::to_string(d.pairs),
          finding_text(d)};
}

std::string factor_text(const Comparison& c, std::size_t variant, std::size_t record) {
  const ComparedRun* run = c.find(View::same_sa, variant, record);
  return run ? significant(run->factor, 3) : "none: no period";
}

}  // namespace

Html variants_part(const ComparisonPage& page) {
  const Comparison& c = page.comparison;
  std::vector<std::vector<std::string>> rows;
  for (std::size_t v = 0; v < c.variants.size(); ++v) {
    const VariantSheet& sheet = c.variants[v];
    rows.push_back({lettered(c, v) + (v == 0 ? " (reference)" : ""), std::to_string(sheet.blocks),
                    std::to_string(sheet.bonds), mass_text(sheet.mass),
                    sheet.period > 0.0 ? fixed(sheet.period, 3) : "none"});
  }
  Html out =
      table("", {{"Variant", "", false}, {"Blocks", ""}, {"Bonds", ""}, {"Mass", ""}, {"T1", "s"}}, rows);
  if (c.views.size() < 2) return out;
  std::vector<Heading> heads{{"Variant", "", false}};
  for (const std::string& record : c.records) heads.push_back({record, ""});
  rows.clear();
  for (std::size_t v = 0; v < c.variants.size(); ++v) {
    rows.push_back({lettered(c, v)});
    for (std::size_t r = 0; r < c.records.size(); ++r) rows.back().push_back(factor_text(c, v, r));
  }
  return out + table(
                   "Factor on the motion in the view “same Sa(T1)”: PSa at 5 % damping and the variant's own "
                   "first period is then that of the reference",
                   heads, rows);
}

Html heat_tables(const ComparisonPage& page) {
  Html out = paragraph(
      "Coloured where the difference is distinguishable: blue is less than the reference, vermillion more, "
      "full "
      "at 100 %. Sizes without sign; drifts, accelerations and base shear before a storey is lost, so that "
      "where one collapses the column of collapses says more.");
  for (const View view : page.comparison.views) out += heat_table(page, view);
  return out;
}

Html difference_tables(const ComparisonPage& page, View view) {
  Html out;
  for (const CollapseDifference& collapse : page.collapses) {
    if (collapse.view != view) continue;
    std::vector<std::vector<std::string>> rows;
    for (const Difference& d : of_variant(page.differences, view, collapse.variant))
      if (is_of_the_building(d) && d.finding != Finding::no_pairs) rows.push_back(row_of(d));
    out +=
        heading3(lettered(page.comparison, collapse.variant) + " against the reference, " + to_string(view));
    out += paragraph("Collapses: " + counts_text(collapse) + "; difference of the shares " +
                     interval_text(collapse) + ": " + finding_text(collapse) + "." +
                     (collapse.left_out > 0
                          ? " " + plural(collapse.left_out, "pair") + " without an answer left out."
                          : ""));
    out += table("",
                 {{"Quantity", "", false},
                  {"Reference", "median"},
                  {"Variant", "median"},
                  {"Difference", "mean"},
                  {"Low", "95 %"},
                  {"High", "95 %"},
                  {"Half the step", "changes by"},
                  {"Pairs", ""},
                  {"Finding", "", false}},
                 rows);
  }
  return out;
}

}  // namespace dougong::app
