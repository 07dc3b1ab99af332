#include "seismic/formats/geonet.h"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>

#include "seismic/formats/fixed_fields.h"
#include "seismic/formats/header_text.h"
#include "seismic/formats/samples.h"
#include "seismic/time_text.h"

namespace dougong::seismic {
namespace {

constexpr std::size_t text_lines = 16, integers = 40, reals = 60;
constexpr FieldFormat eight_wide{10, 8};

// Places in the headers, from 0.
constexpr std::size_t year = 8, month = 9, day = 18, hour = 19, minute = 38, millisecond = 39;
constexpr std::size_t points_v1 = 30, points_v2 = 33, points_of_velocity = 34, points_of_displacement = 35;
constexpr std::size_t latitude = 10, longitude = 11, event_latitude = 12, event_longitude = 13;
constexpr std::size_t interval = 25;

struct Component {
  std::size_t start = 0;  // index of its first line
  bool corrected = false;
  std::vector<double> integers, reals, values;
  std::size_t end = 0;  // index behind its last line

  std::size_t stated_on() const { return start + 20; }  // from 1
};

std::size_t lines_for(double values) {
  return (sample_count(values) + eight_wide.per_line - 1) / eight_wide.per_line;
}

Component read_component(const FileText& text, std::size_t start, std::vector<InputProblem>& problems) {
  Component c;
  c.start = start;
  c.corrected = !contains(line_at(text, start), "Uncorrected");
  std::size_t line = start + text_lines;
  c.integers = read_block(text, line, integers, eight_wide, problems);
  if (problems.empty()) c.reals = read_block(text, line, reals, eight_wide, problems);
  if (!problems.empty()) return c;
  const double points = c.integers[c.corrected ? points_v2 : points_v1];
  c.values = read_block(text, line, sample_count(points), eight_wide, problems);
  c.end = line;
  if (c.corrected)
    c.end += lines_for(c.integers[points_of_velocity]) + lines_for(c.integers[points_of_displacement]);
  if (problems.empty() && c.end > text.lines.size())
    problems.push_back({text.name, text.lines.size(), "velocity and displacement behind the acceleration",
                        "the end of the file (it is truncated)"});
  return c;
}

std::string component_name(const FileText& text, const Component& c) {
  const std::string rest = value_behind(text, "Component", c.start, c.start + text_lines);
  return rest.substr(0, rest.find(' '));
}

std::string start_of(const Component& c) {
  const auto at = [&](std::size_t place) { return static_cast<int>(c.integers[place]); };
  return iso_time(at(year), at(month), at(day), at(hour), at(minute), c.integers[millisecond] / 1000.0, "Z");
}

void describe_source(const FileText& text, const Component& c, Record& record) {
  Provenance& from = record.provenance;
  keep_header(text, c.start, c.start + text_lines, from);
  const std::string site = value_behind(text, "Site ", c.start, c.start + text_lines);
  from.station = site.substr(0, site.find(' '));
  from.event = fmt::format("{}, {}", printable(trimmed(line_at(text, c.start + 7))),
                           printable(trimmed(line_at(text, c.start + 8))));
  // Printed without sign: New Zealand lies south.
  from.station_place = Place{-c.reals[latitude], c.reals[longitude], std::nullopt};
  from.hypocentre = Place{-c.reals[event_latitude], c.reals[event_longitude], std::nullopt};
  from.start_time = start_of(c);
  from.processed = c.corrected;
  from.treatment = printable(trimmed(line_at(text, c.start + (c.corrected ? 11 : 0))));
}

// "Acceleration:  peak    -41.6 mm/s/s at  43.68 sec"
void check_peak(const FileText& text, const Component& c, double factor, Record& record) {
  const auto line = find_line(text, "Acceleration:", c.start, c.start + text_lines);
  const auto peak = line ? number_behind(text.lines[*line], "peak") : std::nullopt;
  if (peak) check_stated_peak(record, *peak * factor, 0.1 * factor);
}

Record read_one(const FileText& text, Component&& c, const ReadOptions& options,
                std::vector<InputProblem>&& problems) {
  const double factor = stated_factor(text, "mm/s2", 0, options, problems);
  Record record = make_channel(text,
                               {c.corrected ? "GeoNet V2A" : "GeoNet V1A", component_name(text, c), "mm/s2",
                                std::move(c.values), factor, c.reals[interval], c.stated_on()},
                               options, std::move(problems));
  describe_source(text, c, record);
  check_peak(text, c, factor, record);
  remove_recorded_offset(record, false, options);
  return record;
}

}  // namespace

bool is_geonet(const FileText& text) {
  const std::string_view first = line_at(text, 0);
  return contains(first, "corrected accelerogram") && contains(first, "GNS Science");
}

std::vector<Record> read_geonet(const FileText& text, const ReadOptions& options) {
  std::vector<Record> records;
  for (std::size_t line = 0; line < text.lines.size();) {
    if (trimmed(text.lines[line]).empty()) {
      ++line;
      continue;
    }
    std::vector<InputProblem> problems;
    Component component = read_component(text, line, problems);
    throw_if_any(std::exchange(problems, {}));
    line = component.end;
    records.push_back(read_one(text, std::move(component), options, std::move(problems)));
  }
  return records;
}

}  // namespace dougong::seismic
