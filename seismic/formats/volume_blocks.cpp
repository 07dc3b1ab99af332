#include "seismic/formats/volume_blocks.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "seismic/formats/fixed_fields.h"
#include "seismic/formats/header_text.h"
#include "seismic/formats/samples.h"
#include "seismic/formats/table_rows.h"
#include "seismic/numerics/parse_number.h"

namespace dougong::seismic {
namespace {

constexpr std::size_t lines_of_reals = 7;   // 50, eight a line
constexpr std::size_t longest_header = 60;  // lines from a channel's start to its data

// "POINTS OF ACC DATA EQUALLY SPACED AT .020 SEC.", "points of accel data equally spaced at  .010 sec".
bool is_title(std::string_view line, std::string_view quantity) {
  return contains(line, std::string("points of ").append(quantity)) && contains(line, "equally spaced");
}

// "in cm/sec2. (8f10.6)", "IN UNITS CM/SEC/SEC", "(UNITS: CM/SEC/SEC)".
std::string units_in(std::string_view title) {
  for (const std::string_view words : {"IN UNITS OF", "IN UNITS", "UNITS:", " in "}) {
    const std::string_view rest = behind(title, words);
    if (rest.empty()) continue;
    return printable(rest.substr(0, rest.find_first_of(" .,;()")));
  }
  return {};
}

bool is_numeric(std::string_view line) {
  return !trimmed(line).empty() && line.find_first_not_of(" 0123456789.+-EeDd\t") == std::string_view::npos;
}

// The reals follow the integers, and have points.
std::optional<std::size_t> first_line_of_reals(const FileText& text, std::size_t from) {
  for (std::size_t i = from; i < std::min(text.lines.size(), from + longest_header); ++i)
    if (is_numeric(text.lines[i]) && text.lines[i].find('.') != std::string_view::npos) return i;
  return std::nullopt;
}

// The line behind the data, and behind the mark "/&" that ends a channel in most of these files.
std::size_t end_of_channel(const FileText& text, const VolumeChannel& channel, std::size_t fields) {
  const auto format = field_format_of_line(line_at(text, channel.data));
  const std::size_t per_line = format ? format->per_line : 1;
  const std::size_t lines = std::min((channel.points * fields + per_line - 1) / per_line, text.lines.size());
  const std::size_t end = channel.data + lines;
  return line_at(text, end).starts_with("/&") ? end + 1 : end;
}

std::optional<FieldFormat> first_line_format(const FileText& text, const VolumeChannel& channel,
                                             std::vector<InputProblem>& problems) {
  const auto format = field_format_of_line(line_at(text, channel.data));
  if (!format)
    problems.push_back({text.name, channel.data + 1, "data in fields of one width",
                        in_quotes(line_at(text, channel.data).substr(0, 60))});
  return format;
}

}  // namespace

std::vector<VolumeChannel> corrected_channels(const FileText& text) {
  std::vector<VolumeChannel> channels;
  std::size_t start = 0;
  for (std::size_t i = 0; i < text.lines.size(); ++i) {
    if (text.lines[i].starts_with("/&")) start = i + 1;
    if (!is_title(text.lines[i], "acc")) continue;
    VolumeChannel channel;
    channel.start = start, channel.stated = i, channel.data = i + 1;
    channel.points = sample_count(leading_number(text.lines[i]).value_or(0.0));
    channel.interval = number_behind(text.lines[i], "spaced at").value_or(0.0);
    channel.units = units_in(text.lines[i]);
    channels.push_back(std::move(channel));
  }
  return channels;
}

std::optional<std::size_t> unfinished_header(const FileText& text, const VolumeChannel& last) {
  for (std::size_t i = last.data; i < text.lines.size(); ++i) {
    if (!text.lines[i].starts_with("/&")) continue;
    return find_line(text, "CORRECTED ACCELEROGRAM", i + 1, text.lines.size());
  }
  return std::nullopt;
}

bool ends_within_a_block(const FileText& text) {
  for (std::size_t i = text.lines.size(); i-- > 0;) {
    if (!is_title(text.lines[i], "")) continue;
    const FieldFormat format = field_format_in(text.lines[i]).value_or(FieldFormat{8, 10});
    const std::size_t points = sample_count(leading_number(text.lines[i]).value_or(0.0));
    return text.lines.size() - i - 1 < (points + format.per_line - 1) / format.per_line;
  }
  return false;
}

std::vector<VolumeChannel> uncorrected_channels(const FileText& text, std::size_t fields,
                                                std::vector<InputProblem>& problems) {
  std::vector<VolumeChannel> channels;
  for (std::size_t start = 0; start < text.lines.size();) {
    const auto stated = find_line(text, "NO. OF POINTS", start, start + longest_header);
    // Blank lines and remarks may follow the last channel.
    if (!stated && !channels.empty()) return channels;
    const auto reals = stated ? first_line_of_reals(text, *stated) : std::nullopt;
    if (!reals) {
      problems.push_back({text.name, stated.value_or(start) + 1,
                          "a line \"NO. OF POINTS\" with 100 integers and 50 reals below it", "none"});
      return channels;
    }
    const double points = number_behind(text.lines[*stated], "NO. OF POINTS").value_or(0.0);
    channels.push_back({start, *stated, *reals + lines_of_reals, sample_count(points), 0.0, "g/10"});
    start = end_of_channel(text, channels.back(), fields);
  }
  return channels;
}

std::vector<double> corrected_values(const FileText& text, const VolumeChannel& channel,
                                     std::vector<InputProblem>& problems) {
  const FieldFormat format = field_format_in(text.lines[channel.stated]).value_or(FieldFormat{8, 10});
  std::size_t line = channel.data;
  return read_block(text, line, channel.points, format, problems);
}

EvenSeries uncorrected_pairs(const FileText& text, const VolumeChannel& channel,
                             std::optional<double> interval, std::vector<InputProblem>& problems) {
  const auto format = first_line_format(text, channel, problems);
  if (!format) return {};
  std::size_t line = channel.data;
  auto columns = columns_of(read_block(text, line, 2 * channel.points, *format, problems), 2);
  if (!problems.empty() || columns[0].size() < 2) return {};
  if (const auto back = first_time_back(columns[0])) {
    problems.push_back({text.name, channel.data + 1 + 2 * *back / format->per_line, "times that increase",
                        fmt::format("{:.6g} s after {:.6g} s", columns[0][*back], columns[0][*back - 1])});
    return {};
  }
  auto series = to_even_steps(columns[0], std::move(columns[1]), interval);
  if (series) return *std::move(series);
  problems.push_back(
      {text.name, channel.data + 1, "a time step for times this uneven (option dt, in s)", "none"});
  return {};
}

std::vector<double> uncorrected_values(const FileText& text, const VolumeChannel& channel,
                                       std::vector<InputProblem>& problems) {
  const auto format = first_line_format(text, channel, problems);
  std::size_t line = channel.data;
  return format ? read_block(text, line, channel.points, *format, problems) : std::vector<double>{};
}

}  // namespace dougong::seismic
