#include "app/report/screening_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/report/csv.h"
#include "app/report/text.h"

namespace dougong::app {
namespace {

using structures::CodeCheck;

std::string limit_words(const CodeCheck& c) {
  return fmt::format("{} ({}{}, {})", c.limit_name, drift_fraction(c.limit),
                     c.measure == "residual drift" ? " residual" : "", c.subject);
}

double over(const CodeCheck& c) {
  return c.limit > 0.0 ? c.found / c.limit : 0.0;
}

/// The limit that is nearest to its verdict's edge: the least exceeded, or the one that was nearly reached.
std::string edge_words(const std::vector<CodeCheck>& checks) {
  std::vector<CodeCheck> exceeded = checks, kept = checks;
  std::erase_if(exceeded, [](const CodeCheck& c) { return !c.exceeded; });
  std::erase_if(kept, [](const CodeCheck& c) { return c.exceeded; });
  std::string words;
  if (!exceeded.empty())
    words += "; farthest exceeded: " + limit_words(*std::ranges::max_element(exceeded, {}, over));
  if (!kept.empty()) {
    const CodeCheck& nearest = *std::ranges::max_element(kept, {}, over);
    words += fmt::format("; nearest kept: {} at {:.2f} of it", limit_words(nearest), over(nearest));
  }
  return words;
}

}  // namespace

std::vector<std::string> screened_standards(const ScreeningSheet& sheet) {
  std::vector<std::string> standards;
  for (const CodeCheck& check : sheet.checks)
    if (std::ranges::find(standards, check.standard) == standards.end()) standards.push_back(check.standard);
  return standards;
}

std::vector<std::string> screening_lines(const ScreeningSheet& sheet) {
  std::vector<std::string> lines;
  for (const std::string& standard : screened_standards(sheet)) {
    std::vector<CodeCheck> checks = sheet.checks;
    std::erase_if(checks, [&](const CodeCheck& c) { return c.standard != standard; });
    lines.push_back(fmt::format("{}: {} of {} exceeded{}", standard,
                                std::ranges::count_if(checks, &CodeCheck::exceeded),
                                plural(checks.size(), "limit"), edge_words(checks)));
  }
  return lines;
}

std::string screening_csv(const ScreeningSheet& sheet) {
  std::string text = "standard,clause,subject,limit,measure,limit (1),found (1),exceeded,source\n";
  for (const CodeCheck& c : sheet.checks)
    text += fmt::format("{},{},{},{},{},{},{},{},{}\n", csv_text(c.standard), csv_text(c.clause),
                        csv_text(c.subject), csv_text(c.limit_name), c.measure, exact(c.limit),
                        exact(c.found), c.exceeded ? 1 : 0, c.status);
  return text;
}

}  // namespace dougong::app
