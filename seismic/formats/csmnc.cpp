#include "seismic/formats/csmnc.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <regex>
#include <utility>

#include "seismic/formats/samples.h"
#include "seismic/measures/peaks.h"
#include "seismic/numerics/parse_number.h"
#include "seismic/units.h"

namespace dougong::seismic {
namespace {

constexpr std::size_t longest_header = 30;  // lines; 16 in the known form

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

// The text behind a label, on the line that starts with it.
std::string labelled(const FileText& text, std::string_view label) {
  for (std::size_t i = 0; i < std::min(text.lines.size(), longest_header); ++i) {
    const auto at = text.lines[i].find(label);
    if (at != std::string_view::npos) return printable(trimmed(text.lines[i].substr(at + label.size())));
  }
  return {};
}

std::string first_word(const std::string& text) {
  return text.substr(0, text.find(' '));
}

void describe_source(const FileText& text, const Header& header, Record& record) {
  Provenance& from = record.provenance;
  for (std::size_t i = 0; i < header.first; ++i) {
    const std::string line = printable(trimmed(text.lines[i]));
    if (!line.empty()) from.header.emplace_back(fmt::format("header line {}", i + 1), line);
  }
  from.event = text.lines.size() > 2 ? printable(trimmed(text.lines[2])) : "";
  from.station = first_word(labelled(text, "STATION:"));
  from.component = labelled(text, "COMP.");
  from.units = labelled(text, "UNIT:");
  record.component = from.component;
  record.axis = axis_of(record.component);
}

void check_peak(const FileText& text, Record& record) {
  const auto stated = parse_number(first_word(labelled(text, "PEAK VALUE:")));
  if (!stated) return;
  const double found = peak(record.acceleration, record.interval).value, asked = std::abs(*stated) * 0.01;
  if (std::abs(found - asked) <= 1e-4 * asked + 1e-5) return;
  record.warnings.push_back(
      fmt::format("the header's peak is {:.6g} m/s2, the samples peak at {:.6g} m/s2", asked, found));
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
  const auto factor = acceleration_unit(units, options.gravity);
  if (!factor)
    problems.push_back({text.name, 0, "a unit of acceleration behind \"UNIT:\"", in_quotes(units)});
  check_stated_units(text, units, options, problems);
  auto values = collect_numbers(text, found->first, text.lines.size(), problems);
  check_count(text, found->points, found->line + 1, values, problems, warnings);
  check_series(text, found->points, found->interval, found->line + 1, options, problems);
  throw_if_any(std::move(problems));
  Record record = make_record(text, "CSMNC uncorrected", std::move(values), *factor, found->interval);
  record.warnings = std::move(warnings);
  describe_source(text, *found, record);
  check_peak(text, record);
  remove_recorded_offset(record, false, options);
  return record;
}

}  // namespace dougong::seismic
