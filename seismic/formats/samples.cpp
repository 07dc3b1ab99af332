#include "seismic/formats/samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "seismic/measures/peaks.h"
#include "seismic/numerics/parse_number.h"
#include "seismic/units.h"

namespace dougong::seismic {
namespace {

// No accelerograph records outside; a step beyond is a damaged header.
constexpr double shortest_interval = 1e-5, longest_interval = 10.0;  // s

}  // namespace

std::vector<double> collect_numbers(const FileText& text, std::size_t first, std::size_t last,
                                    std::vector<InputProblem>& problems) {
  std::vector<double> values;
  for (std::size_t i = first; i < last && i < text.lines.size(); ++i) {
    const NumberLine line = parse_numbers(text.lines[i]);
    if (!line.culprit.empty()) {
      problems.push_back({text.name, i + 1, "finite numbers", in_quotes(line.culprit)});
    }
    values.insert(values.end(), line.values.begin(), line.values.end());
  }
  return values;
}

void check_count(const FileText& text, std::size_t stated, std::size_t line, std::vector<double>& values,
                 std::vector<InputProblem>& problems, std::vector<std::string>& warnings) {
  if (values.size() < stated) {
    problems.push_back({text.name, line, fmt::format("{} values, as the header states", stated),
                        fmt::format("{} (the file is truncated)", values.size())});
  }
  if (values.size() > stated) {
    warnings.push_back(
        fmt::format("the header states {} values, the file holds {}: the last {} were left out", stated,
                    values.size(), values.size() - stated));
    values.resize(stated);
  }
}

void check_series(const FileText& text, std::size_t samples, double interval, std::size_t line,
                  const ReadOptions& options, std::vector<InputProblem>& problems) {
  if (samples < 2) {
    problems.push_back({text.name, line, "at least 2 samples", samples ? "one sample" : "none"});
  }
  if (!(interval > 0.0) || !std::isfinite(interval)) {
    problems.push_back({text.name, line, "a positive time step", fmt::format("{} s", interval)});
  }
  if (interval > 0.0 && (interval < shortest_interval || interval > longest_interval)) {
    problems.push_back({text.name, line,
                        fmt::format("a time step from {:g} s to {:g} s", shortest_interval, longest_interval),
                        fmt::format("{:g} s", interval)});
  }
  if (options.interval && std::abs(*options.interval - interval) > 1e-6 * std::abs(interval)) {
    problems.push_back({text.name, line,
                        fmt::format("the time step given, {} s (option dt)", *options.interval),
                        fmt::format("{} s", interval)});
  }
}

void check_stated_units(const FileText& text, std::string_view stated, const ReadOptions& options,
                        std::vector<InputProblem>& problems) {
  if (!options.units) return;
  const auto asked = acceleration_unit(*options.units), own = acceleration_unit(stated);
  if (asked && own && *asked == *own) return;
  if (is_counts(*options.units) && is_counts(stated)) return;
  problems.push_back({text.name, 0,
                      fmt::format("the file's own units, {} (leave out the option units)", stated),
                      *options.units});
}

std::size_t sample_count(double stated) {
  constexpr double most = 1e9;  // beyond any recording; a larger number is a damaged header
  return stated > 0.0 ? static_cast<std::size_t>(std::min(stated, most)) : 0;
}

void throw_if_any(std::vector<InputProblem>&& problems) {
  if (!problems.empty()) throw InputError(std::move(problems));
}

Record make_record(const FileText& text, std::string_view format, std::vector<double> values, double factor,
                   double interval) {
  Record record;
  for (double& value : values) value *= factor;
  record.acceleration = std::move(values);
  record.interval = interval;
  record.provenance.format = format;
  record.provenance.file = text.name;
  record.provenance.sha256 = text.sha256;
  return record;
}

void remove_recorded_offset(Record& record, bool by_default, const ReadOptions& options) {
  if (!options.remove_mean.value_or(by_default)) return;
  const double offset = mean(record.acceleration);
  for (double& a : record.acceleration) a -= offset;
  const char* unit = record.dimensionless ? "" : " m/s2";
  record.processing.push_back(
      fmt::format("read: {}: whole-record mean of {:.6g}{} removed", record.component, offset, unit));
}

}  // namespace dougong::seismic
