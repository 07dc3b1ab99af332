#include "seismic/formats/write_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "seismic/constants.h"
#include "seismic/formats/csmnc.h"
#include "seismic/formats/file_text.h"
#include "seismic/formats/knet.h"
#include "seismic/formats/miniseed.h"
#include "seismic/formats/peer_at2.h"
#include "seismic/formats/record_csv.h"
#include "seismic/input_error.h"
#include "seismic/measures/peaks.h"
#include "seismic/time_text.h"

namespace dougong::seismic {
namespace {

constexpr double gal = 0.01;  // m/s2

// Between the commas of a header line.
std::string field(const std::string& text) {
  std::string out = printable(text);
  std::replace(out.begin(), out.end(), ',', ' ');
  return out;
}

// As part of a file's name.
std::string name_part(const std::string& component) {
  std::string out;
  for (const char c : component) out += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return out;
}

// --- AT2 and CSMNC ---------------------------------------------------------------------------------

WrittenFile at2_file(const Record& record) {
  const Provenance& from = record.provenance;
  const std::string day = from.start_time.substr(0, 10);
  PeerAt2Sheet sheet{from.synthetic ? "SYNTHETIC motion, written by dougong" : "Written by dougong",
                     field(from.event),
                     day.empty() ? "undated" : day,
                     field(from.station),
                     field(record.component),
                     record.interval,
                     record.acceleration};
  return {"-" + name_part(record.component) + ".AT2", write_peer_at2(sheet), {record.component}};
}

WrittenFile csmnc_file(const Record& record) {
  return {"-" + name_part(record.component) + ".dat", write_csmnc(record), {record.component}};
}

// --- K-NET -----------------------------------------------------------------------------------------

// North, east and up, with the sensor's digit where the record has one.
std::string knet_name(const Record& record) {
  const std::string& sensor = record.provenance.sensor;
  const std::string digit = sensor == "1" || sensor == "2" ? sensor : "";
  if (record.axis == Axis::vertical) return "UD" + digit;
  const double azimuth = record.azimuth.value_or(-1.0);
  if (std::abs(std::remainder(azimuth, 360.0)) < 0.5) return "NS" + digit;
  if (std::abs(azimuth - 90.0) < 0.5) return "EW" + digit;
  throw InputError(record.provenance.file, 0,
                   "components north, east and up, as K-NET keeps them (--azimuth 0)", record.component);
}

std::string knet_direction(const std::string& name) {
  constexpr std::array<std::string_view, 6> sensors = {"NS1", "EW1", "UD1", "NS2", "EW2", "UD2"};
  for (std::size_t i = 0; i < sensors.size(); ++i)
    if (name == sensors[i]) return fmt::format("{}", i + 1);
  return fmt::format("{}-{}", name[0], name[1]);
}

int whole_hertz(const Record& record) {
  const double rate = 1.0 / record.interval;
  if (std::abs(rate - std::round(rate)) <= 1e-9 * rate) return static_cast<int>(std::lround(rate));
  throw InputError(record.provenance.file, 0, "a whole number of samples a second, as K-NET states it",
                   fmt::format("{:.6g} Hz", rate));
}

// "2018-01-24T10:51:28.000Z" -> "2018/01/24 19:51:28", so many seconds later in Japan.
std::string japanese_time(const std::string& start, double later) {
  std::string time = shifted_time(start, 9 * 3600.0 + later).substr(0, 19);
  if (time.empty()) return "1970/01/01 00:00:00";
  time[4] = time[7] = '/';
  time[10] = ' ';
  return time;
}

std::string degrees(const std::optional<Place>& place, bool north) {
  return place ? fmt::format("{:.4f}", north ? place->latitude : place->longitude) : "0";
}

KnetSheet knet_sheet(const Record& record, const std::string& name) {
  const Provenance& from = record.provenance;
  KnetSheet sheet;
  sheet.record_time = japanese_time(from.start_time, 15.0);
  sheet.origin_time = japanese_time(from.start_time, 0.0);
  sheet.latitude = degrees(from.hypocentre, true);
  sheet.longitude = degrees(from.hypocentre, false);
  sheet.depth = from.hypocentre && from.hypocentre->height
                    ? fmt::format("{:.0f}", *from.hypocentre->height / -1000.0)
                    : "0";
  sheet.magnitude = "0";
  sheet.station_code = name_part(from.station).substr(0, 6);
  sheet.station_latitude = degrees(from.station_place, true);
  sheet.station_longitude = degrees(from.station_place, false);
  sheet.station_height = from.station_place && from.station_place->height
                             ? fmt::format("{:.0f}", *from.station_place->height)
                             : "0";
  sheet.direction = knet_direction(name);
  sheet.memo =
      printable((from.synthetic ? "SYNTHETIC; " : "") + std::string("written by dougong; ") + from.event);
  sheet.sampling_frequency = whole_hertz(record);
  return sheet;
}

// Eight million counts at the peak: seven digits, the most that the fields hold.
WrittenFile knet_file(const Record& record) {
  const std::string name = knet_name(record);
  KnetSheet sheet = knet_sheet(record, name);
  const double top = peak(record.acceleration, record.interval).value;
  sheet.scale_counts = 8000000;
  sheet.scale_gal = std::max(1.0, std::ceil(top / gal));
  const double count = sheet.scale_gal / static_cast<double>(sheet.scale_counts) * gal;
  for (const double a : record.acceleration) sheet.counts.push_back(std::lround(a / count));
  return {"." + name, write_knet(sheet), {record.component}};
}

// --- miniSEED --------------------------------------------------------------------------------------

std::string seed_code(const std::string& text, std::size_t most) {
  std::string out;
  for (const char c : text)
    if (std::isalnum(static_cast<unsigned char>(c)) && out.size() < most)
      out += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return out;
}

// HNE, HNN and HNZ; numbers for other directions. A name that is a channel already is kept.
std::string seed_channel(const Record& record, std::size_t which) {
  const std::string& name = record.component;
  if (name.size() == 3 && name[1] == 'N' && seed_code(name, 3) == name) return name;
  if (record.axis == Axis::vertical) return "HNZ";
  const double azimuth = record.azimuth.value_or(-1.0);
  if (std::abs(std::remainder(azimuth, 360.0)) < 0.5) return "HNN";
  if (std::abs(azimuth - 90.0) < 0.5) return "HNE";
  return fmt::format("HN{}", which % 9 + 1);
}

WrittenFile miniseed_file(std::span<const Record> components) {
  std::vector<MiniseedChannel> channels;
  WrittenFile file{".mseed", {}, {}};
  for (std::size_t i = 0; i < components.size(); ++i) {
    const Provenance& from = components[i].provenance;
    const auto point = from.station.find('.');
    const bool networked = point != std::string::npos && point <= 2;
    channels.push_back({networked ? seed_code(from.station.substr(0, point), 2) : "XX",
                        seed_code(networked ? from.station.substr(point + 1) : from.station, 5),
                        seed_code(from.sensor, 2), seed_channel(components[i], i),
                        shifted_time(from.start_time, 0.0), components[i].interval,
                        components[i].acceleration});
    file.components.push_back(components[i].component);
  }
  file.bytes = write_miniseed(channels);
  return file;
}

WrittenFile csv_file(std::span<const Record> components) {
  WrittenFile file{".csv", write_record_csv(components), {}};
  for (const Record& record : components) file.components.push_back(record.component);
  return file;
}

void require_units(const Record& record) {
  if (record.dimensionless)
    throw InputError(record.provenance.file, 0, "an acceleration; this shape needs a target PGA (option pga)",
                     "a dimensionless record");
}

}  // namespace

std::optional<WrittenFormat> written_format(std::string_view name) {
  const std::string word = upper_case(name);
  if (word == "AT2") return WrittenFormat::at2;
  if (word == "KNET" || word == "K-NET") return WrittenFormat::knet;
  if (word == "CSMNC") return WrittenFormat::csmnc;
  if (word == "CSV") return WrittenFormat::csv;
  if (word == "MINISEED" || word == "MSEED") return WrittenFormat::miniseed;
  return std::nullopt;
}

std::vector<WrittenFile> write_records(std::span<const Record> components, WrittenFormat format) {
  for (const Record& record : components) require_units(record);
  if (components.empty()) throw InputError("records", 0, "at least one component", "none");
  if (format == WrittenFormat::csv) return {csv_file(components)};
  if (format == WrittenFormat::miniseed) return {miniseed_file(components)};
  std::vector<WrittenFile> files;
  for (const Record& record : components)
    files.push_back(format == WrittenFormat::at2    ? at2_file(record)
                    : format == WrittenFormat::knet ? knet_file(record)
                                                    : csmnc_file(record));
  return files;
}

}  // namespace dougong::seismic
