#include "seismic/formats/unam.h"

#include <fmt/format.h>

#include <algorithm>
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

constexpr std::size_t longest_header = 200;  // lines; 110 in the known form

std::string value_of(const FileText& text, std::string_view label) {
  const std::string rest = value_behind(text, label, 0, longest_header);
  const auto colon = rest.find(':');
  return colon == std::string::npos ? std::string{} : std::string(trimmed(rest.substr(colon + 1)));
}

std::vector<std::string> parts(std::string_view text, std::string_view separators) {
  std::vector<std::string> out;
  while (!text.empty()) {
    const auto end = std::min(text.find_first_of(separators), text.size());
    const auto part = trimmed(text.substr(0, end));
    if (!part.empty()) out.emplace_back(part);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

// The entry of one channel in "/250/250/250".
double number_of(const FileText& text, std::string_view label, std::size_t channel) {
  const auto entries = parts(value_of(text, label), "/");
  return channel < entries.size() ? leading_number(entries[channel]).value_or(0.0) : 0.0;
}

// Latitude on the line of the label, longitude on the one below it.
std::optional<Place> place_of(const FileText& text, std::string_view label) {
  const auto line = find_line(text, label, 0, longest_header);
  if (!line) return std::nullopt;
  const auto north = number_behind(text.lines[*line], ":"),
             east = number_behind(line_at(text, *line + 1), ":");
  if (!north || !east) return std::nullopt;
  const bool south = contains(text.lines[*line], "LAT. S"),
             west = contains(line_at(text, *line + 1), "LONG. W");
  return Place{south ? -*north : *north, west ? -*east : *east, std::nullopt};
}

void describe_source(const FileText& text, std::size_t titles, Record& record) {
  Provenance& from = record.provenance;
  keep_header(text, 0, titles, from);
  const std::string day = value_of(text, "FECHA DEL SISMO");
  from.event = fmt::format("{} {}, {}", day, value_of(text, "HORA EPICENTRO"), value_of(text, "MAGNITUD"));
  from.station = value_of(text, "CLAVE DE LA ESTACION");
  from.station_place = place_of(text, "COORDENADAS DE LA ESTACION");
  if (from.station_place) from.station_place->height = leading_number(value_of(text, "ALTITUD"));
  from.hypocentre = place_of(text, "COORDENADAS DEL EPICENTRO");
  if (const auto depth = leading_number(value_of(text, "PROFUNDIDAD FOCAL")); depth && from.hypocentre)
    from.hypocentre->height = -1000.0 * *depth;
  // The hour of the first sample has no date: it may lie on the day after the event's.
  from.start_time = value_of(text, "HORA DE LA PRIMERA MUESTRA");
}

void check_samples(const FileText& text, std::size_t channel, std::size_t line,
                   const std::vector<double>& values, std::vector<InputProblem>& problems,
                   std::vector<std::string>& warnings) {
  const std::size_t stated = sample_count(number_of(text, "NUM. TOTAL DE MUESTRAS", channel));
  if (values.size() < stated)
    problems.push_back({text.name, line, fmt::format("{} values, as the header states", stated),
                        fmt::format("{} (the file is truncated)", values.size())});
  if (stated > 0 && values.size() > stated)
    warnings.push_back(
        fmt::format("the header states {} values, the file holds {}: all are kept", stated, values.size()));
}

}  // namespace

bool is_unam(const FileText& text) {
  return find_line(text, "ARCHIVO ESTANDAR DE ACELERACION", 0, 20) &&
         find_line(text, "CANAL-1", 0, longest_header);
}

std::vector<Record> read_unam(const FileText& text, const ReadOptions& options) {
  const auto titles = find_line(text, "CANAL-1", 0, longest_header);
  if (!titles) throw InputError(text.name, 0, "a line of titles \"CANAL-1 ...\"", "none");
  const std::vector<std::string> names = parts(line_at(text, *titles + 1), " \t");
  const std::string stated_format = value_of(text, "FORMATO DATOS");
  const auto format = field_format_in(stated_format);
  if (!format || format->per_line != names.size())
    throw InputError(text.name, *titles + 2,
                     "a component for each field of the format " + in_quotes(stated_format),
                     fmt::format("{}", names.size()));
  std::vector<InputProblem> problems;
  const std::string units(before(value_of(text, "UNIDADES DE LOS DATOS"), "("));
  const double factor = stated_factor(text, units, 0, options, problems);
  auto columns = columns_of(read_rows(text, *titles + 3, *format, problems), names.size());
  const std::size_t line = find_line(text, "NUM. TOTAL DE MUESTRAS", 0, *titles).value_or(0) + 1;
  std::vector<Record> records;
  for (std::size_t i = 0; i < names.size(); ++i) {
    std::vector<std::string> warnings;
    if (problems.empty()) check_samples(text, i, line, columns[i], problems, warnings);
    const double rate = number_of(text, "VEL. DE MUESTREO", i);
    ChannelSamples samples{"UNAM", names[i], units, std::move(columns[i]), factor, 1.0 / rate, line};
    records.push_back(make_channel(text, std::move(samples), options, std::move(problems)));
    problems.clear();
    Record& record = records.back();
    record.warnings = std::move(warnings);
    describe_source(text, *titles, record);
    const double peak = number_of(text, "ACEL. MAX.(Gal)", i);
    if (peak != 0.0) check_stated_peak(record, peak * factor, 0.01 * factor);
    remove_recorded_offset(record, false, options);
  }
  return records;
}

}  // namespace dougong::seismic
