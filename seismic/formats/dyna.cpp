#include "seismic/formats/dyna.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "seismic/formats/header_text.h"
#include "seismic/formats/samples.h"
#include "seismic/numerics/parse_number.h"
#include "seismic/time_text.h"

namespace dougong::seismic {
namespace {

constexpr std::size_t longest_header = 100;  // lines; 64 in every file seen

struct Entry {
  std::string value;
  std::size_t line = 0;  // from 1
};

struct Header {
  std::map<std::string, Entry, std::less<>> entries;
  std::size_t first = 0;  // index of the first data line

  std::string value(std::string_view key) const {
    const auto entry = entries.find(key);
    return entry == entries.end() ? std::string{} : entry->second.value;
  }
  std::size_t line(std::string_view key) const {
    const auto entry = entries.find(key);
    return entry == entries.end() ? 0 : entry->second.line;
  }
  std::optional<double> number(std::string_view key) const { return parse_number(value(key)); }
};

Header split_header(const FileText& text) {
  Header header;
  for (std::size_t i = 0; i < std::min(text.lines.size(), longest_header); ++i) {
    const std::string_view line = line_at(text, i);
    const auto colon = line.find(':');
    if (colon == std::string_view::npos) break;
    const std::string key = printable(trimmed(line.substr(0, colon)));
    header.entries.try_emplace(key, Entry{printable(trimmed(line.substr(colon + 1))), i + 1});
    header.first = i + 1;
    if (key == "USER5") break;
  }
  return header;
}

double required(const FileText& text, const Header& header, std::string_view key,
                std::vector<InputProblem>& problems) {
  const auto number = header.number(key);
  if (number && *number > 0.0) return *number;
  problems.push_back({text.name, header.line(key), fmt::format("a positive number for \"{}\"", key),
                      header.line(key) ? in_quotes(header.value(key)) : "no such header line"});
  return 0.0;
}

std::optional<Place> place_of(const Header& header, const std::string& whose, std::string_view height,
                              double unit) {
  const auto north = header.number(whose + "_LATITUDE_DEGREE"),
             east = header.number(whose + "_LONGITUDE_DEGREE");
  if (!north || !east) return std::nullopt;
  Place place{*north, *east, header.number(height)};
  if (place.height) *place.height *= unit;
  return place;
}

std::string treatment_of(const Header& header) {
  std::string text = header.value("BASELINE_CORRECTION");
  if (header.value("FILTER_TYPE").empty()) return text;
  return text + fmt::format("; {} filter of order {}, {} to {} Hz", header.value("FILTER_TYPE"),
                            header.value("FILTER_ORDER"), header.value("LOW_CUT_FREQUENCY_HZ"),
                            header.value("HIGH_CUT_FREQUENCY_HZ"));
}

std::string event_of(const Header& header) {
  const std::string moment = header.value("MAGNITUDE_W"), local = header.value("MAGNITUDE_L");
  const std::string size = !moment.empty() ? ", Mw " + moment : !local.empty() ? ", ML " + local : "";
  return fmt::format("{} {}{}", header.value("EVENT_NAME"), header.value("EVENT_DATE_YYYYMMDD"), size);
}

void describe_source(const Header& header, Record& record) {
  Provenance& from = record.provenance;
  for (const auto& [key, entry] : header.entries)
    if (!entry.value.empty()) from.header.emplace_back(key, entry.value);
  from.event = event_of(header);
  from.station = header.value("NETWORK") + "." + header.value("STATION_CODE");
  from.station_place = place_of(header, "STATION", "STATION_ELEVATION_M", 1.0);
  from.hypocentre = place_of(header, "EVENT", "EVENT_DEPTH_KM", -1000.0);
  from.processed = !header.value("FILTER_TYPE").empty();
  from.treatment = treatment_of(header);
  from.start_time =
      iso_time_in(header.value("DATE_TIME_FIRST_SAMPLE_YYYYMMDD_HHMMSS"), DateOrder::year_month_day, "Z");
}

void check_quantity(const FileText& text, const Header& header) {
  const std::string type = header.value("DATA_TYPE");
  if (type.empty() || contains(type, "ACCELERATION")) return;
  throw NotAcceleration(text.name, header.line("DATA_TYPE"), "an acceleration", in_quotes(type));
}

}  // namespace

bool is_dyna(const FileText& text) {
  const Header header = split_header(text);
  return header.line("SAMPLING_INTERVAL_S") > 0 && header.line("NDATA") > 0;
}

Record read_dyna(const FileText& text, const ReadOptions& options) {
  const Header header = split_header(text);
  check_quantity(text, header);
  std::vector<InputProblem> problems;
  std::vector<std::string> warnings;
  ChannelSamples samples{"DYNA 1.2", header.value("STREAM"), header.value("UNITS"), {}};
  samples.factor = stated_factor(text, samples.units, header.line("UNITS"), options, problems);
  samples.interval = required(text, header, "SAMPLING_INTERVAL_S", problems);
  samples.line = header.line("NDATA");
  const double stated = required(text, header, "NDATA", problems);
  samples.values = collect_numbers(text, header.first, text.lines.size(), problems);
  check_count(text, sample_count(stated), samples.line, samples.values, problems, warnings);
  const double factor = samples.factor;
  Record record = make_channel(text, std::move(samples), options, std::move(problems));
  record.warnings = std::move(warnings);
  describe_source(header, record);
  if (const auto pga = header.number("PGA_CM/S^2")) check_stated_peak(record, *pga * factor, 1e-3 * factor);
  remove_recorded_offset(record, false, options);
  return record;
}

std::vector<std::filesystem::path> dyna_siblings(const std::filesystem::path& path) {
  const std::string name = path.filename().string(), stem = path.stem().string();
  std::vector<std::filesystem::path> paths{path};
  const auto add = [&](std::string other) { paths.push_back(path.parent_path() / other); };
  for (const std::string band : {".HN", ".HG", ".HL", ".BN", ".EN"}) {
    const auto at = name.find(band);
    if (at == std::string::npos || at + 4 >= name.size() || name[at + 4] != '.') continue;
    for (const char direction : {'E', 'N', 'Z', '1', '2', '3'})
      if (direction != name[at + 3]) add(std::string(name).replace(at + 3, 1, 1, direction));
  }
  if (stem.size() < 3 || stem[stem.size() - 2] != '_') return paths;
  for (const char direction : {'E', 'N', 'U'})
    if (direction != stem.back())
      add(stem.substr(0, stem.size() - 1) + direction + path.extension().string());
  return paths;
}

}  // namespace dougong::seismic
