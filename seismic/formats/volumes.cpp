#include "seismic/formats/volumes.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "seismic/formats/header_text.h"
#include "seismic/formats/samples.h"
#include "seismic/formats/volume_blocks.h"
#include "seismic/numerics/parse_number.h"
#include "seismic/time_text.h"

namespace dougong::seismic {
namespace {

constexpr std::size_t longest_text = 25;  // lines of text above the numbers of a channel's header

std::string first_line(const FileText& text) {
  return std::string(line_at(text, 0));
}

bool mentions_usc(const FileText& text) {
  return find_line(text, "STATION USC", 0, 12).has_value();
}

// --- headers ---------------------------------------------------------------------------------------

// "CHAN  1:  90 DEG" or "COMP N08W" at the start of a line.
std::string component_in(const FileText& text, const VolumeChannel& channel) {
  for (std::size_t i = channel.start; i < channel.stated; ++i) {
    const std::string_view line = line_at(text, i);
    std::string_view name;
    if (contains(line.substr(0, 4), "CHAN")) name = behind(line, ":");
    if (contains(line.substr(0, 4), "COMP")) name = behind(line, "COMP");
    if (contains(name, " DEG")) name = before(name, " DEG");
    name = trimmed(name.substr(0, name.find("  ")));
    if (!name.empty()) return printable(name);
  }
  return "?";
}

// The title of the event: the first line of the header that speaks of an earthquake, else the third.
std::string event_in(const FileText& text, const VolumeChannel& channel) {
  for (const std::string_view words : {"EARTHQUAKE", "RCRD OF", "ORIGIN"}) {
    if (const auto line = find_line(text, words, channel.start, channel.stated))
      return printable(trimmed(line_at(text, *line).substr(0, 72)));
  }
  return printable(trimmed(line_at(text, channel.start + 2)));
}

std::string first_word(std::string_view text) {
  return printable(text.substr(0, text.find_first_of(" ,")));
}

// "STATION NO. 14403   33.929N, 118.260W" with the name on the next line.
void describe_station(const FileText& text, const VolumeChannel& channel, Provenance& from) {
  for (const std::string_view words : {"STATION NO.", "STATION USC#"}) {
    const auto line = find_line(text, words, channel.start, channel.stated);
    if (!line) continue;
    const std::string_view rest = behind(text.lines[*line], words);
    from.station = first_word(rest);
    from.station_place = place_in(rest.substr(std::min(from.station.size(), rest.size())));
    return;
  }
}

std::string start_time_in(const FileText& text, const VolumeChannel& channel) {
  for (const std::string_view words : {"Start time:", "TRIGGER TIME:"}) {
    const std::string time = value_behind(text, words, channel.start, channel.stated);
    if (!time.empty())
      return iso_time_in(time, DateOrder::month_day_year,
                         contains(time, "UTC") || contains(time, "GMT") ? "Z" : "");
  }
  return {};
}

void describe_source(const FileText& text, const VolumeChannel& channel, Record& record) {
  Provenance& from = record.provenance;
  keep_header(text, channel.start, std::min(channel.start + longest_text, channel.data), from);
  from.event = event_in(text, channel);
  describe_station(text, channel, from);
  if (const auto line = find_line(text, "HYPOCENTER", channel.start, channel.stated))
    from.hypocentre = place_in(behind(text.lines[*line], ":"));
  from.start_time = start_time_in(text, channel);
  if (const auto line = find_line(text, "PASS FILTERED", channel.start, channel.stated))
    from.treatment = printable(trimmed(line_at(text, *line)));
  if (const auto line = find_line(text, "bandpass", channel.start, channel.stated))
    from.treatment = printable(trimmed(line_at(text, *line)));
}

// --- volume 2 --------------------------------------------------------------------------------------

// Its sign is not reliable, its size is.
void check_corrected_peak(const FileText& text, const VolumeChannel& channel, double factor, Record& record) {
  if (const auto line = find_line(text, "Peak acceleration", channel.start, channel.stated))
    if (const auto peak = number_behind(text.lines[*line], "Peak acceleration"))
      check_stated_peak(record, *peak * factor, 1e-3 * factor);
}

std::vector<Record> read_corrected(const FileText& text, const ReadOptions& options, std::string_view title) {
  const std::vector<VolumeChannel> channels = corrected_channels(text);
  if (channels.empty())
    throw InputError(text.name, 0, "a line \"... points of accel data equally spaced at ...\"", "none");
  if (const auto header = unfinished_header(text, channels.back()))
    throw InputError(text.name, *header + 1, "the data of the channel whose header begins here",
                     "none (the file is truncated)");
  std::vector<Record> records;
  for (const VolumeChannel& channel : channels) {
    std::vector<InputProblem> problems;
    const double factor = stated_factor(text, channel.units, channel.stated + 1, options, problems);
    auto values = corrected_values(text, channel, problems);
    records.push_back(make_channel(text,
                                   {title, component_in(text, channel), channel.units, std::move(values),
                                    factor, channel.interval, channel.stated + 1},
                                   options, std::move(problems)));
    Record& record = records.back();
    record.provenance.processed = !contains(first_line(text), "UNCORRECTED");
    describe_source(text, channel, record);
    check_corrected_peak(text, channel, factor, record);
    remove_recorded_offset(record, false, options);
  }
  if (ends_within_a_block(text))
    records.back().warnings.push_back(
        "the file ends within the velocity or displacement behind this acceleration: it was cut off");
  return records;
}

// --- volume 1 --------------------------------------------------------------------------------------

// "MAX  =  -.200 G, AT  11.576 SEC."
void check_uncorrected_peak(const FileText& text, const VolumeChannel& channel, double gravity,
                            Record& record) {
  const auto line = find_line(text, "MAX  =", channel.start, channel.stated + 3);
  const auto peak = line ? number_behind(text.lines[*line], "MAX  =") : std::nullopt;
  if (peak) check_stated_peak(record, *peak * gravity, 1e-3 * gravity);
}

void finish_uncorrected(const FileText& text, const VolumeChannel& channel, const ReadOptions& options,
                        EvenSeries&& series, Record& record) {
  std::move(series.steps.begin(), series.steps.end(), std::back_inserter(record.processing));
  std::move(series.warnings.begin(), series.warnings.end(), std::back_inserter(record.warnings));
  describe_source(text, channel, record);
  record.provenance.treatment = "none: uncorrected";
  check_uncorrected_peak(text, channel, options.gravity, record);
  remove_recorded_offset(record, false, options);
}

using ReadSeries = EvenSeries (*)(const FileText&, const VolumeChannel&, const ReadOptions&,
                                  std::vector<InputProblem>&);

std::vector<Record> read_uncorrected(const FileText& text, const ReadOptions& options, std::string_view title,
                                     std::size_t fields, ReadSeries read_series) {
  std::vector<InputProblem> problems;
  const std::vector<VolumeChannel> channels = uncorrected_channels(text, fields, problems);
  throw_if_any(std::exchange(problems, {}));
  std::vector<Record> records;
  for (const VolumeChannel& channel : channels) {
    const double factor = stated_factor(text, channel.units, 0, options, problems);
    EvenSeries series = read_series(text, channel, options, problems);
    ReadOptions agreed = options;
    if (fields == 2) agreed.interval.reset();  // resampled to it
    records.push_back(make_channel(text,
                                   {title, component_in(text, channel), channel.units,
                                    std::move(series.values), factor, series.interval, channel.stated + 1},
                                   agreed, std::move(problems)));
    problems.clear();
    finish_uncorrected(text, channel, options, std::move(series), records.back());
  }
  return records;
}

EvenSeries pairs_of(const FileText& text, const VolumeChannel& channel, const ReadOptions& options,
                    std::vector<InputProblem>& problems) {
  return uncorrected_pairs(text, channel, options.interval, problems);
}

// Values alone: the step is the stated duration shared by the points.
EvenSeries values_of(const FileText& text, const VolumeChannel& channel, const ReadOptions&,
                     std::vector<InputProblem>& problems) {
  EvenSeries series;
  series.values = uncorrected_values(text, channel, problems);
  const double duration = number_behind(text.lines[channel.stated], "DURATION").value_or(0.0);
  if (!(duration > 0.0))
    problems.push_back({text.name, channel.stated + 1, "a positive DURATION", fmt::format("{} s", duration)});
  series.interval =
      channel.points > 0 ? plain_interval(duration / static_cast<double>(channel.points), 1e-6) : 0.0;
  return series;
}

// "Band     Station   37.498 N 44.999 E   Altitude 1417m   Azimuth L 106   T 196"
void describe_bhrc_station(std::string_view line, Record& record) {
  Provenance& from = record.provenance;
  from.station = printable(before(line, "Station"));
  from.station_place = place_in(behind(line, "Station"));
  if (from.station_place) from.station_place->height = number_behind(line, "Altitude");
  const std::string axis = record.component.substr(0, 1) + " ";
  if (record.axis == Axis::horizontal) record.azimuth = number_behind(behind(line, "Azimuth"), axis);
}

}  // namespace

bool is_csmip_v2(const FileText& text) {
  const std::string line = first_line(text);
  const bool corrected = contains(line, "CORRECTED ACCELEROGRAM") && !contains(line, "UNCORRECTED") &&
                         !contains(line, "GNS Science");
  return corrected && !mentions_usc(text) && find_line(text, "equally spaced at", 0, 80);
}

std::vector<Record> read_csmip_v2(const FileText& text, const ReadOptions& options) {
  return read_corrected(text, options, "CSMIP V2");
}

bool is_csmip_v1(const FileText& text) {
  const std::string line = first_line(text);
  return contains(line, "UNCORRECTED ACCELEROGRAM DATA") && !contains(line, "GNS Science") &&
         !mentions_usc(text) && !is_renadic(text) &&
         (find_line(text, "NO. OF POINTS", 0, 30) || find_line(text, "equally spaced at", 0, 80));
}

std::vector<Record> read_csmip_v1(const FileText& text, const ReadOptions& options) {
  // Digital recorders need no times: their data stand under a title, as in volume 2.
  if (!corrected_channels(text).empty()) return read_corrected(text, options, "CSMIP V1");
  return read_uncorrected(text, options, "CSMIP V1", 2, pairs_of);
}

bool is_usc(const FileText& text) {
  const std::string line = first_line(text);
  return contains(line, "CORRECTED ACCELEROGRAM") && !contains(line, "SPECTRA") && mentions_usc(text);
}

std::vector<Record> read_usc(const FileText& text, const ReadOptions& options) {
  const bool film = contains(first_line(text), "UNCORRECTED");
  return film ? read_uncorrected(text, options, "USC/Caltech volume 1", 2, pairs_of)
              : read_corrected(text, options, "USC/Caltech volume 2");
}

bool is_renadic(const FileText& text) {
  return find_line(text, "RENADIC", 0, 13) && find_line(text, "NO. OF POINTS", 0, 30);
}

std::vector<Record> read_renadic(const FileText& text, const ReadOptions& options) {
  std::vector<Record> records = read_uncorrected(text, options, "RENADIC V1", 2, pairs_of);
  for (Record& record : records) {
    record.provenance.station = printable(before(line_at(text, 5), "S/N"));
    record.provenance.start_time = iso_time_in(line_at(text, 3), DateOrder::month_day_year, "Z");
  }
  return records;
}

bool is_bhrc(const FileText& text) {
  return contains(first_line(text), "VOL1DS FILE") && !is_renadic(text) &&
         find_line(text, "NO. OF POINTS", 0, 30);
}

std::vector<Record> read_bhrc(const FileText& text, const ReadOptions& options) {
  std::vector<Record> records = read_uncorrected(text, options, "BHRC VOL1DS", 1, values_of);
  const auto line = find_line(text, "Station", 0, 13);
  for (Record& record : records)
    if (line) describe_bhrc_station(line_at(text, *line), record);
  return records;
}

bool is_volume_3(const FileText& text) {
  const std::string line = first_line(text);
  return contains(line, "RESPONSE") && contains(line, "SPECTRA");
}

std::vector<Record> read_volume_3(const FileText& text, const ReadOptions&) {
  throw NotAcceleration(text.name, 1, "an acceleration", "response spectra (volume 3)");
}

}  // namespace dougong::seismic
