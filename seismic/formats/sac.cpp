#include "seismic/formats/sac.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <utility>

#include "seismic/formats/even_steps.h"
#include "seismic/formats/samples.h"
#include "seismic/time_text.h"
#include "seismic/units.h"

namespace dougong::seismic {
namespace {

constexpr std::size_t header_bytes = 632, integers_at = 280, characters_at = 440;

// Places from 0.
constexpr std::size_t delta = 0, begin = 5, station_latitude = 31, station_longitude = 32,
                      station_height = 33, event_latitude = 35, event_longitude = 36, azimuth = 57;
constexpr std::size_t version = 6, samples_stated = 9, file_type = 15, evenly_spaced = 35;
constexpr std::size_t station_name = 0, event_name = 8, location = 24, component = 160, network = 168;
constexpr std::int32_t time_series = 1;
constexpr float unknown = -12345.0f;

class Header {
 public:
  explicit Header(std::string_view bytes) : bytes_(bytes) { swapped_ = !known_version(); }

  bool known_version() const {
    const std::int32_t found = integer(version);
    return found == 6 || found == 7;
  }
  std::int32_t integer(std::size_t place) const {
    return std::bit_cast<std::int32_t>(word(integers_at + 4 * place));
  }
  float real_at(std::size_t at) const { return std::bit_cast<float>(word(at)); }
  std::optional<double> real(std::size_t place) const {
    const float value = real_at(4 * place);
    return value == unknown ? std::nullopt : std::optional(static_cast<double>(value));
  }
  std::string text(std::size_t at, std::size_t length = 8) const {
    const std::string_view field = bytes_.substr(characters_at + at, length);
    const std::string found = printable(trimmed(field.substr(0, field.find('\0'))));
    return found.starts_with("-12345") ? std::string{} : found;
  }

 private:
  std::uint32_t word(std::size_t at) const {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes_.data() + at, sizeof value);
    return swapped_ ? __builtin_bswap32(value) : value;
  }

  std::string_view bytes_;
  bool swapped_ = false;
};

std::string start_of(const Header& h) {
  const double second = h.integer(4) + h.integer(5) / 1000.0 + h.real(begin).value_or(0.0);
  return iso_time_of_day(h.integer(0), h.integer(1), h.integer(2), h.integer(3), second, "Z");
}

std::optional<Place> place_of(const Header& h, std::size_t north, std::size_t east) {
  const auto lat = h.real(north), lon = h.real(east);
  return lat && lon ? std::optional(Place{*lat, *lon, std::nullopt}) : std::nullopt;
}

void describe_source(const Header& h, Record& record) {
  Provenance& from = record.provenance;
  from.event = h.text(event_name, 16);
  from.station =
      h.text(network).empty() ? h.text(station_name) : h.text(network) + "." + h.text(station_name);
  from.sensor = h.text(location);
  from.station_place = place_of(h, station_latitude, station_longitude);
  if (from.station_place) from.station_place->height = h.real(station_height);
  from.hypocentre = place_of(h, event_latitude, event_longitude);
  from.start_time = start_of(h);
  const auto degrees = h.real(azimuth);
  if (degrees && record.axis == Axis::horizontal) record.azimuth = std::fmod(*degrees + 360.0, 360.0);
}

// DELTA is a 32-bit real: 0.0199999996 is 0.02.
double interval_of(const Header& h) {
  const double step = h.real(delta).value_or(0.0);
  return step > 0.0 ? plain_interval(step, 1e-6) : step;
}

void check_header(const FileText& text, const Header& h, std::vector<InputProblem>& problems) {
  if (h.integer(file_type) != time_series || h.integer(evenly_spaced) != 1)
    problems.push_back({text.name, 0, "a SAC time series with equal steps (IFTYPE 1, LEVEN 1)",
                        fmt::format("IFTYPE {}, LEVEN {}", h.integer(file_type), h.integer(evenly_spaced))});
}

std::vector<double> samples_of(const FileText& text, const Header& h, std::vector<InputProblem>& problems,
                               std::vector<std::string>& warnings) {
  std::vector<double> values;
  for (std::size_t at = header_bytes; at + 4 <= text.bytes.size(); at += 4) values.push_back(h.real_at(at));
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (std::isfinite(values[k])) continue;
    problems.push_back({text.name, 0, "finite samples", fmt::format("{} as sample {}", values[k], k + 1)});
    break;
  }
  check_count(text, sample_count(h.integer(samples_stated)), 0, values, problems, warnings);
  return values;
}

}  // namespace

bool is_sac(const FileText& text) {
  if (text.bytes.size() < header_bytes) return false;
  const Header header(text.bytes);
  return header.known_version() && header.integer(samples_stated) > 0 && header.integer(file_type) > 0 &&
         header.integer(file_type) < 100;
}

Record read_sac(const FileText& text, const ReadOptions& options) {
  if (text.bytes.size() < header_bytes)
    throw InputError(text.name, 0, "a SAC header of 632 bytes", fmt::format("{} bytes", text.bytes.size()));
  const Header header(text.bytes);
  std::vector<InputProblem> problems;
  std::vector<std::string> warnings;
  check_header(text, header, problems);
  const double factor = declared_factor(text, "SAC files do not hold any", options, problems);
  std::vector<double> values = samples_of(text, header, problems, warnings);
  const std::string name = header.text(component);
  Record record =
      make_channel(text,
                   {"SAC", name.empty() ? "H" : name, options.units.value_or("") + " (given by the user)",
                    std::move(values), factor, interval_of(header), 0},
                   options, std::move(problems));
  record.warnings = std::move(warnings);
  describe_source(header, record);
  remove_recorded_offset(record, is_counts(*options.units), options);
  return record;
}

}  // namespace dougong::seismic
