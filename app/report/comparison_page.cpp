#include "app/report/comparison_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/report/comparison_figures.h"
#include "app/report/comparison_legend.h"
#include "app/report/comparison_text.h"
#include "app/report/page.h"
#include "app/report/page_frame.h"
#include "app/report/spread_text.h"
#include "app/report/text.h"

namespace dougong::app {
namespace {

std::string title_of(const ComparisonPage& page) {
  const Comparison& c = page.comparison;
  return fmt::format("{}: {} variants on {}", page.layout, c.variants.size(),
                     plural(c.records.size(), "record"));
}

/// "peak drift −2.10 % (−2.60 % to −1.71 %): different"
std::string drift_sentence(const ComparisonPage& page, const CollapseDifference& collapse) {
  const auto own = of_variant(page.differences, collapse.view, collapse.variant);
  const auto it = std::ranges::find(own, std::string("peak drift"), &Difference::metric);
  if (it == own.end() || it->finding == Finding::no_pairs) return "";
  return fmt::format("; median peak drift {} against {}, mean difference {}: {}",
                     metric_text(it->metric, it->unit, it->variant_spread.median),
                     metric_text(it->metric, it->unit, it->reference.median), interval_text(*it),
                     finding_text(*it));
}

/// "collapses in 0 of 8 against 8 of 8: different"
std::string collapse_clause(const CollapseDifference& d) {
  if (d.counts.pairs() == 0) return "no pair has an answer to whether it collapses";
  const std::string open =
      d.left_out > 0 ? fmt::format(" ({} without an answer)", plural(d.left_out, "pair")) : "";
  return fmt::format("collapses in {}{}: {}", counts_text(d), open, finding_text(d));
}

std::string sentence(const ComparisonPage& page, const CollapseDifference& d) {
  return fmt::format("{} {} ({}): {}{}.", letter(d.variant), page.comparison.variants[d.variant].name,
                     to_string(d.view), collapse_clause(d), drift_sentence(page, d));
}

bool proves_nothing(const ComparisonPage& page) {
  return std::ranges::none_of(page.differences,
                              [](const Difference& d) { return d.interval.resampled != Resampled::nothing; });
}

Html single_notice(const ComparisonPage& page) {
  if (!proves_nothing(page)) return {};
  return raw("<div class=\"notice\" role=\"note\"><strong>Too few runs.</strong> ") +
         text(
             "One run proves nothing: blocks that slide or rock move chaotically. --ensemble 16, or five "
             "records, give intervals.") +
         raw("</div>\n");
}

Html collapse_notice(const ComparisonPage& page) {
  const bool fell = std::ranges::any_of(page.collapses, [](const CollapseDifference& d) {
    return d.counts.both + d.counts.first + d.counts.second > 0;
  });
  if (!fell) return {};
  return paragraph(
      "Some of the buildings collapse. Drifts, accelerations and base shear are those before a storey is "
      "lost: "
      "where one variant collapses and the other stands, their difference says little.",
      "quiet");
}

Html figures_of(const ComparisonPage& page, const std::string& name, std::string_view caption) {
  Html out;
  for (const char* view : {"", "_same_sa"})
    out += figure_named(page.pictures, "figures/" + name + view + ".svg", caption,
                        {"compare.csv", "differences.csv"});
  return out;
}

Html differences_part(const ComparisonPage& page) {
  Html out = paragraph(method_text(page.comparison, page.differences));
  if (const std::string words = multiplicity_text(page.differences); !words.empty())
    out += paragraph(words, "quiet");
  out += figures_of(page, "differences", "What differs, and how surely.");
  for (const View view : page.comparison.views) out += difference_tables(page, view);
  return out;
}

Html profiles_part(const ComparisonPage& page) {
  return figures_of(page, "drift_profiles",
                    "How far each storey drifts: medians of all runs, with 16 to 84 % as bands.");
}

std::string story_title(const ComparisonPage& page, const RecordStory& story) {
  return page.comparison.records[story.record] + ", " + to_string(story.view);
}

Html histories_part(const ComparisonPage& page) {
  Html out;
  for (const RecordStory& story : page.stories)
    out += figure_named(page.pictures, story.histories, "The runs as described, over one time axis.");
  if (page.comparison.variants.size() > most_drawn_variants)
    out += paragraph(fmt::format("The first {} variants are drawn; the tables and compare.csv hold all.",
                                 most_drawn_variants),
                     "quiet");
  return out;
}

/// "12.30 s  S3.column.left: support lost, fell 1.30 m"
std::string event_text(const CollapseEvent& e) {
  return seconds(e.time) + "  " + (e.where.empty() ? "" : e.where + ": ") + e.what +
         (e.how.empty() ? "" : ", " + e.how);
}

Html failures_table(const ComparisonPage& page, const RecordStory& story) {
  std::vector<Heading> heads{{"", "", false}};
  std::size_t most = 0;
  for (const std::size_t v : story.variants)
    heads.push_back({letter(v), page.comparison.variants[v].name, false});
  for (const auto& events : story.failures) most = std::max(most, events.size());
  std::vector<std::vector<std::string>> rows{{"verdict"}};
  for (const std::string& verdict : story.verdicts) rows.front().push_back(verdict);
  for (std::size_t i = 0; i < most; ++i) {
    rows.push_back({std::to_string(i + 1)});
    for (const auto& events : story.failures)
      rows.back().push_back(i < events.size() ? event_text(events[i]) : "–");
  }
  return table(story_title(page, story), heads, rows);
}

Html failures_part(const ComparisonPage& page) {
  Html out = paragraph(
      "The first failures of the runs as described, in order of time: bonds that crack or break, blocks and "
      "storeys that are lost.");
  for (const RecordStory& story : page.stories) out += failures_table(page, story);
  return out;
}

Html film_part(const ComparisonPage& page) {
  Html out;
  for (const RecordStory& story : page.stories)
    for (std::size_t i = 0; i < story.strips.size(); ++i)
      out += figure_named(
          page.pictures, story.strips[i],
          letter(story.variants[i]) + "  " + page.comparison.variants[story.variants[i]].name + ", " +
              story_title(page, story) + ". Moments, camera and colours are the same for all variants.");
  return out;
}

Html limits_part(const ComparisonPage& page) {
  std::vector<std::string> items{
      "It says how these models differ, not how buildings do: what was left out of all of them is left out "
      "of "
      "their difference. The report of each run lists it.",
      "Small changes are those of the ensemble (docs/scenario.md): where blocks stand, friction, strength, "
      "damping and the size of the motion."};
  if (page.comparison.views.size() > 1)
    items.push_back(
        "The periods differ. On the same motion a variant may be better because this motion has less at its "
        "period; scaled to the same Sa(T1) that is taken away, but then the motions differ in all else. T1 "
        "is "
        "that of small amplitudes: blocks that rock have longer ones.");
  else if (std::ranges::any_of(page.comparison.variants,
                               [](const VariantSheet& v) { return !(v.period > 0.0); }))
    items.push_back("A variant has no first period, so that motions cannot be scaled to it.");
  return list(items);
}

Html runs_part(const ComparisonPage& page) {
  std::vector<std::vector<std::string>> rows;
  for (const ComparedRun& run : page.comparison.runs)
    rows.push_back({run.folder, to_string(run.view), significant(run.factor, 4),
                    structures::to_string(run.sheet.members.front().verdict),
                    std::to_string(run.sheet.members.size()), run.sheet.members.front().state_hash});
  return raw("<pre>") + text(page.command) + raw("</pre>\n") + paragraph(page.version, "small quiet") +
         paragraph(
             "Every folder holds results.h5 and summary.json; “dougong report FOLDER” draws its report. "
             "The same command again runs only what is missing.") +
         table("",
               {{"Folder", "", false},
                {"View", "", false},
                {"Factor on the motion", ""},
                {"Verdict as described", "", false},
                {"Runs", ""},
                {"State at the end", "hash", false}},
               rows);
}

}  // namespace

Html comparison_answer(const ComparisonPage& page) {
  const Comparison& c = page.comparison;
  Html out = raw("<header id=\"answer\">\n<h1>") + text(title_of(page)) + raw("</h1>\n");
  out += paragraph("Reference: A " + c.variants.front().name + "; " + c.variants.front().title, "quiet");
  std::vector<std::string> sentences;
  for (const CollapseDifference& d : page.collapses) sentences.push_back(sentence(page, d));
  out += raw("<div class=\"verdict undecided\">\n<p class=\"kind\">Against the reference</p>\n") +
         list(sentences) + raw("</div>\n");
  return out + single_notice(page) + collapse_notice(page) + heat_tables(page) + raw("</header>\n");
}

std::string comparison_page(const ComparisonPage& page) {
  return framed_page(title_of(page), comparison_answer(page),
                     {{"variants", "The variants", variants_part(page)},
                      {"differences", "The differences", differences_part(page)},
                      {"profiles", "Drift profiles", profiles_part(page)},
                      {"histories", "Histories", histories_part(page)},
                      {"failures", "What failed, in which order", failures_part(page)},
                      {"film", "What it looked like", film_part(page)},
                      {"limits", "What this does not say", limits_part(page)},
                      {"runs", "The runs, and how to repeat them", runs_part(page)}});
}

}  // namespace dougong::app
