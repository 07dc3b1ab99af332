// compare.html: one page that opens offline and prints on A4. The first screen says which variants were
// compared on what and which differences hold; tables, figures, failures and film strips follow.
#pragma once

#include <string>
#include <vector>

#include "app/report/collapse_sequence.h"
#include "app/report/html.h"
#include "app/study/compare/differences.h"

namespace dougong::app {

/// What the page shows of one record in one view.
struct RecordStory {
  View view = View::same_motion;
  std::size_t record = 0;
  std::vector<std::size_t> variants;                 // drawn
  std::vector<std::vector<CollapseEvent>> failures;  // of each of them, the first
  std::vector<std::string> verdicts;                 // of each, the headline
  std::string histories;                             // name of the picture
  std::vector<std::string> strips;                   // names of the pictures, one a variant; may be empty
};

struct ComparisonPage {
  const Comparison& comparison;
  const std::vector<Difference>& differences;
  const std::vector<CollapseDifference>& collapses;
  const std::vector<Picture>& pictures;
  std::vector<RecordStory> stories;
  std::string layout;   // of the reference
  std::string command;  // of the first run
  std::string version;
};

std::string comparison_page(const ComparisonPage& page);

// Its parts.
Html comparison_answer(const ComparisonPage& page);
Html variants_part(const ComparisonPage& page);
/// Variant by metric, coloured by the difference to the reference; one table a view.
Html heat_tables(const ComparisonPage& page);
Html difference_tables(const ComparisonPage& page, View view);

}  // namespace dougong::app
