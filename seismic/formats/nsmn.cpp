#include "seismic/formats/nsmn.h"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "seismic/formats/header_text.h"
#include "seismic/formats/samples.h"
#include "seismic/formats/table_rows.h"
#include "seismic/numerics/parse_number.h"
#include "seismic/time_text.h"

namespace dougong::seismic {
namespace {

constexpr std::size_t longest_header = 30;  // lines; 18 in the known form

std::string value_of(const FileText& text, std::string_view label) {
  const std::string behind_label = value_behind(text, label, 0, longest_header);
  const auto colon = behind_label.find(':');
  return colon == std::string::npos ? behind_label : std::string(trimmed(behind_label.substr(colon + 1)));
}

std::optional<std::size_t> titles_line(const FileText& text) {
  for (std::size_t i = 0; i < std::min(text.lines.size(), longest_header); ++i) {
    const auto line = trimmed(line_at(text, i));
    if (line.starts_with("N-S") && contains(line, "E-W") && contains(line, "U-D")) return i;
  }
  return std::nullopt;
}

std::vector<std::string> titles_of(std::string_view line) {
  std::vector<std::string> titles;
  for (line = trimmed(line); !line.empty();) {
    const auto end = std::min(line.find_first_of(" \t"), line.size());
    titles.emplace_back(line.substr(0, end));
    line = trimmed(line.substr(end));
  }
  return titles;
}

// "37.24010N-27.60310E": the hyphen is no sign.
std::optional<Place> place_of(std::string text) {
  for (char& c : text) c = c == '-' ? ' ' : c;
  return place_in(text);
}

void describe_source(const FileText& text, std::size_t titles, Record& record) {
  Provenance& from = record.provenance;
  keep_header(text, 0, titles, from);
  from.event =
      fmt::format("{}, M {}", value_of(text, "EARTHQUAKE DATE"), value_of(text, "EARTHQUAKE MAGNITUDE"));
  from.station = value_of(text, "STATION ID");
  from.station_place = place_of(value_of(text, "STATION COORDINATES"));
  if (from.station_place) from.station_place->height = leading_number(value_of(text, "STATION ALTITUDE"));
  from.hypocentre = place_of(value_of(text, "EPICENTER COORDINATES"));
  from.start_time = iso_time_in(value_of(text, "RECORD TIME"), DateOrder::day_month_year, "Z");
  from.treatment = "none: raw";
}

void check_peak(const FileText& text, const std::string& title, double factor, Record& record) {
  const auto stated = number_behind(value_behind(text, "RAW PGA", 0, longest_header), "(" + title + ")");
  if (stated) check_stated_peak(record, *stated * factor, 1e-4 * factor, true);
}

}  // namespace

bool is_nsmn(const FileText& text) {
  return titles_line(text) && find_line(text, "NUMBER OF DATA", 0, longest_header) &&
         find_line(text, "SAMPLING INTERVAL", 0, longest_header);
}

std::vector<Record> read_nsmn(const FileText& text, const ReadOptions& options) {
  const auto titles = titles_line(text);
  if (!titles) throw InputError(text.name, 0, "a line of titles \"N-S E-W U-D\"", "none");
  const std::vector<std::string> names = titles_of(text.lines[*titles]);
  const double factor = 0.01;  // gal; the header says so of its peaks
  std::vector<InputProblem> problems;
  check_stated_units(text, "gal", options, problems);
  std::vector<std::string> warnings;
  auto columns = read_table_rows(text, *titles + 1, names.size(), problems);
  const std::size_t stated_on = find_line(text, "NUMBER OF DATA", 0, *titles).value_or(0) + 1;
  const double stated = leading_number(value_of(text, "NUMBER OF DATA")).value_or(0.0);
  const double interval = leading_number(value_of(text, "SAMPLING INTERVAL")).value_or(0.0);
  std::vector<Record> records;
  for (std::size_t i = 0; i < names.size(); ++i) {
    check_count(text, sample_count(stated), stated_on, columns[i], problems, warnings);
    ChannelSamples samples{"NSMN text", names[i], "gal", std::move(columns[i]), factor, interval, stated_on};
    records.push_back(make_channel(text, std::move(samples), options, std::move(problems)));
    problems.clear();
    Record& record = records.back();
    record.warnings = std::exchange(warnings, {});
    describe_source(text, *titles, record);
    check_peak(text, names[i], factor, record);
    remove_recorded_offset(record, false, options);
  }
  return records;
}

}  // namespace dougong::seismic
