// The section of the report on the drift limits of standards: screening, not code compliance.
#include <algorithm>

#include "app/report/page.h"
#include "app/report/screening_text.h"
#include "app/report/text.h"

namespace dougong::app {
namespace {

using structures::CodeCheck;

std::vector<std::string> check_row(const CodeCheck& c) {
  return {c.subject,
          c.clause,
          c.limit_name + (c.measure == "residual drift" ? ", residual" : ""),
          fixed(100 * c.limit, 3),
          drift_fraction(c.limit),
          fixed(100 * c.found, 3),
          c.limit > 0 ? fixed(c.found / c.limit, 2) : "n/a",
          c.exceeded ? "exceeded" : "within",
          c.status};
}

Html checks_table(const std::string& standard, const std::vector<CodeCheck>& checks) {
  std::vector<std::vector<std::string>> rows;
  for (const CodeCheck& check : checks)
    if (check.standard == standard) rows.push_back(check_row(check));
  return table(standard,
               {{"For", "", false},
                {"Clause", "", false},
                {"Limit", "", false},
                {"Value", "%"},
                {"as", "1/n"},
                {"Found", "%"},
                {"Found / limit", "-"},
                {"Finding", "", false},
                {"Source", "", false}},
               rows);
}

}  // namespace

Html page_screening(const RunResult& run) {
  const ScreeningSheet& s = run.screening;
  if (s.notes.empty() && s.checks.empty()) return paragraph("No standard was looked at.");
  if (s.checks.empty()) return list(s.notes);
  Html out = paragraph(
      "Screening, not code compliance: a plane model of rigid blocks on one motion is no design check. Found "
      "are the greatest interstorey drift ratio before any loss, and the greatest residual one of a storey "
      "that stands. Structural type: " +
      s.structural_type + ".");
  if (std::ranges::any_of(run.response.storeys,
                          [](const auto& storey) { return storey.lost_at.has_value(); }))
    out += raw("<p class=\"bad\">") +
           text("A storey was lost: no limit is kept, whatever its drift was before.") + raw("</p>\n");
  for (const std::string& standard : screened_standards(s)) out += checks_table(standard, s.checks);
  return out + heading3("What these limits are for") + list(s.notes) +
         paragraph(
             "Source of the numbers: 2 seen in two independent places, 1 in one, d derived from another "
             "row. Check them against the standard before you cite them.",
             "quiet");
}

}  // namespace dougong::app
