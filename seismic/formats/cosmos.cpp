#include "seismic/formats/cosmos.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "seismic/formats/fixed_fields.h"
#include "seismic/formats/header_text.h"
#include "seismic/formats/samples.h"
#include "seismic/numerics/parse_number.h"
#include "seismic/time_text.h"

namespace dougong::seismic {
namespace {

// Places in the headers, from 0 (the format counts from 1).
constexpr std::size_t physical_quantity = 1;  // integer: 1 is acceleration
constexpr std::size_t azimuth = 53;           // integer: degrees, or a code beyond 360
constexpr std::size_t latitude = 0, longitude = 1, elevation = 2;
constexpr std::size_t event_latitude = 9, event_longitude = 10, event_depth = 11;
constexpr std::size_t raw_interval = 33;        // s
constexpr std::size_t interval_of_series = 61;  // ms
constexpr std::size_t stated_peak = 63;
constexpr double unknown = -999.0;
constexpr int code_of_counts = 50;

struct Channel {
  std::size_t start = 0;  // index of its first text line
  std::vector<double> integers, reals;
  std::size_t title = 0;  // index of the line over the data
  std::string quantity;   // on that line
  FieldFormat format;
  std::size_t points = 0;
  int unit = 0;
};

std::optional<double> known(const std::vector<double>& header, std::size_t place) {
  if (place >= header.size() || std::abs(header[place] - unknown) < 0.5) return std::nullopt;
  return header[place];
}

// One of the two blocks of numbers: its line states count and format.
std::vector<double> header_block(const FileText& text, std::size_t& line, std::string_view words,
                                 std::vector<InputProblem>& problems) {
  const std::string_view stated = line_at(text, line);
  const auto count = leading_number(stated);
  const auto format = field_format_in(behind(stated, "Format"));
  if (!contains(stated, words) || !count || !format) {
    problems.push_back({text.name, line + 1,
                        fmt::format("\"N {} values follow on ..., Format = ...\"", words),
                        in_quotes(trimmed(stated.substr(0, 60)))});
    return {};
  }
  ++line;
  return read_block(text, line, sample_count(*count), *format, problems);
}

// "units=cm/sec2(04)" -> 4.
std::optional<int> unit_code(std::string_view title) {
  const std::string_view units = behind(title, "units");
  const auto code = number_behind(units, "(");
  return code ? std::optional(static_cast<int>(*code)) : std::nullopt;
}

void read_title(const FileText& text, std::size_t line, Channel& channel,
                std::vector<InputProblem>& problems) {
  const std::string_view title = line_at(text, line);
  const auto points = leading_number(title);
  const auto format = field_format_in(behind(title, "Format"));
  const auto unit = unit_code(title);
  channel.title = line;
  if (!points || !format || !unit) {
    problems.push_back({text.name, line + 1, "\"N acceleration pts, ..., units=...(code),Format=(...)\"",
                        in_quotes(trimmed(title.substr(0, 60)))});
    return;
  }
  channel.points = sample_count(*points);
  channel.format = *format;
  channel.unit = *unit;
  channel.quantity = printable(before(title, "pts"));
}

std::size_t text_lines_of(std::string_view first) {
  const auto count = number_behind(first, " with");
  return sample_count(count.value_or(13.0));
}

Channel read_header(const FileText& text, std::size_t start, std::vector<InputProblem>& problems) {
  Channel channel;
  channel.start = start;
  std::size_t line = start + text_lines_of(line_at(text, start));
  channel.integers = header_block(text, line, "Integer-header", problems);
  if (!problems.empty()) return channel;
  channel.reals = header_block(text, line, "Real-header", problems);
  if (!problems.empty()) return channel;
  if (contains(line_at(text, line), "comment")) ++line;
  while (trimmed(line_at(text, line)).starts_with("|")) ++line;
  read_title(text, line, channel, problems);
  return channel;
}

void check_quantity(const FileText& text, const Channel& channel) {
  const bool raw = channel.unit == code_of_counts;
  const auto quantity = known(channel.integers, physical_quantity);
  const bool other = contains(channel.quantity, "veloc") || contains(channel.quantity, "displ") ||
                     contains(channel.quantity, "spect");
  if (!other && (raw || !quantity || *quantity == 1.0)) return;
  throw NotAcceleration(text.name, channel.title + 1, "an acceleration",
                        in_quotes(trimmed(line_at(text, channel.title))));
}

// COSMOS table 2. Counts need a sensitivity of the caller's: the header's sensor and recorder constants are
// nominal and often unknown.
double factor_of(const FileText& text, const Channel& channel, const ReadOptions& options,
                 std::vector<InputProblem>& problems) {
  switch (channel.unit) {
    case 2:
      return stated_factor(text, "g", channel.title + 1, options, problems);
    case 4:
      return stated_factor(text, "cm/s2", channel.title + 1, options, problems);
    case code_of_counts:
      break;
    default:
      problems.push_back({text.name, channel.title + 1,
                          "units of acceleration: code 02 (g), 04 (cm/s2) or 50 (counts)",
                          fmt::format("code {}", channel.unit)});
      return 1.0;
  }
  check_stated_units(text, "counts", options, problems);
  if (options.count_scale) return *options.count_scale;
  problems.push_back({text.name, channel.title + 1,
                      "the scale of the counts, such as 3920(gal)/6182761 (option scale)", "none"});
  return 1.0;
}

std::string unit_name(int code) {
  return code == 2 ? "g" : code == 4 ? "cm/s2" : "counts";
}

// "|<SCNL>C031.HNE.NC.01": station, channel, network, location.
std::vector<std::string> scnl_in(const FileText& text, const Channel& channel) {
  std::string all = value_behind(text, "<SCNL>", channel.start, channel.title);
  all = all.substr(0, all.find(' '));
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= all.size();) {
    const std::size_t end = std::min(all.find('.', at), all.size());
    parts.push_back(all.substr(at, end - at));
    at = end + 1;
  }
  return parts.size() >= 3 ? parts : std::vector<std::string>{};
}

// The SEED channel, or what the line "Sta Chan  1: 90 Deg" says.
std::string component_in(const FileText& text, const Channel& channel) {
  const auto scnl = scnl_in(text, channel);
  if (!scnl.empty() && !scnl[1].empty()) return scnl[1];
  const auto line = find_line(text, "Sta Chan", channel.start, channel.title);
  const std::string_view name = line ? behind(text.lines[*line], ":") : std::string_view{};
  return printable(before(before(name, "("), "Deg"));
}

std::optional<Place> place_of(const Channel& channel, std::size_t north, std::size_t east, std::size_t height,
                              double unit) {
  const auto lat = known(channel.reals, north), lon = known(channel.reals, east);
  if (!lat || !lon) return std::nullopt;
  Place place{*lat, *lon, known(channel.reals, height)};
  if (place.height) *place.height *= unit;
  return place;
}

void describe_source(const FileText& text, const Channel& channel, Record& record) {
  Provenance& from = record.provenance;
  keep_header(text, channel.start, channel.start + text_lines_of(line_at(text, channel.start)), from);
  const auto scnl = scnl_in(text, channel);
  from.event = printable(trimmed(line_at(text, channel.start + 1)));
  from.station = scnl.empty() ? value_behind(text, "Statn No:", channel.start, channel.title).substr(0, 9)
                              : scnl[2] + "." + scnl[0];
  if (scnl.size() > 3 && scnl[3] != "--") from.sensor = scnl[3];
  from.station_place = place_of(channel, latitude, longitude, elevation, 1.0);
  from.hypocentre = place_of(channel, event_latitude, event_longitude, event_depth, -1000.0);
  from.start_time = iso_time_in(value_behind(text, "Rcrd start time:", channel.start, channel.title),
                                DateOrder::year_month_day, "Z");
  from.treatment = printable(trimmed(line_at(text, channel.start + 11)));
  from.processed = contains(line_at(text, channel.start), "Corrected acceleration") &&
                   !contains(line_at(text, channel.start), "Uncorrected");
  const auto degrees = known(channel.integers, azimuth);
  if (degrees && *degrees >= 0.0 && *degrees <= 360.0 && record.axis == Axis::horizontal)
    record.azimuth = std::fmod(*degrees, 360.0);
}

// Real 62, and 34 where it is not stated; a contradiction is said.
double interval_of(const FileText& text, const Channel& channel, std::vector<InputProblem>& problems,
                   std::vector<std::string>& warnings) {
  const auto milliseconds = known(channel.reals, interval_of_series),
             raw = known(channel.reals, raw_interval);
  if (milliseconds && *milliseconds > 0.0) {
    const double interval = *milliseconds / 1000.0;
    if (raw && std::abs(*raw - interval) > 1e-3 * interval)
      warnings.push_back(fmt::format(
          "the header states {:g} s between raw samples (real 34) and {:g} s in this series (real 62): used",
          *raw, interval));
    return interval;
  }
  if (raw && *raw > 0.0) return *raw;
  problems.push_back({text.name, channel.title + 1, "a time step (real 62 of the header, in ms)", "none"});
  return 0.0;
}

Record read_channel(const FileText& text, const Channel& channel, const ReadOptions& options,
                    std::vector<double> values, std::vector<InputProblem>&& problems) {
  std::vector<std::string> warnings;
  const double factor = factor_of(text, channel, options, problems);
  const double interval = interval_of(text, channel, problems, warnings);
  Record record = make_channel(text,
                               {"COSMOS v1.20", component_in(text, channel), unit_name(channel.unit),
                                std::move(values), factor, interval, channel.title + 1},
                               options, std::move(problems));
  record.warnings = std::move(warnings);
  describe_source(text, channel, record);
  const bool counts = channel.unit == code_of_counts;
  if (const auto peak = known(channel.reals, stated_peak))
    check_stated_peak(record, *peak * factor, 1e-3 * std::abs(*peak) * factor, counts);
  remove_recorded_offset(record, counts, options);
  return record;
}

}  // namespace

bool is_cosmos(const FileText& text) {
  const std::string_view first = line_at(text, 0);
  return contains(first, "(Format v") && contains(first, "text lines)");
}

std::vector<Record> read_cosmos(const FileText& text, const ReadOptions& options) {
  std::vector<Record> records;
  for (std::size_t line = 0; line < text.lines.size();) {
    if (trimmed(text.lines[line]).empty()) {
      ++line;
      continue;
    }
    std::vector<InputProblem> problems;
    const Channel channel = read_header(text, line, problems);
    throw_if_any(std::exchange(problems, {}));
    check_quantity(text, channel);
    line = channel.title + 1;
    auto values = read_block(text, line, channel.points, channel.format, problems);
    if (contains(line_at(text, line), "End-of-data")) ++line;
    records.push_back(read_channel(text, channel, options, std::move(values), std::move(problems)));
  }
  return records;
}

}  // namespace dougong::seismic
