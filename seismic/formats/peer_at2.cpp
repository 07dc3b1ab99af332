#include "seismic/formats/peer_at2.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <regex>
#include <utility>

#include "seismic/formats/header_text.h"
#include "seismic/formats/samples.h"
#include "seismic/numerics/parse_number.h"

namespace dougong::seismic {
namespace {

constexpr std::size_t longest_header = 30;  // lines; four in every published file, more in prose ones

// Characters of a line that are matched: std::regex recurses, and a damaged line may be very long.
constexpr std::size_t longest_match = 200;

struct Header {
  std::size_t points = 0;
  double interval = 0.0;
  std::size_t line = 0;   // index of the line that states them
  std::size_t first = 0;  // index of the first data line
};

using Stated = std::pair<std::string, std::string>;  // points, interval

std::optional<Stated> match(const std::string& line, const std::regex& pattern, bool points_first) {
  std::smatch found;
  if (!std::regex_search(line, found, pattern)) return std::nullopt;
  return points_first ? Stated{found[1], found[2]} : Stated{found[2], found[1]};
}

std::optional<Stated> stated_on(std::string_view text) {
  using std::regex;
  static const auto flags = regex::ECMAScript | regex::icase | regex::optimize;
  static const regex usual(R"(NPTS\s*=\s*(\d+)[\s,;]*DT\s*=\s*([-+0-9.EDed]+))", flags);
  static const regex turned(R"(DT\s*=\s*([-+0-9.EDed]+)\s*(?:SEC)?[\s,;]*NPTS\s*=\s*(\d+))", flags);
  static const regex values_first(R"(^\s*(\d+)\s+([-+0-9.EDed]+)\s*NPTS\s*,\s*DT)", flags);
  const std::string line(text.substr(0, longest_match));
  if (auto stated = match(line, usual, true)) return stated;
  if (auto stated = match(line, turned, false)) return stated;
  return match(line, values_first, true);
}

std::optional<Stated> stated_in_prose(std::string_view text) {
  static const std::regex prose(R"((\d+)\s+points\s+at\s+equal\s+spacing\s+of\s+([0-9.EDed]+)\s*sec)",
                                std::regex::icase);
  return match(std::string(text.substr(0, longest_match)), prose, true);
}

bool is_data(std::string_view line) {
  const NumberLine numbers = parse_numbers(line);
  return numbers.numeric && !numbers.values.empty();
}

// After a prose header: the line behind "*** Begin data ***", or the first line made of numbers.
std::size_t first_data_line(const FileText& text, std::size_t from) {
  for (std::size_t i = from; i < std::min(text.lines.size(), longest_header); ++i) {
    if (upper_case(text.lines[i]).find("BEGIN DATA") != std::string::npos) return i + 1;
  }
  std::size_t i = from;
  while (i < text.lines.size() && !is_data(text.lines[i])) ++i;
  return i;
}

std::optional<Header> find_header(const FileText& text) {
  const std::size_t end = std::min(text.lines.size(), longest_header);
  const auto header = [](const Stated& stated, std::size_t line, std::size_t first) {
    const auto points = parse_number(stated.first);
    return Header{sample_count(points.value_or(0.0)), parse_number(stated.second).value_or(0.0), line, first};
  };
  for (std::size_t i = 0; i < end; ++i) {
    if (const auto stated = stated_on(text.lines[i])) return header(*stated, i, i + 1);
  }
  for (std::size_t i = 0; i < end; ++i) {
    if (const auto stated = stated_in_prose(text.lines[i]))
      return header(*stated, i, first_data_line(text, i + 1));
  }
  return std::nullopt;
}

std::size_t end_of_data(const FileText& text, std::size_t from) {
  for (std::size_t i = from; i < text.lines.size(); ++i) {
    if (text.lines[i].starts_with("***")) return i;
  }
  return text.lines.size();
}

// Line 3 (or any above the data) says what the numbers are: an acceleration in g, or something to refuse.
void check_quantity(const FileText& text, const Header& header) {
  static const std::regex in_g(R"(UNITS?\s+(OF|ARE|:)?\s*\(?G\b)");
  static const std::regex in_cm(R"(UNITS?\s+(OF|ARE|:)?\s*\(?CM)");
  bool acceleration = false;
  for (std::size_t i = 0; i < header.first && i < text.lines.size(); ++i) {
    const std::string line = upper_case(text.lines[i].substr(0, longest_match));
    if (contains(line, "VELOCITY TIME") || contains(line, "DISPLACEMENT TIME") ||
        std::regex_search(line, in_cm))
      throw NotAcceleration(
          text.name, i + 1, "an acceleration in g, of which the motion is integrated",
          in_quotes(trimmed(text.lines[i].substr(0, longest_match))) + " (a .VT2 or .DT2 file)");
    acceleration = acceleration || std::regex_search(line, in_g);
  }
  if (!acceleration)
    throw InputError(text.name, 0, "a header line \"ACCELERATION TIME SERIES IN UNITS OF G\"", "none");
}

std::vector<std::string> comma_fields(std::string_view line) {
  std::vector<std::string> fields;
  while (true) {
    const auto comma = line.find(',');
    fields.push_back(printable(trimmed(line.substr(0, comma))));
    if (comma == std::string_view::npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

// "180 (USGS STATION 117)" -> "180".
std::string component_name(std::string field) {
  if (const auto note = field.find('('); note != std::string::npos) field.resize(note);
  return std::string(trimmed(field));
}

// NGA headers give the date a field of its own, older ones the end of the event's: "11/12/1999",
// "1999-11-12", or "undated" as we write it.
bool is_date(std::string_view field) {
  const auto part = [&](char sign) { return std::ranges::count(field, sign) == 2; };
  const auto digit_or_sign = [](char c) { return (c >= '0' && c <= '9') || c == '/' || c == '-'; };
  return field == "undated" || ((part('/') || part('-')) && std::ranges::all_of(field, digit_or_sign));
}

// The fields of the title: event, date where it has its own, station, component.
void describe_title(const std::vector<std::string>& fields, Provenance& from) {
  from.event = fields.front();
  from.component = component_name(fields.back());
  std::size_t station = 1;
  if (fields.size() > 2 && is_date(fields[1])) {
    if (fields[1] != "undated") from.event += " " + fields[1];
    station = 2;
  }
  for (std::size_t i = station; i + 1 < fields.size(); ++i)
    from.station += (i > station ? ", " : "") + fields[i];
}

// "FILTER POINTS: HP=0.2 Hz LP=12.5 Hz" on line 3, or poles behind DT.
std::string filters_in(const FileText& text, const Header& header) {
  const std::string points = value_behind(text, "FILTER POINTS", 0, header.first);
  if (!points.empty()) return "filter points" + points;
  const auto poles = line_at(text, header.line);
  return contains(poles, "POLE") ? printable(trimmed(behind(poles, "SEC,"))) : std::string{};
}

void describe_source(const FileText& text, const Header& header, Record& record) {
  Provenance& from = record.provenance;
  from.processed = true;  // PEER publishes filtered records only
  keep_header(text, 0, header.first, from);
  from.treatment = filters_in(text, header);
  const bool regular = header.line >= 2 && !stated_in_prose(text.lines[1]);
  const auto fields = regular ? comma_fields(text.lines[1]) : std::vector<std::string>{};
  if (fields.size() >= 2)
    describe_title(fields, from);
  else
    from.event = printable(trimmed(text.lines[0]));
  if (from.component.empty()) from.component = std::filesystem::path(text.name).stem().string();
  name_component(record, from.component);
}

}  // namespace

bool is_peer_at2(const FileText& text) {
  return find_header(text).has_value();
}

Record read_peer_at2(const FileText& text, const ReadOptions& options) {
  const auto found = find_header(text);
  if (!found) {
    throw InputError(text.name, 0, "a line stating NPTS and DT, or \"N points at equal spacing of DT sec\"",
                     "none");
  }
  const Header& header = *found;
  std::vector<InputProblem> problems;
  std::vector<std::string> warnings;
  check_quantity(text, header);
  check_stated_units(text, "g", options, problems);
  auto values = collect_numbers(text, header.first, end_of_data(text, header.first), problems);
  check_count(text, header.points, header.line + 1, values, problems, warnings);
  check_series(text, header.points, header.interval, header.line + 1, options, problems);
  throw_if_any(std::move(problems));
  Record record = make_record(text, "PEER AT2", std::move(values), options.gravity, header.interval, "g");
  record.warnings = std::move(warnings);
  describe_source(text, header, record);
  // "PGA= .48431 G" on line 3 of some older files.
  if (const auto stated = number_behind(line_at(text, header.line > 0 ? header.line - 1 : 0), "PGA="))
    check_stated_peak(record, *stated * options.gravity, 1e-5 * options.gravity);
  remove_recorded_offset(record, false, options);
  return record;
}

std::string write_peer_at2(const PeerAt2Sheet& sheet) {
  std::string out = sheet.title + "\n";
  out += fmt::format("{}, {}, {}, {}\n", sheet.event, sheet.date, sheet.station, sheet.component);
  out += "ACCELERATION TIME SERIES IN UNITS OF G\n";
  const std::string four_decimals = fmt::format("{:7.4f}", sheet.interval);
  const bool exact = parse_number(four_decimals) == sheet.interval;
  out += fmt::format("NPTS= {:6}, DT= {} SEC\n", sheet.acceleration.size(),
                     exact ? four_decimals : fmt::format("{}", sheet.interval));
  for (std::size_t i = 0; i < sheet.acceleration.size(); ++i) {
    const bool last = i % 5 == 4 || i + 1 == sheet.acceleration.size();
    out += fmt::format("{:15.7E}{}", sheet.acceleration[i] / standard_gravity, last ? "\n" : "");
  }
  return out;
}

}  // namespace dougong::seismic
