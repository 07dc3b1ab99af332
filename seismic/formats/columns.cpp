#include "seismic/formats/columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include "seismic/formats/even_steps.h"
#include "seismic/formats/header_text.h"
#include "seismic/formats/samples.h"
#include "seismic/numerics/parse_number.h"
#include "seismic/units.h"

namespace dougong::seismic {
namespace {

constexpr std::size_t longest_header = 100;  // lines of text above the numbers
constexpr std::size_t longest_title = 200;   // characters of a line that are looked at for numbers
constexpr std::size_t most_problems = 100;

struct Table {
  std::vector<double> values;       // row after row
  std::vector<std::size_t> starts;  // of each row in values, and the end
  std::vector<std::size_t> lines;   // from 1, of each row
  std::size_t columns = 0;          // of the first row
  bool regular = true;              // every row has as many

  std::size_t rows() const { return lines.size(); }
  std::size_t fields(std::size_t row) const { return starts[row + 1] - starts[row]; }
  double at(std::size_t row, std::size_t column) const { return values[starts[row] + column]; }
  std::vector<double> column(std::size_t which) const {
    std::vector<double> out(rows());
    for (std::size_t k = 0; k < rows(); ++k) out[k] = at(k, which);
    return out;
  }
};

// Numbers on a line; none when it holds anything else.
std::size_t fields_of(std::string_view line) {
  const NumberLine numbers = parse_numbers(line.substr(0, longest_title));
  return numbers.numeric ? numbers.values.size() : 0;
}

// The numbers begin where two rows follow one another with as many fields: a lone number in a header (a
// count of points, a year) is not yet data.
std::optional<std::size_t> first_row(const FileText& text) {
  const std::size_t end = std::min(text.lines.size(), longest_header);
  for (std::size_t i = 0; i < end; ++i) {
    const std::size_t fields = fields_of(text.lines[i]);
    if (fields == 0) continue;
    std::size_t next = i + 1;
    while (next < text.lines.size() && trimmed(text.lines[next]).empty()) ++next;
    if (next >= text.lines.size()) return i;
    const std::size_t following = fields_of(text.lines[next]);
    if (following > 0 && (fields == following || fields > 2)) return i;
  }
  return std::nullopt;
}

Table read_table(const FileText& text, std::size_t first, std::vector<InputProblem>& problems) {
  Table table;
  table.values.reserve(text.bytes.size() / 8);
  for (std::size_t i = first; i < text.lines.size() && problems.size() < most_problems; ++i) {
    const std::size_t start = table.values.size();
    const std::string_view culprit = append_numbers(text.lines[i], table.values);
    if (!culprit.empty())
      problems.push_back({text.name, i + 1, "finite numbers", in_quotes(culprit.substr(0, longest_title))});
    else if (table.values.size() == start)
      continue;
    table.starts.push_back(start);
    table.lines.push_back(i + 1);
  }
  table.starts.push_back(table.values.size());
  table.columns = table.rows() ? table.fields(0) : 0;
  for (std::size_t k = 0; k < table.rows(); ++k)
    table.regular = table.regular && table.fields(k) == table.columns;
  return table;
}

// Half a unit in the last decimal of the time column, the coarsest in the file: "0.0100" -> 0.00005. A lone
// "0" says nothing of the others.
double time_rounding(const FileText& text, const Table& table) {
  double decimals = 15.0;
  for (const std::size_t line :
       {table.lines.front(), table.lines[table.lines.size() / 2], table.lines.back()}) {
    const std::string_view field = trimmed(text.lines[line - 1]);
    const std::string_view time = field.substr(0, field.find_first_of(" \t,;"));
    const auto point = time.find('.');
    if (time == "0" || time.find_first_of("eEdD") != std::string_view::npos) continue;
    const std::size_t digits = point == std::string_view::npos ? 0 : time.size() - point - 1;
    decimals = std::min(decimals, static_cast<double>(digits));
  }
  return 0.51 * std::pow(10.0, -decimals);
}

// True when every time is within `slack` of an equal division.
bool equally_spaced(const std::vector<double>& times, double step, double slack) {
  if (!(step > 0.0)) return false;
  for (std::size_t k = 1; k < times.size(); ++k)
    if (std::abs(times[k] - times[0] - step * static_cast<double>(k)) > slack) return false;
  return true;
}

// Row whose step departs most from the mean one: where a sample is missing, repeated or shifted.
std::size_t oddest_row(const std::vector<double>& times, double mean_step) {
  std::size_t odd = 1;
  const auto departure = [&](std::size_t k) { return std::abs(times[k] - times[k - 1] - mean_step); };
  for (std::size_t k = 1; k < times.size(); ++k) {
    if (departure(k) > departure(odd) * (1.0 + 1e-6)) odd = k;
  }
  return odd;
}

// Steps that are all alike but for one in fifty at most: samples were lost.
bool has_gaps(const std::vector<double>& times) {
  std::vector<double> steps;
  for (std::size_t k = 1; k < times.size(); ++k) steps.push_back(times[k] - times[k - 1]);
  auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  const double usual = *middle;
  const auto odd = static_cast<std::size_t>(std::count_if(
      steps.begin(), steps.end(), [&](double step) { return std::abs(step - usual) > 0.1 * usual; }));
  return odd <= std::max<std::size_t>(1, steps.size() / 50);
}

// A step of 0.00999999 read from rounded times is 0.01 when that explains every one of them.
double plain_step(double step, std::size_t samples) {
  return plain_interval(step, 0.1 / static_cast<double>(samples));
}

using Series = EvenSeries;

struct Times {
  std::vector<double> values;
  double mean_step = 0.0, slack = 0.0;
  bool uniform = false;
};

// A time column rounded so coarsely that it says little (half a step and more) is taken only with a step from
// the caller.
Times times_of(const FileText& text, const Table& table, const ReadOptions& options) {
  Times times{table.column(0)};
  const double span = times.values.back() - times.values.front();
  times.mean_step = span / static_cast<double>(table.rows() - 1);
  const double rounding = time_rounding(text, table);
  times.slack = std::max(0.01 * std::abs(times.mean_step),
                         options.interval ? rounding : std::min(rounding, 0.5 * times.mean_step));
  times.uniform = equally_spaced(times.values, times.mean_step, times.slack);
  return times;
}

Series uneven_series(const FileText& text, const Table& table, const Times& times, std::vector<double> values,
                     const ReadOptions& options, std::vector<InputProblem>& problems) {
  const std::size_t odd = oddest_row(times.values, times.mean_step);
  const bool back = first_time_back(times.values).has_value();
  auto series = back || (!options.interval && times.values.size() > 3 && has_gaps(times.values) &&
                         !equally_spaced({times.values.begin() + 1, times.values.end()},
                                         times.values[2] - times.values[1], 0.25 * times.mean_step))
                    ? std::nullopt
                    : to_even_steps(times.values, std::move(values), options.interval);
  if (series) return *series;
  problems.push_back({text.name, table.lines[odd],
                      back
                          ? "times that increase"
                          : fmt::format("equal time steps ({:.6g} s on average; option dt resamples to equal "
                                        "ones)",
                                        times.mean_step),
                      fmt::format("a step of {:.6g} s to {:.6g} s", times.values[odd] - times.values[odd - 1],
                                  times.values[odd])});
  return {};
}

Series timed_series(const FileText& text, const Table& table, const Times& times, std::size_t column,
                    const ReadOptions& options, std::vector<InputProblem>& problems) {
  if (!times.uniform) return uneven_series(text, table, times, table.column(column), options, problems);
  Series series;
  series.values = table.column(column);
  series.interval = plain_step(times.mean_step, table.rows());
  // A step given by the caller stands when the rounded times allow it.
  if (options.interval && std::abs(*options.interval - times.mean_step) < 1e-3 * times.mean_step)
    series.interval = *options.interval;
  return series;
}

std::vector<Series> time_and_values(const FileText& text, const Table& table, const ReadOptions& options,
                                    std::vector<InputProblem>& problems) {
  std::vector<Series> all;
  if (table.rows() < 2) return {Series{table.column(1), options.interval.value_or(1.0), {}, {}}};
  const Times times = times_of(text, table, options);
  for (std::size_t column = 1; column < table.columns && problems.empty(); ++column)
    all.push_back(timed_series(text, table, times, column, options, problems));
  return all;
}

// One after another, whatever the rows: the step is the caller's.
std::vector<Series> in_sequence(const FileText& text, const Table& table, const std::string& expected,
                                const std::string& found, const ReadOptions& options,
                                std::vector<InputProblem>& problems) {
  if (!options.interval) problems.push_back({text.name, table.lines.front(), expected, found});
  return {Series{table.values, options.interval.value_or(1.0), {}, {}}};
}

// A seismogram's samples never grow by equal steps: a column that does is the time.
bool begins_with_time(const FileText& text, const Table& table, const ReadOptions& options) {
  if (!table.regular || table.columns < 2 || table.rows() < 4) return false;
  return times_of(text, table, options).uniform;
}

void check_rows(const FileText& text, const Table& table, std::vector<InputProblem>& problems) {
  // Rows of one width, the last one shorter; anything else has lost fields.
  const std::size_t last = table.columns <= 2 ? table.rows() : table.rows() - 1;
  for (std::size_t k = 0; k < last; ++k) {
    if (table.fields(k) == table.columns) continue;
    problems.push_back({text.name, table.lines[k],
                        fmt::format("{} numbers, as on the rows above", table.columns),
                        fmt::format("{}", table.fields(k))});
    return;
  }
}

std::vector<Series> read_series(const FileText& text, const Table& table, const ReadOptions& options,
                                std::vector<InputProblem>& problems) {
  check_rows(text, table, problems);
  if (!problems.empty()) return {};
  if (table.columns == 1)
    return in_sequence(text, table, "the time step of a file without a time column (option dt, in s)", "none",
                       options, problems);
  if (table.columns == 2 || begins_with_time(text, table, options))
    return time_and_values(text, table, options, problems);
  return in_sequence(text, table,
                     "one column, or time and values; or the time step of values that go on row by row "
                     "(option dt, in s)",
                     fmt::format("{} columns", table.columns), options, problems);
}

std::string last_header_line(const FileText& text, std::size_t first) {
  for (std::size_t i = first; i-- > 0;) {
    const auto line = trimmed(line_at(text, i));
    if (!line.empty()) return printable(line);
  }
  return {};
}

// Titles over the columns, when there is one for each.
std::vector<std::string> titles_over(const FileText& text, std::size_t first, std::size_t columns) {
  std::string line = last_header_line(text, first);
  const char* const parts = line.find_first_of(",;") == std::string::npos ? " " : ",;";
  std::vector<std::string> titles;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t end = std::min(line.find_first_of(parts, at), line.size());
    const auto title = trimmed(std::string_view(line).substr(at, end - at));
    if (!title.empty()) titles.emplace_back(title);
    at = end + 1;
  }
  return titles.size() == columns ? titles : std::vector<std::string>{};
}

// A component in the file's name, as in "MYG004.NS.csv", is all there is to go by for a single one.
std::string component_of(const FileText& text, const Table& table, std::size_t first, std::size_t which,
                         const ReadOptions& options) {
  if (table.columns <= 2 || which == 0) {
    const std::string word = std::filesystem::path(text.name).stem().extension().string();
    return options.component.value_or(word.empty() ? "H" : word.substr(1));
  }
  const auto titles = titles_over(text, first, table.columns);
  return titles.empty() ? fmt::format("column {}", which + 1) : titles[which];
}

void describe_source(const FileText& text, std::size_t first, Record& record) {
  Provenance& from = record.provenance;
  keep_header(text, 0, first, from);
  const std::filesystem::path path(text.name);
  from.event = from.header.empty() ? path.stem().string() : from.header.front().second;
}

Record make_column_record(const FileText& text, std::size_t first, Series series, double factor,
                          std::string component, const ReadOptions& options) {
  Record record = make_record(text, "plain columns", std::move(series.values), factor, series.interval,
                              *options.units + " (given by the user)");
  record.processing = std::move(series.steps);
  record.warnings = std::move(series.warnings);
  describe_source(text, first, record);
  name_component(record, std::move(component));
  remove_recorded_offset(record, is_counts(*options.units), options);
  return record;
}

}  // namespace

