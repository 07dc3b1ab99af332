#include "seismic/formats/knet_csv.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "seismic/formats/header_text.h"
#include "seismic/formats/knet.h"
#include "seismic/formats/samples.h"
#include "seismic/formats/table_rows.h"
#include "seismic/numerics/parse_number.h"
#include "seismic/time_text.h"

namespace dougong::seismic {
namespace {

constexpr std::size_t longest_header = 40;  // lines; 15 in the known form

std::vector<std::string_view> fields_of(std::string_view line) {
  if (line.starts_with("#")) line.remove_prefix(1);
  std::vector<std::string_view> fields;
  while (true) {
    const auto comma = line.find(',');
    fields.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

// The values stand on the line below their titles.
std::string_view field_below(const FileText& text, std::string_view title, std::size_t which) {
  const auto line = find_line(text, title, 0, longest_header);
  const auto fields = line ? fields_of(line_at(text, *line + 1)) : std::vector<std::string_view>{};
  return which < fields.size() ? fields[which] : std::string_view{};
}

std::optional<std::size_t> titles_line(const FileText& text) {
  return find_line(text, "#Time,RelativeTime", 0, longest_header);
}

// "N-S(gal)" -> "NS", gal.
struct Title {
  std::string component, unit;
};

Title title_of(std::string_view field) {
  const auto open = field.find('('), close = field.find(')');
  const std::string_view unit =
      open == std::string_view::npos || close == std::string_view::npos || close < open
          ? std::string_view{}
          : field.substr(open + 1, close - open - 1);
  return {knet_component(printable(trimmed(field.substr(0, open)))), printable(unit)};
}

std::optional<Place> place_below(const FileText& text, std::string_view titles, std::size_t first) {
  const auto north = parse_number(field_below(text, titles, first));
  const auto east = parse_number(field_below(text, titles, first + 1));
  return north && east ? std::optional(Place{*north, *east, std::nullopt}) : std::nullopt;
}

void describe_source(const FileText& text, std::size_t titles, Record& record) {
  Provenance& from = record.provenance;
  keep_header(text, 0, titles, from);
  from.event = fmt::format("{}, M {}", printable(field_below(text, "#OriginTime", 0)),
                           printable(field_below(text, "#OriginTime", 4)));
  from.station = printable(field_below(text, "#Code,", 0));
  from.station_place = place_below(text, "#Code,", 1);
  from.hypocentre = place_below(text, "#OriginTime", 1);
  if (const auto depth = parse_number(field_below(text, "#OriginTime", 3)); depth && from.hypocentre)
    from.hypocentre->height = -1000.0 * *depth;
  from.sensor = knet_sensor(record.component);
  from.start_time =
      iso_time_in(fields_of(line_at(text, titles + 1)).front(), DateOrder::year_month_day, "+09:00");
  from.treatment = "none: counts times their scale";
}

// The date and its blank stand before the first comma: only what follows are numbers.
std::vector<double> numbers_below(const FileText& text, std::size_t titles, std::size_t columns,
                                  std::vector<InputProblem>& problems) {
  constexpr std::size_t most_problems = 100;
  std::vector<double> values;
  values.reserve(text.bytes.size() / 8);
  for (std::size_t i = titles + 1; i < text.lines.size() && problems.size() < most_problems; ++i) {
    const std::string_view line = text.lines[i];
    if (trimmed(line).empty()) continue;
    const auto comma = line.find(',');
    const std::size_t before = values.size();
    const std::string_view culprit =
        append_numbers(comma == std::string_view::npos ? std::string_view{} : line.substr(comma), values);
    if (culprit.empty() && values.size() - before == columns) continue;
    problems.push_back({text.name, i + 1, fmt::format("a date and {} finite numbers", columns),
                        culprit.empty() ? fmt::format("{} numbers", values.size() - before)
                                        : in_quotes(culprit.substr(0, 60))});
    values.resize(before);
  }
  return values;
}

}  // namespace

bool is_knet_csv(const FileText& text) {
  return line_at(text, 0).starts_with("#K-NET CSV") && titles_line(text);
}

std::vector<Record> read_knet_csv(const FileText& text, const ReadOptions& options) {
  const auto titles = titles_line(text);
  if (!titles) throw InputError(text.name, 0, "a line \"#Time,RelativeTime(s),...\"", "none");
  const auto names = fields_of(text.lines[*titles]);
  std::vector<InputProblem> problems;
  std::vector<std::string> warnings;
  const double rate = leading_number(field_below(text, "#SamplingFrequency", 0)).value_or(0.0);
  const double duration = leading_number(field_below(text, "#DurationTime", 0)).value_or(0.0);
  const std::size_t line = find_line(text, "#DurationTime", 0, *titles).value_or(0) + 2;
  auto columns = columns_of(numbers_below(text, *titles, names.size() - 1, problems), names.size() - 1);
  std::vector<Record> records;
  for (std::size_t i = 2; i < names.size(); ++i) {
    const Title title = title_of(names[i]);
    const double factor = stated_factor(text, title.unit, *titles + 1, options, problems);
    auto& values = columns[i - 1];
    check_count(text, sample_count(std::round(rate * duration)), line, values, problems, warnings);
    records.push_back(make_channel(
        text, {"K-NET/KiK-net CSV", title.component, title.unit, std::move(values), factor, 1.0 / rate, line},
        options, std::move(problems)));
    problems.clear();
    Record& record = records.back();
    record.warnings = std::exchange(warnings, {});
    describe_source(text, *titles, record);
    remove_recorded_offset(record, true, options);
  }
  if (records.empty()) throw InputError(text.name, *titles + 1, "columns of components", "none");
  return records;
}

}  // namespace dougong::seismic
