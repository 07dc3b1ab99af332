#include "seismic/formats/knet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "seismic/formats/header_text.h"
#include "seismic/formats/samples.h"
#include "seismic/numerics/parse_number.h"
#include "seismic/time_text.h"
#include "seismic/units.h"

namespace dougong::seismic {
namespace {

constexpr std::size_t label_width = 18;
constexpr std::size_t longest_header = 40;  // lines; 17 in every file seen
constexpr double gal = 0.01;                // m/s2

struct Field {
  std::string label, value;
  std::size_t line = 0;  // from 1
};

struct Header {
  std::vector<Field> fields;
  std::size_t first = 0;  // index of the first data line

  const Field* find(std::string_view label) const {
    for (const Field& field : fields) {
      if (std::string_view(field.label).starts_with(label)) return &field;
    }
    return nullptr;
  }
  std::string value(std::string_view label) const {
    const Field* field = find(label);
    return field ? field->value : std::string{};
  }
};

Header split_header(const FileText& text) {
  Header header;
  for (std::size_t i = 0; i < std::min(text.lines.size(), longest_header); ++i) {
    const std::string_view line = text.lines[i];
    header.fields.push_back({printable(trimmed(line.substr(0, label_width))),
                             line.size() > label_width ? printable(trimmed(line.substr(label_width))) : "",
                             i + 1});
    if (line.starts_with("Memo")) {
      header.first = i + 1;
      return header;
    }
  }
  return header;
}

// A positive number at the start of a header value ("100Hz"), or a problem and 0.
double required_number(const FileText& text, const Header& header, std::string_view label,
                       std::vector<InputProblem>& problems) {
  const Field* field = header.find(label);
  const auto number = field ? leading_number(field->value) : std::nullopt;
  if (number && *number > 0.0) return *number;
  problems.push_back({text.name, field ? field->line : 0, fmt::format("a positive number for \"{}\"", label),
                      field ? "\"" + field->value + "\"" : "no such header line"});
  return 0.0;
}

double required_scale(const FileText& text, const Header& header, std::vector<InputProblem>& problems) {
  const Field* field = header.find("Scale Factor");
  const auto scale = field ? parse_count_scale(field->value) : std::nullopt;
  if (scale) return *scale;
  problems.push_back({text.name, field ? field->line : 0, "a scale factor such as 3920(gal)/6182761",
                      field ? "\"" + field->value + "\"" : "no header line \"Scale Factor\""});
  return 0.0;
}

std::optional<Place> place_of(const Header& header, std::string_view latitude, std::string_view longitude) {
  const auto north = leading_number(header.value(latitude)), east = leading_number(header.value(longitude));
  return north && east ? std::optional(Place{*north, *east, std::nullopt}) : std::nullopt;
}

// The recorder notes the time at which the trigger's delay ends, 15 s after the first sample.
std::string start_of(const Header& header) {
  constexpr double trigger_delay = 15.0;  // s
  return iso_time_in(header.value("Record Time"), DateOrder::year_month_day, "+09:00", -trigger_delay);
}

void describe_source(const Header& header, Record& record) {
  Provenance& from = record.provenance;
  for (const Field& field : header.fields) from.header.emplace_back(field.label, field.value);
  from.station = header.value("Station Code");
  from.scale = "1 count = " + header.value("Scale Factor") + " gal";
  from.synthetic = contains(header.value("Memo"), "SYNTHETIC");
  const std::string when = from.synthetic ? "synthetic motion" : header.value("Origin Time");
  from.event = fmt::format("{}, M {}", when, header.value("Mag"));
  from.treatment = "none: counts";
  from.start_time = start_of(header);
  from.station_place = place_of(header, "Station Lat", "Station Lon");
  if (from.station_place) from.station_place->height = leading_number(header.value("Station Height"));
  from.hypocentre = place_of(header, "Lat", "Lon");
  if (const auto depth = leading_number(header.value("Depth")); depth && from.hypocentre)
    from.hypocentre->height = -1000.0 * *depth;
  name_component(record, knet_component(header.value("Dir")));
  from.component = header.value("Dir");
  from.sensor = knet_sensor(record.component);
}

// The file's own check of its numbers: printed to 0.001 gal, of the samples without their mean.
void check_peak(const Header& header, Record& record) {
  const auto stated = leading_number(header.value("Max"));
  if (stated) check_stated_peak(record, *stated * gal, 0.002 * gal, true);
}

}  // namespace

std::string knet_component(const std::string& direction) {
  constexpr std::array<const char*, 6> sensors = {"NS1", "EW1", "UD1", "NS2", "EW2", "UD2"};
  if (direction.size() == 1 && direction[0] >= '1' && direction[0] <= '6') {
    return sensors[static_cast<std::size_t>(direction[0] - '1')];
  }
  std::string name;
  for (const char c : direction) {
    if (c != '-') name += c;
  }
  return name;
}

std::string knet_sensor(const std::string& component) {
  const bool numbered = component.size() == 3 && (component[2] == '1' || component[2] == '2');
  return numbered ? component.substr(2) : std::string{};
}

bool is_knet(const FileText& text) {
  return !text.lines.empty() && text.lines[0].starts_with("Origin Time") &&
         split_header(text).find("Scale Factor");
}

Record read_knet(const FileText& text, const ReadOptions& options) {
  const Header header = split_header(text);
  std::vector<InputProblem> problems;
  std::vector<std::string> warnings;
  if (header.first == 0) throw InputError(text.name, 0, "a header that ends with a line \"Memo.\"", "none");
  const double rate = required_number(text, header, "Sampling Freq", problems);
  const double duration = required_number(text, header, "Duration Time", problems);
  const double scale = required_scale(text, header, problems);
  check_stated_units(text, "counts", options, problems);
  auto counts = collect_numbers(text, header.first, text.lines.size(), problems);
  throw_if_any(std::exchange(problems, {}));
  const Field* stated = header.find("Duration Time");
  check_count(text, sample_count(std::round(rate * duration)), stated->line, counts, problems, warnings);
  check_series(text, counts.size(), 1.0 / rate, stated->line, options, problems);
  throw_if_any(std::move(problems));
  Record record = make_record(text, "K-NET/KiK-net ASCII", std::move(counts), scale, 1.0 / rate,
                              "counts x " + header.value("Scale Factor"));
  record.warnings = std::move(warnings);
  describe_source(header, record);
  check_peak(header, record);
  remove_recorded_offset(record, true, options);
  return record;
}

std::vector<std::filesystem::path> knet_siblings(const std::filesystem::path& path) {
  const std::string own = path.extension().string();  // ".EW2"
  const std::string upper = upper_case(own);
  const std::string sensor = upper.size() == 4 ? upper.substr(3) : "";
  const std::string direction = upper.substr(0, std::min<std::size_t>(3, upper.size()));
  if (direction != ".EW" && direction != ".NS" && direction != ".UD") return {path};
  const bool lower = own != upper;
  std::vector<std::filesystem::path> paths;
  for (std::string suffix : {".EW", ".NS", ".UD"}) {
    if (lower) suffix = suffix == ".EW" ? ".ew" : suffix == ".NS" ? ".ns" : ".ud";
    paths.push_back(std::filesystem::path(path).replace_extension(suffix + sensor));
  }
  return paths;
}

std::string write_knet(const KnetSheet& sheet) {
  std::string out;
  const auto line = [&out](std::string_view label, const std::string& value) {
    out += fmt::format("{:<18}{}\n", label, value);
  };
  double sum = 0.0, peak = 0.0;
  for (const long count : sheet.counts) sum += static_cast<double>(count);
  const double offset = sum / static_cast<double>(sheet.counts.size());
  for (const long count : sheet.counts) peak = std::max(peak, std::abs(static_cast<double>(count) - offset));
  line("Origin Time", sheet.origin_time);
  line("Lat.", sheet.latitude);
  line("Long.", sheet.longitude);
  line("Depth. (km)", sheet.depth);
  line("Mag.", sheet.magnitude);
  line("Station Code", sheet.station_code);
  line("Station Lat.", sheet.station_latitude);
  line("Station Long.", sheet.station_longitude);
  line("Station Height(m)", sheet.station_height);
  line("Record Time", sheet.record_time);
  line("Sampling Freq(Hz)", fmt::format("{}Hz", sheet.sampling_frequency));
  line("Duration Time(s)",
       fmt::format("{:g}", static_cast<double>(sheet.counts.size()) / sheet.sampling_frequency));
  line("Dir.", sheet.direction);
  line("Scale Factor", fmt::format("{:g}(gal)/{}", sheet.scale_gal, sheet.scale_counts));
  line("Max. Acc. (gal)",
       fmt::format("{:.3f}", peak * sheet.scale_gal / static_cast<double>(sheet.scale_counts)));
  line("Last Correction", sheet.record_time);
  line("Memo.", sheet.memo);
  for (std::size_t i = 0; i < sheet.counts.size(); ++i) {
    const bool last = i % 8 == 7 || i + 1 == sheet.counts.size();
    out += fmt::format("{:8d} {}", sheet.counts[i], last ? "\n" : "");
  }
  return out;
}

}  // namespace dougong::seismic
