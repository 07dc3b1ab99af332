#include "seismic/formats/smc.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "seismic/formats/even_steps.h"
#include "seismic/formats/fixed_fields.h"
#include "seismic/formats/header_text.h"
#include "seismic/formats/samples.h"
#include "seismic/formats/table_rows.h"
#include "seismic/time_text.h"

namespace dougong::seismic {
namespace {

constexpr std::size_t text_lines = 11;
constexpr FieldFormat integer_format{8, 10}, real_format{5, 15};
constexpr std::size_t integers = 48, reals = 50;

// Places in the headers, from 0.
constexpr std::size_t year = 1, day_of_year = 2, hour = 3, minute = 4, second = 5, millisecond = 6;
constexpr std::size_t vertical = 12, horizontal = 13;  // orientation: degrees from up, from north
constexpr std::size_t comments = 15, values_stated = 16;
constexpr std::size_t rate = 1, event_latitude = 2, event_longitude = 3, depth = 4;
constexpr std::size_t latitude = 10, longitude = 11, elevation = 12;

struct Header {
  std::vector<double> integers, reals;
  std::size_t first = 0;  // index of the first data line

  std::optional<double> integer(std::size_t place) const {
    return integers[place] == integers[0] ? std::nullopt : std::optional(integers[place]);
  }
  std::optional<double> real(std::size_t place) const {
    return reals[place] >= 0.99 * reals[0] ? std::nullopt : std::optional(reals[place]);
  }
};

Header read_header(const FileText& text, std::vector<InputProblem>& problems) {
  Header header;
  std::size_t line = text_lines;
  header.integers = read_block(text, line, integers, integer_format, problems);
  if (problems.empty()) header.reals = read_block(text, line, reals, real_format, problems);
  if (!problems.empty()) return header;
  const std::size_t stated = sample_count(header.integer(comments).value_or(0.0));
  for (std::size_t i = 0; i < stated && line_at(text, line).starts_with("|"); ++i) ++line;
  header.first = line;
  return header;
}

std::optional<Place> place_of(const Header& header, std::size_t north, std::size_t east, std::size_t height,
                              double unit) {
  const auto lat = header.real(north), lon = header.real(east);
  if (!lat || !lon) return std::nullopt;
  Place place{*lat, *lon, header.real(height)};
  if (place.height) *place.height *= unit;
  return place;
}

// The text line says "component= 360"; the integers say whether it is vertical.
std::string component_in(const FileText& text, const Header& header) {
  const std::string stated = value_behind(text, "component=", 0, text_lines);
  if (!stated.empty()) return stated;
  if (header.integer(vertical) == 0.0) return "UP";
  const auto degrees = header.integer(horizontal);
  return degrees ? fmt::format("{:g}", *degrees) : "?";
}

std::string start_of(const Header& header) {
  const auto y = header.integer(year), d = header.integer(day_of_year), h = header.integer(hour),
             m = header.integer(minute);
  if (!y || !d || !h || !m) return {};
  const double seconds =
      header.integer(second).value_or(0.0) + header.integer(millisecond).value_or(0.0) / 1e3;
  return iso_time_of_day(static_cast<int>(*y), static_cast<int>(*d), static_cast<int>(*h),
                         static_cast<int>(*m), seconds, "Z");
}

void describe_source(const FileText& text, const Header& header, Record& record) {
  Provenance& from = record.provenance;
  keep_header(text, 0, header.first, from);
  from.event = printable(trimmed(line_at(text, 3)));
  from.station = printable(before(value_behind(text, "station =", 0, text_lines), "component"));
  from.station_place = place_of(header, latitude, longitude, elevation, 1.0);
  from.hypocentre = place_of(header, event_latitude, event_longitude, depth, -1000.0);
  from.start_time = start_of(header);
  from.processed = line_at(text, 0).starts_with("2");
  from.treatment = printable(trimmed(line_at(text, 0)));
}

// One that grows from value to value is the time of a pair: no accelerogram does.
bool are_pairs(const std::vector<double>& values) {
  if (values.size() < 8 || values.size() % 2 != 0) return false;
  for (std::size_t i = 2; i < values.size(); i += 2)
    if (!(values[i] > values[i - 2])) return false;
  return true;
}

EvenSeries series_of(const FileText& text, const Header& header, std::vector<double> values,
                     const ReadOptions& options, std::vector<InputProblem>& problems) {
  if (are_pairs(values)) {
    auto columns = columns_of(values, 2);
    auto series = to_even_steps(columns[0], std::move(columns[1]), options.interval);
    if (series) return *std::move(series);
    problems.push_back(
        {text.name, header.first + 1, "a time step for times this uneven (option dt, in s)", "none"});
    return {};
  }
  const auto samples_a_second = header.real(rate);
  if (samples_a_second && *samples_a_second > 0.0)
    return {std::move(values), 1.0 / *samples_a_second, {}, {}};
  problems.push_back({text.name, text_lines + 7, "the samples per second (real 2)", "none"});
  return {};
}

void check_type(const FileText& text) {
  const std::string_view first = line_at(text, 0);
  const bool acceleration =
      first.starts_with("0") || first.starts_with("1") || first.starts_with("2") || first.starts_with("*");
  if (!acceleration)
    throw NotAcceleration(text.name, 1, "type 0, 1 or 2, an acceleration", in_quotes(trimmed(first)));
}

// "pk     =    104.4"
void check_peak(const FileText& text, double factor, Record& record) {
  const auto line = find_line(text, "pk ", 0, text_lines);
  const auto peak = line ? number_behind(text.lines[*line], "pk ") : std::nullopt;
  if (peak) check_stated_peak(record, *peak * factor, 0.05 * factor);
}

}  // namespace

bool is_smc(const FileText& text) {
  const std::string_view first = line_at(text, 0);
  if (text.lines.size() < 28 || first.empty() ||
      std::string_view("0123456789*").find(first[0]) == std::string_view::npos)
    return false;
  std::vector<InputProblem> problems;
  const Header header = read_header(text, problems);
  return problems.empty() && header.integers[0] < 0.0 && header.reals[0] > 1e38;
}

Record read_smc(const FileText& text, const ReadOptions& options) {
  check_type(text);
  std::vector<InputProblem> problems;
  const Header header = read_header(text, problems);
  throw_if_any(std::exchange(problems, {}));
  const double factor = stated_factor(text, "cm/s2", 0, options, problems);
  const auto format = field_format_of_line(line_at(text, header.first));
  if (!format)
    throw InputError(text.name, header.first + 1, "data in fields of one width",
                     in_quotes(line_at(text, header.first).substr(0, 60)));
  const double stated = header.integer(values_stated).value_or(0.0);
  std::size_t line = header.first;
  auto values = read_block(text, line, sample_count(stated), *format, problems);
  EvenSeries series;
  if (problems.empty()) series = series_of(text, header, std::move(values), options, problems);
  const std::size_t stated_on = text_lines + 3;
  Record record = make_channel(text,
                               {"USGS SMC", component_in(text, header), "cm/s2", std::move(series.values),
                                factor, series.interval, stated_on},
                               options, std::move(problems));
  record.processing = std::move(series.steps);
  record.warnings = std::move(series.warnings);
  describe_source(text, header, record);
  check_peak(text, factor, record);
  remove_recorded_offset(record, false, options);
  return record;
}

}  // namespace dougong::seismic
