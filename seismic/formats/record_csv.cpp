#include "seismic/formats/record_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "seismic/formats/header_text.h"
#include "seismic/formats/samples.h"
#include "seismic/formats/table_rows.h"
#include "seismic/numerics/parse_number.h"

namespace dougong::seismic {
namespace {

constexpr std::string_view first_line = "# dougong record";
constexpr std::size_t longest_header = 100;  // lines

std::optional<std::size_t> titles_line(const FileText& text) {
  for (std::size_t i = 1; i < std::min(text.lines.size(), longest_header); ++i) {
    if (line_at(text, i).starts_with("time (s),")) return i;
    if (!line_at(text, i).starts_with("#")) return std::nullopt;
  }
  return std::nullopt;
}

// "NS2 (m/s2)" -> NS2, m/s2.
struct Title {
  std::string component, unit;
};

std::vector<Title> titles_in(std::string_view line) {
  std::vector<Title> titles;
  for (line.remove_prefix(line.find(',')); !line.empty();) {
    line.remove_prefix(1);
    const auto comma = std::min(line.find(','), line.size());
    const std::string_view field = line.substr(0, comma);
    const auto open = std::min(field.rfind(" ("), field.size());
    const std::string_view unit = behind(field.substr(open), "(");
    titles.push_back({printable(trimmed(field.substr(0, open))), printable(before(unit, ")"))});
    line.remove_prefix(comma);
  }
  return titles;
}

std::string fact(const FileText& text, std::size_t titles, const std::string& name) {
  return value_behind(text, "# " + name + ":", 0, titles);
}

void describe_source(const FileText& text, std::size_t titles, Record& record) {
  Provenance& from = record.provenance;
  keep_header(text, 0, titles, from);
  from.event = fact(text, titles, "event");
  from.station = fact(text, titles, "station");
  from.sensor = fact(text, titles, "sensor");
  from.start_time = fact(text, titles, "start");
  from.treatment = fact(text, titles, "treatment");
  from.processed = fact(text, titles, "processed by its publisher") == "yes";
  record.azimuth = parse_number(fact(text, titles, "azimuth of " + record.component));
  if (fact(text, titles, "vertical") == record.component) record.axis = Axis::vertical;
}

// One line, whatever the text held.
std::string plain(const std::string& text) {
  std::string out = printable(text);
  std::replace(out.begin(), out.end(), ',', ';');
  return out;
}

void write_facts(std::span<const Record> components, std::string& out) {
  const Provenance& from = components.front().provenance;
  const auto line = [&](const std::string& name, const std::string& value) {
    if (!value.empty()) out += fmt::format("# {}: {}\n", name, printable(value));
  };
  line("event", from.event);
  line("station", from.station);
  line("sensor", from.sensor);
  line("start", from.start_time);
  line("treatment", from.treatment);
  line("processed by its publisher", from.processed ? "yes" : "no");
  line("source", fmt::format("{}, {}, SHA-256 {}", from.format, from.file, from.sha256));
  for (const Record& record : components) {
    if (record.azimuth) line("azimuth of " + plain(record.component), fmt::format("{}", *record.azimuth));
    if (record.axis == Axis::vertical) line("vertical", plain(record.component));
    for (const std::string& step : record.processing) line("done", step);
  }
  line("interval (s)", fmt::format("{}", components.front().interval));
}

}  // namespace

bool is_record_csv(const FileText& text) {
  return line_at(text, 0).starts_with(first_line) && titles_line(text);
}

std::vector<Record> read_record_csv(const FileText& text, const ReadOptions& options) {
  const auto titles = titles_line(text);
  if (!titles) throw InputError(text.name, 0, "a line of titles \"time (s),...\"", "none");
  std::vector<InputProblem> problems;
  const double interval = parse_number(fact(text, *titles, "interval (s)")).value_or(0.0);
  const std::vector<Title> names = titles_in(text.lines[*titles]);
  auto columns = read_table_rows(text, *titles + 1, names.size() + 1, problems);
  std::vector<Record> records;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double factor = stated_factor(text, names[i].unit, *titles + 1, options, problems);
    records.push_back(make_channel(text,
                                   {"Dougong CSV", names[i].component, names[i].unit,
                                    std::move(columns[i + 1]), factor, interval, *titles + 1},
                                   options, std::move(problems)));
    problems.clear();
    describe_source(text, *titles, records.back());
    remove_recorded_offset(records.back(), false, options);
  }
  return records;
}

std::string write_record_csv(std::span<const Record> components) {
  std::string out = std::string(first_line) + "\n";
  write_facts(components, out);
  out += "time (s)";
  for (const Record& record : components) out += fmt::format(",{} (m/s2)", plain(record.component));
  out += '\n';
  const double interval = components.front().interval;
  for (std::size_t k = 0; k < components.front().acceleration.size(); ++k) {
    fmt::format_to(std::back_inserter(out), "{:.10g}", interval * static_cast<double>(k));
    for (const Record& record : components)
      fmt::format_to(std::back_inserter(out), ",{}", record.acceleration[k] + 0.0);  // no "-0"
    out += '\n';
  }
  return out;
}

}  // namespace dougong::seismic
