#include "seismic/formats/cwa.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>
#include <utility>

#include "seismic/formats/fixed_fields.h"
#include "seismic/formats/header_text.h"
#include "seismic/formats/samples.h"
#include "seismic/formats/table_rows.h"
#include "seismic/numerics/parse_number.h"
#include "seismic/time_text.h"

namespace dougong::seismic {
namespace {

constexpr std::size_t longest_header = 60;  // lines; 22 in the known form

// Behind "#Key...:" on the line of that key.
std::string value_of(const FileText& text, std::string_view key) {
  const std::string rest = value_behind(text, key, 0, longest_header);
  const auto colon = rest.find(':');
  return colon == std::string::npos ? std::string{} : std::string(trimmed(rest.substr(colon + 1)));
}

// "Time U(+); N(+); E(+)" -> U, N, E.
std::vector<std::string> components_in(const std::string& sequence) {
  std::vector<std::string> names;
  std::string_view rest = behind(sequence, "Time");
  while (!rest.empty()) {
    const auto end = std::min(rest.find(';'), rest.size());
    const std::string_view name = before(rest.substr(0, end), "(");
    if (!name.empty()) names.emplace_back(name);
    rest = trimmed(rest.substr(std::min(end + 1, rest.size())));
  }
  return names;
}

// Up to the first blank, point or bracket: "gal. DCoffset(corr)".
std::string unit_in(const std::string& text) {
  return text.substr(0, text.find_first_of(". ("));
}

std::optional<Place> place_of(const FileText& text, std::string_view latitude, std::string_view longitude) {
  const auto north = parse_number(value_of(text, latitude)), east = parse_number(value_of(text, longitude));
  return north && east ? std::optional(Place{*north, *east, std::nullopt}) : std::nullopt;
}

void describe_source(const FileText& text, std::size_t first, Record& record) {
  Provenance& from = record.provenance;
  keep_header(text, 0, first, from);
  from.event = fmt::format("{}, ML {}", value_of(text, "#Origin Time"), value_of(text, "#Magnitude"));
  from.station = value_of(text, "#StationCode");
  from.station_place = place_of(text, "#StationLatitude", "#StationLongitude");
  from.hypocentre = place_of(text, "#EpicenterLatitude", "#EpicenterLongitude");
  if (const auto depth = parse_number(value_of(text, "#Depth")); depth && from.hypocentre)
    from.hypocentre->height = -1000.0 * *depth;
  from.start_time = iso_time_in(value_of(text, "#StartTime"), DateOrder::year_month_day, "+08:00");
  from.treatment = printable(value_of(text, "#AmplitudeUnit"));
}

// "1.196~   -1.017": the greatest and the least value.
void check_peak(const FileText& text, const std::string& name, double factor, Record& record) {
  const std::string range = value_of(text, "#AmplitudeMAX. " + name);
  const auto greatest = leading_number(range), least = number_behind(range, "~");
  if (greatest && least)
    check_stated_peak(record, std::max(std::abs(*greatest), std::abs(*least)) * factor, 1e-3 * factor);
}

void check_times(const FileText& text, const std::vector<double>& times, double interval, std::size_t first,
                 std::vector<InputProblem>& problems) {
  for (std::size_t k = 1; k < times.size(); ++k) {
    const double expected = times[0] + interval * static_cast<double>(k);
    if (std::abs(times[k] - expected) <= 0.5 * interval) continue;
    problems.push_back({text.name, first + k + 1, fmt::format("time {:.6g} s, by the sample rate", expected),
                        fmt::format("{:.6g} s", times[k])});
    return;
  }
}

}  // namespace

bool is_cwa(const FileText& text) {
  return find_line(text, "#StationCode", 0, longest_header) &&
         find_line(text, "#DataSequence", 0, longest_header);
}

std::vector<Record> read_cwa(const FileText& text, const ReadOptions& options) {
  const std::vector<std::string> names = components_in(value_of(text, "#DataSequence"));
  const auto format_line = find_line(text, "#Data:", 0, longest_header);
  const auto format = format_line ? field_format_in(text.lines[*format_line]) : std::nullopt;
  if (names.empty() || !format || format->per_line != names.size() + 1)
    throw InputError(
        text.name, format_line.value_or(0) + 1,
        "\"#DataSequence: Time ...\" with components and \"#Data: 4F10.3\" with a field for each",
        format_line ? in_quotes(text.lines[*format_line]) : "none");
  std::vector<InputProblem> problems;
  const double rate = leading_number(value_of(text, "#SampleRate")).value_or(0.0);
  const double length = leading_number(value_of(text, "#RecordLength")).value_or(0.0);
  const std::string units = unit_in(value_of(text, "#AmplitudeUnit"));
  const double factor = stated_factor(text, units, 0, options, problems);
  auto columns = columns_of(read_rows(text, *format_line + 1, *format, problems), names.size() + 1);
  if (problems.empty() && rate > 0.0) check_times(text, columns[0], 1.0 / rate, *format_line + 1, problems);
  const std::size_t stated_on = find_line(text, "#RecordLength", 0, longest_header).value_or(0) + 1;
  std::vector<std::string> warnings;
  std::vector<Record> records;
  for (std::size_t i = 0; i < names.size(); ++i) {
    auto& values = columns[i + 1];
    check_count(text, sample_count(std::round(rate * length)), stated_on, values, problems, warnings);
    ChannelSamples samples{"CWA Taiwan", names[i], units, std::move(values), factor, 1.0 / rate, stated_on};
    records.push_back(make_channel(text, std::move(samples), options, std::move(problems)));
    problems.clear();
    Record& record = records.back();
    record.warnings = std::exchange(warnings, {});
    describe_source(text, *format_line, record);
    check_peak(text, names[i], factor, record);
    remove_recorded_offset(record, false, options);
  }
  return records;
}

}  // namespace dougong::seismic
