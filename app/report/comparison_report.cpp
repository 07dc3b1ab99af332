#include "app/report/comparison_report.h"

#include "app/report/comparison_csv.h"
#include "app/report/safe_file.h"

namespace dougong::app {

std::vector<std::string> write_comparison(const Comparison& comparison, const RunLoader&,
                                          const std::filesystem::path& folder) {
  const auto differences = differences_of(comparison);
  const auto collapses = collapses_of(comparison);
  write_file(folder / "compare.csv", comparison_csv(comparison));
  write_file(folder / "differences.csv", differences_csv(comparison, differences, collapses));
  return {"compare.csv", "differences.csv"};
}

}  // namespace dougong::app
