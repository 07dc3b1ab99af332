#include "seismic/formats/csmnc.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <regex>
#include <utility>

#include "seismic/formats/header_text.h"
#include "seismic/formats/samples.h"
#include "seismic/measures/peaks.h"
#include "seismic/numerics/parse_number.h"

namespace dougong::seismic {
namespace {

constexpr std::size_t longest_header = 30;  // lines; 16 in the known form
constexpr double gal = 0.01;                // m/s2

struct Header {
  std::size_t points = 0;
  double interval = 0.0;
  std::size_t line = 0;   // index of the line that states them
  std::size_t first = 0;  // index of the first data line
};

std::optional<Header> find_header(const FileText& text) {
  static const std::regex pattern(R"(NO\. OF POINTS:\s*(\d+)\s+EQUALLY SPACED INTERVALS OF:\s*([0-9.E+-]+))");
  const std::size_t end = std::min(text.lines.size(), longest_header);
  Header header;
  bool found = false;
  for (std::size_t i = 0; i < end; ++i) {
    const std::string line = upper_case(text.lines[i].substr(0, 200));
    std::smatch match;
    if (!found && std::regex_search(line, match, pattern)) {
      header = {sample_count(parse_number(match[1].str()).value_or(0.0)),
                parse_number(match[2].str()).value_or(0.0), i, 0};
      found = true;
    }
    if (found && line.starts_with("CSMNC")) header.first = i + 1;
  }
  if (!found || header.first == 0) return std::nullopt;
  return header;
}

std::string labelled(const FileText& text, std::string_view label) {
  return value_behind(text, label, 0, longest_header);
}

std::string first_word(const std::string& text) {
  return text.substr(0, text.find(' '));
}

// Degrees, "30.300N 103.000E DEPTH 13 KM".
std::optional<Place> hypocentre_in(const std::string& text) {
  auto place = place_in(text);
  const auto depth = number_behind(text, "DEPTH");
  if (place && depth) place->height = -1000.0 * *depth;
  return place;
}

void describe_source(const FileText& text, const Header& header, Record& record) {
  Provenance& from = record.provenance;
  keep_header(text, 0, header.first, from);
  const std::string station = labelled(text, "STATION:");
  from.event = printable(trimmed(line_at(text, 2)));
  from.station = first_word(station);
  from.station_place = place_in(behind(station, from.station));
  from.hypocentre = hypocentre_in(labelled(text, "EPICENTER"));
  from.processed = !find_line(text, "UNCORRECTED", 0, header.first);
  from.treatment = from.processed ? "corrected" : "none: uncorrected";
  name_component(record, labelled(text, "COMP."));
}

void check_peak(const FileText& text, double factor, Record& record) {
  const auto stated = leading_number(labelled(text, "PEAK VALUE:"));
  if (stated) check_stated_peak(record, *stated * factor, 1e-3 * factor);
}

}  // namespace

bool is_csmnc(const FileText& text) {
  return find_header(text).has_value();
}

Record read_csmnc(const FileText& text, const ReadOptions& options) {
  const auto found = find_header(text);
  if (!found)
    throw InputError(text.name, 0, "a line \"NO. OF POINTS: ... EQUALLY SPACED INTERVALS OF:\"", "none");
  std::vector<InputProblem> problems;
  std::vector<std::string> warnings;
  const std::string units = labelled(text, "UNIT:");
  const double factor = stated_factor(text, units, 0, options, problems);
  auto values = collect_numbers(text, found->first, text.lines.size(), problems);
  check_count(text, found->points, found->line + 1, values, problems, warnings);
  check_series(text, found->points, found->interval, found->line + 1, options, problems);
  throw_if_any(std::move(problems));
  Record record = make_record(text, "CSMNC uncorrected", std::move(values), factor, found->interval, units);
  record.warnings = std::move(warnings);
  describe_source(text, *found, record);
  check_peak(text, factor, record);
  remove_recorded_offset(record, false, options);
  return record;
}

std::string write_csmnc(const Record& record) {
  const Provenance& from = record.provenance;
  const auto degrees = [](const std::optional<Place>& place) {
    if (!place) return std::string{};
    return fmt::format("{:7.3f}{} {:7.3f}{}", std::abs(place->latitude), place->latitude < 0.0 ? 'S' : 'N',
                       std::abs(place->longitude), place->longitude < 0.0 ? 'W' : 'E');
  };
  const Peak top = peak(record.acceleration, record.interval);
  std::string out =
      fmt::format("{}\n{}\n{}\n", printable(from.station), from.start_time, printable(from.event));
  out += fmt::format("EPICENTER {}\nMAGNITUDE\nSTATION: {} {}\n", degrees(from.hypocentre),
                     printable(from.station), degrees(from.station_place));
  out += "SITE CONDITION:\nINSTRUMENT TYPE:\nOBSERVING POINT:\n";
  out += fmt::format("COMP. {}\n", printable(record.component));
  out += fmt::format("{} ACCELERATION          UNIT: CM/SEC/SEC\n",
                     from.processed ? "CORRECTED" : "UNCORRECTED");
  out += fmt::format("NO. OF POINTS:  {}  EQUALLY SPACED INTERVALS OF:  {}  SEC\n",
                     record.acceleration.size(), record.interval);
  out += fmt::format("PEAK VALUE: {:12.3f}   AT  {:g} SEC    DURATION:  {:g} SEC\n",
                     record.acceleration[top.index] / gal, top.time, record.duration());
  out += fmt::format("PRE-EVENT TIME:  0  SEC\nCSMNC{}\n\n", from.synthetic ? "  SYNTHETIC" : "");
  for (std::size_t i = 0; i < record.acceleration.size(); ++i) {
    const bool last = i % 8 == 7 || i + 1 == record.acceleration.size();
    out += fmt::format("{:14.6E}{}", record.acceleration[i] / gal, last ? "\n" : " ");
  }
  return out;
}

}  // namespace dougong::seismic
