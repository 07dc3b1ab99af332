#include "seismic/formats/rec_shape.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "seismic/formats/samples.h"
#include "seismic/measures/peaks.h"
#include "seismic/numerics/parse_number.h"

namespace dougong::seismic {
namespace {

constexpr std::size_t header_lines = 2;
constexpr std::string_view magnitude_in_gbk = "\xD5\xF0\xBC\xB6";           // the first title
constexpr std::string_view magnitude_in_utf8 = "\xE9\x9C\x87\xE7\xBA\xA7";  // of a file that was converted
constexpr double time_digits = 0.006;  // relative: times of three digits are off by up to 0.5 %

std::vector<std::string> tab_fields(std::string_view line) {
  std::vector<std::string> fields;
  while (true) {
    const auto tab = line.find('\t');
    fields.push_back(printable(trimmed(line.substr(0, tab))));
    if (tab == std::string_view::npos) return fields;
    line.remove_prefix(tab + 1);
  }
}

struct Columns {
  std::vector<double> times, values;
  std::vector<std::size_t> lines;  // from 1
};

Columns read_columns_of(const FileText& text, std::vector<InputProblem>& problems) {
  constexpr std::size_t most_problems = 100;
  Columns out;
  std::vector<double> row;
  for (std::size_t i = header_lines; i < text.lines.size() && problems.size() < most_problems; ++i) {
    row.clear();
    const bool finite = append_numbers(text.lines[i], row).empty();
    if (finite && row.empty()) continue;
    if (!finite || row.size() != 2) {
      problems.push_back({text.name, i + 1, "a time and a value, both finite numbers",
                          in_quotes(text.lines[i].substr(0, 60))});
      continue;
    }
    out.times.push_back(row[0]);
    out.values.push_back(row[1]);
    out.lines.push_back(i + 1);
  }
  return out;
}

void check_times(const FileText& text, const Columns& columns, double interval,
                 std::vector<InputProblem>& problems) {
  for (std::size_t k = 2; k < columns.times.size(); ++k) {
    const double expected = columns.times[0] + interval * static_cast<double>(k);
    if (std::abs(columns.times[k] - expected) <= time_digits * std::abs(expected) + 0.5 * interval) continue;
    problems.push_back(
        {text.name, columns.lines[k],
         fmt::format("time {:.6g} s (equal steps of {:.6g} s, from the first two lines)", expected, interval),
         fmt::format("{:.6g} s", columns.times[k])});
    return;  // the rest follows from the first
  }
}

void describe_source(const FileText& text, Record& record) {
  constexpr std::array titles = {"magnitude", "year", "name", "station", "component"};
  const auto fields = tab_fields(text.lines[1]);
  Provenance& from = record.provenance;
  for (std::size_t i = 0; i < std::min(fields.size(), titles.size()); ++i) {
    if (!fields[i].empty()) from.header.emplace_back(titles[i], fields[i]);
  }
  const auto field = [&fields](std::size_t i) { return i < fields.size() ? fields[i] : std::string{}; };
  from.event = fmt::format("{} {} M {}", field(2), field(1), field(0));
  from.station = field(3);
  from.scale = "none: a target PGA must be chosen";
  from.treatment = "divided by its peak";
  name_component(record, field(4).empty() ? "H" : field(4));
  record.dimensionless = true;
}

void add_warnings(Record& record) {
  auto& warnings = record.warnings;
  const std::string event = upper_case(record.provenance.event);
  warnings.push_back("dimensionless shape: its PGA is unknown, a target PGA must be chosen (option pga)");
  if (event.find("TOHOKU") != std::string::npos) {
    warnings.push_back(
        fmt::format("the time step of this file is disputed: its column says {:g} s, which is used; the "
                    "program it comes from read it at 0.05 s",
                    record.interval));
  }
  if (event.find("WENCHUAN 2010") != std::string::npos) {
    warnings.push_back("the file dates the Wenchuan earthquake 2010; it was on 12 May 2008");
  }
  const double top = peak(record.acceleration, record.interval).value;
  if (std::abs(top - 1.0) > 0.01)
    warnings.push_back(fmt::format("the shape peaks at {:.4g} instead of 1", top));
}

}  // namespace

bool is_rec_shape(const FileText& text) {
  if (text.lines.size() <= header_lines) return false;
  const bool titled =
      text.lines[0].starts_with(magnitude_in_gbk) || text.lines[0].starts_with(magnitude_in_utf8);
  return titled && parse_numbers(text.lines[header_lines]).values.size() == 2;
}

Record read_rec_shape(const FileText& text, const ReadOptions& options) {
  std::vector<InputProblem> problems;
  if (text.lines.size() < header_lines) throw InputError(text.name, 0, "two header lines", "fewer");
  Columns columns = read_columns_of(text, problems);
  if (options.units) {
    problems.push_back({text.name, 0,
                        "no units: the values are normalised (leave out the option units, give pga)",
                        *options.units});
  }
  const double step = columns.times.size() > 1 ? columns.times[1] - columns.times[0] : 0.0;
  const double interval = options.interval.value_or(step);
  if (columns.times.size() > 1) check_times(text, columns, step, problems);
  check_series(text, columns.values.size(), columns.values.size() < 2 ? 1.0 : interval, header_lines + 1,
               options, problems);
  throw_if_any(std::move(problems));
  Record record = make_record(text, "normalised .rec shape", std::move(columns.values), 1.0, interval,
                              "none (normalised to a peak of 1)");
  if (options.interval && std::abs(step - interval) > 1e-6 * interval) {
    record.warnings.push_back(
        fmt::format("the file's column says {:g} s a step; {:g} s was asked for", step, interval));
  }
  describe_source(text, record);
  add_warnings(record);
  remove_recorded_offset(record, false, options);
  return record;
}

}  // namespace dougong::seismic
