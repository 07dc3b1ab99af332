#include "seismic/formats/table_rows.h"

#include <fmt/format.h>

#include "seismic/numerics/parse_number.h"

namespace dougong::seismic {
namespace {

constexpr std::size_t most_problems = 100;

}  // namespace

std::vector<std::vector<double>> columns_of(const std::vector<double>& values, std::size_t columns) {
  std::vector<std::vector<double>> out(columns);
  for (std::size_t c = 0; c < columns; ++c) {
    out[c].reserve(values.size() / columns);
    for (std::size_t i = c; i < values.size(); i += columns) out[c].push_back(values[i]);
  }
  return out;
}

std::vector<std::vector<double>> read_table_rows(const FileText& text, std::size_t first, std::size_t columns,
                                                 std::vector<InputProblem>& problems) {
  std::vector<double> values;
  values.reserve(text.bytes.size() / 8);
  for (std::size_t i = first; i < text.lines.size() && problems.size() < most_problems; ++i) {
    const std::size_t before = values.size();
    const std::string_view culprit = append_numbers(text.lines[i], values);
    const std::size_t found = values.size() - before;
    if (culprit.empty() && (found == columns || found == 0)) continue;
    problems.push_back({text.name, i + 1, fmt::format("{} finite numbers", columns),
                        culprit.empty() ? fmt::format("{}", found) : in_quotes(culprit.substr(0, 60))});
    values.resize(before);
  }
  return columns_of(values, columns);
}

}  // namespace dougong::seismic
