#include "seismic/formats/columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include "seismic/formats/samples.h"
#include "seismic/numerics/parse_number.h"
#include "seismic/units.h"

namespace dougong::seismic {
namespace {

constexpr std::size_t longest_header = 100;  // lines of text above the numbers

struct Table {
  std::vector<std::vector<double>> rows;
  std::vector<std::size_t> lines;  // from 1, of each row
  std::size_t first = 0;           // index of the first row's line
  std::size_t columns = 0;         // of the first row
  bool regular = true;             // every row has as many
};

bool is_row(std::string_view line) {
  const NumberLine numbers = parse_numbers(line);
  return numbers.numeric && !numbers.values.empty();
}

// The numbers begin where two rows follow one another with as many fields: a lone number in a header (a
// count of points, a year) is not yet data.
std::optional<std::size_t> first_row(const FileText& text) {
  const std::size_t end = std::min(text.lines.size(), longest_header);
  for (std::size_t i = 0; i < end; ++i) {
    if (!is_row(text.lines[i])) continue;
    std::size_t next = i + 1;
    while (next < text.lines.size() && trimmed(text.lines[next]).empty()) ++next;
    if (next >= text.lines.size()) return i;
    const auto fields = [&](std::size_t line) { return parse_numbers(text.lines[line]).values.size(); };
    if (is_row(text.lines[next]) && (fields(i) == fields(next) || fields(i) > 2)) return i;
  }
  return std::nullopt;
}

Table read_table(const FileText& text, std::size_t first, std::vector<InputProblem>& problems) {
  Table table;
  table.first = first;
  for (std::size_t i = first; i < text.lines.size(); ++i) {
    if (trimmed(text.lines[i]).empty()) continue;
    NumberLine numbers = parse_numbers(text.lines[i]);
    if (!numbers.culprit.empty()) {
      problems.push_back({text.name, i + 1, "finite numbers", in_quotes(numbers.culprit)});
    }
    table.rows.push_back(std::move(numbers.values));
    table.lines.push_back(i + 1);
  }
  table.columns = table.rows.empty() ? 0 : table.rows.front().size();
  for (const auto& row : table.rows) table.regular = table.regular && row.size() == table.columns;
  return table;
}

// Half a unit in the last decimal of the time column, the coarsest in the file: "0.0100" -> 0.00005.
double time_rounding(const FileText& text, const Table& table) {
  double decimals = 15.0;
  for (const std::size_t line :
       {table.lines.front(), table.lines[table.lines.size() / 2], table.lines.back()}) {
    const std::string_view field = trimmed(text.lines[line - 1]);
    const std::string_view time = field.substr(0, field.find_first_of(" \t,;"));
    const auto point = time.find('.');
    if (time.find_first_of("eEdD") != std::string_view::npos) continue;
    const std::size_t digits = point == std::string_view::npos ? 0 : time.size() - point - 1;
    decimals = std::min(decimals, static_cast<double>(digits));
  }
  return 0.51 * std::pow(10.0, -decimals);
}

// Row whose step departs most from the mean one: where a sample is missing, repeated or shifted.
std::size_t oddest_row(const Table& table, double mean_step) {
  std::size_t odd = 1;
  const auto departure = [&](std::size_t k) {
    return std::abs(table.rows[k][0] - table.rows[k - 1][0] - mean_step);
  };
  for (std::size_t k = 1; k < table.rows.size(); ++k) {
    if (departure(k) > departure(odd) * (1.0 + 1e-6)) odd = k;
  }
  return odd;
}

// The step of a time column, every time within its rounding of an equal division. A column rounded so
// coarsely that this says little (half a step and more) is taken only with a step from the caller.
double uniform_interval(const FileText& text, const Table& table, const ReadOptions& options,
                        std::vector<InputProblem>& problems) {
  const auto& rows = table.rows;
  const double mean_step = (rows.back()[0] - rows.front()[0]) / static_cast<double>(rows.size() - 1);
  const double rounding = time_rounding(text, table);
  const double slack =
      std::max(0.01 * std::abs(mean_step), options.interval ? rounding : std::min(rounding, 0.5 * mean_step));
  bool uniform = mean_step > 0.0;
  for (std::size_t k = 1; k < rows.size() && uniform; ++k) {
    uniform = std::abs(rows[k][0] - rows[0][0] - mean_step * static_cast<double>(k)) <= slack;
  }
  if (uniform) return mean_step;
  const std::size_t odd = oddest_row(table, mean_step);
  const std::string step =
      fmt::format("a step of {:.6g} s to {:.6g} s", rows[odd][0] - rows[odd - 1][0], rows[odd][0]);
  problems.push_back({text.name, table.lines[odd],
                      mean_step > 0.0 ? fmt::format("equal time steps ({:.6g} s on average)", mean_step)
                                      : "times that increase",
                      step});
  return mean_step;
}

// A step of 0.00999999 read from rounded times is 0.01 when that explains every one of them.
double plain_interval(double step, std::size_t samples) {
  for (double scale = 1e2; scale <= 1e7; scale *= 10.0) {
    const double rounded = std::round(step * scale) / scale;
    if (rounded > 0.0 && std::abs(rounded - step) * static_cast<double>(samples) < 0.1 * step) return rounded;
  }
  return step;
}

struct Series {
  std::vector<double> values;
  double interval = 0.0;
};

Series one_per_row(const FileText& text, const Table& table, const ReadOptions& options,
                   std::vector<InputProblem>& problems) {
  Series series;
  for (const auto& row : table.rows) series.values.push_back(row[0]);
  if (options.interval) return series.interval = *options.interval, series;
  problems.push_back({text.name, table.lines.front(),
                      "the time step of a file without a time column (option dt, in s)", "none"});
  return series;
}

Series time_and_value(const FileText& text, const Table& table, const ReadOptions& options,
                      std::vector<InputProblem>& problems) {
  Series series;
  for (const auto& row : table.rows) series.values.push_back(row[1]);
  if (table.rows.size() < 2) return series.interval = options.interval.value_or(1.0), series;
  const double step = uniform_interval(text, table, options, problems);
  series.interval = plain_interval(step, table.rows.size());
  // A step given by the caller stands when the rounded times allow it.
  if (options.interval && std::abs(*options.interval - step) < 1e-3 * step)
    series.interval = *options.interval;
  return series;
}

Series row_by_row(const FileText& text, const Table& table, const ReadOptions& options,
                  std::vector<InputProblem>& problems) {
  Series series;
  for (const auto& row : table.rows) series.values.insert(series.values.end(), row.begin(), row.end());
  if (options.interval) return series.interval = *options.interval, series;
  problems.push_back(
      {text.name, table.lines.front(),
       "one column, or time and value; or the time step of values that go on row by row (option dt, in s)",
       fmt::format("{} columns", table.columns)});
  return series;
}

Series read_series(const FileText& text, const Table& table, const ReadOptions& options,
                   std::vector<InputProblem>& problems) {
  if (table.regular && table.columns == 1) return one_per_row(text, table, options, problems);
  if (table.regular && table.columns == 2) return time_and_value(text, table, options, problems);
  // Rows of one width, the last one shorter; anything else has lost fields.
  for (std::size_t k = 0; k + 1 < table.rows.size(); ++k) {
    if (table.rows[k].size() == table.columns) continue;
    problems.push_back({text.name, table.lines[k],
                        fmt::format("{} numbers, as on the rows above", table.columns),
                        fmt::format("{}", table.rows[k].size())});
    break;
  }
  if (table.columns <= 2) {
    problems.push_back({text.name, table.lines.back(),
                        fmt::format("{} numbers, as on the rows above", table.columns),
                        fmt::format("{}", table.rows.back().size())});
    return {};
  }
  return row_by_row(text, table, options, problems);
}

std::string last_header_line(const FileText& text, std::size_t first) {
  for (std::size_t i = first; i-- > 0;) {
    const auto line = trimmed(text.lines[i]);
    if (!line.empty()) return printable(line);
  }
  return {};
}

// m/s2 per unit of the file, or a problem that names the option.
double unit_factor(const FileText& text, std::size_t first, const ReadOptions& options,
                   std::vector<InputProblem>& problems) {
  const auto wanted = fmt::format("the units of the values: option units = {}", known_units());
  if (!options.units) {
    const std::string title = last_header_line(text, first);
    problems.push_back(
        {text.name, 0, wanted, title.empty() ? "none" : "none (the header says \"" + title + "\")"});
    return 1.0;
  }
  if (is_counts(*options.units)) {
    if (options.count_scale) return *options.count_scale;
    problems.push_back(
        {text.name, 0, "the scale of the counts, such as 3920(gal)/6182761 (option scale)", "none"});
    return 1.0;
  }
  const auto factor = acceleration_unit(*options.units, options.gravity);
  if (!factor) problems.push_back({text.name, 0, wanted, in_quotes(*options.units)});
  return factor.value_or(1.0);
}

void describe_source(const FileText& text, std::size_t first, const ReadOptions& options, Record& record) {
  Provenance& from = record.provenance;
  for (std::size_t i = 0; i < first; ++i) {
    const std::string line = printable(trimmed(text.lines[i]));
    if (!line.empty()) from.header.emplace_back(fmt::format("header line {}", i + 1), line);
    from.synthetic = from.synthetic || upper_case(line).find("SYNTHETIC") != std::string::npos;
  }
  const std::filesystem::path path(text.name);
  from.event = from.header.empty() ? path.stem().string() : from.header.front().second;
  from.units = *options.units + " (given by the user)";
  // A component in the name, as in "MYG004.NS.csv", is all there is to go by.
  std::string word = path.stem().extension().string();
  record.component = options.component.value_or(word.empty() ? "H" : word.substr(1));
  from.component = record.component;
  record.axis = axis_of(record.component);
}

}  // namespace

bool is_columns(const FileText& text) {
  return first_row(text).has_value();
}

Record read_columns(const FileText& text, const ReadOptions& options) {
  const auto first = first_row(text);
  if (!first) throw InputError(text.name, 0, "rows of numbers", "none");
  std::vector<InputProblem> problems;
  const Table table = read_table(text, *first, problems);
  const double factor = unit_factor(text, *first, options, problems);
  const bool broken = !problems.empty();
  Series series = broken ? Series{} : read_series(text, table, options, problems);
  if (problems.empty()) {
    check_series(text, series.values.size(), series.interval, table.lines.front(), options, problems);
  } else if (!options.units && table.columns == 1 && !options.interval) {
    problems.push_back(
        {text.name, *first + 1, "the time step of a file without a time column (option dt, in s)", "none"});
  }
  throw_if_any(std::move(problems));
  Record record = make_record(text, "plain columns", std::move(series.values), factor, series.interval);
  describe_source(text, *first, options, record);
  remove_recorded_offset(record, is_counts(*options.units), options);
  return record;
}

}  // namespace dougong::seismic