bool is_columns(const FileText& text) {
  return first_row(text).has_value();
}

std::vector<Record> read_columns(const FileText& text, const ReadOptions& options) {
  const auto first = first_row(text);
  if (!first) throw InputError(text.name, 0, "rows of numbers", "none");
  std::vector<InputProblem> problems;
  const Table table = read_table(text, *first, problems);
  const std::string title = last_header_line(text, *first);
  const std::string hint = title.empty() ? title : "the header says \"" + title + "\"";
  const double factor = declared_factor(text, hint, options, problems);
  std::vector<Series> all =
      problems.empty() ? read_series(text, table, options, problems) : std::vector<Series>{};
  if (problems.empty())
    for (const Series& series : all)
      check_series(text, series.values.size(), series.interval, table.lines.front(), options, problems);
  else if (!options.units && table.columns == 1 && !options.interval)
    problems.push_back(
        {text.name, *first + 1, "the time step of a file without a time column (option dt, in s)", "none"});
  throw_if_any(std::move(problems));
  const bool timed = all.size() > 1 || begins_with_time(text, table, options);
  std::vector<Record> records;
  for (std::size_t i = 0; i < all.size(); ++i)
    records.push_back(make_column_record(text, *first, std::move(all[i]), factor,
                                         component_of(text, table, *first, timed ? i + 1 : 0, options),
                                         options));
  return records;
}

}  // namespace dougong::seismic
