#include "seismic/formats/samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "seismic/measures/peaks.h"
#include "seismic/numerics/parse_number.h"
#include "seismic/orientation.h"
#include "seismic/units.h"

namespace dougong::seismic {
namespace {

// No accelerograph records outside; a step beyond is a damaged header.
constexpr double shortest_interval = 1e-5, longest_interval = 10.0;  // s

// A file of another kind may hold millions of bad fields: the first ones say enough.
constexpr std::size_t most_problems = 100;
constexpr std::size_t longest_quote = 60;

}  // namespace

std::vector<double> collect_numbers(const FileText& text, std::size_t first, std::size_t last,
                                    std::vector<InputProblem>& problems) {
  std::vector<double> values;
  const std::size_t end = std::min(last, text.lines.size());
  // Fields of eight characters and more are the rule; a body of shorter ones grows the array once.
  if (first < end) values.reserve(text.bytes.size() / 8);
  for (std::size_t i = first; i < end; ++i) {
    const std::string_view culprit = append_numbers(text.lines[i], values);
    if (culprit.empty()) continue;
    problems.push_back({text.name, i + 1, "finite numbers", in_quotes(culprit.substr(0, longest_quote))});
    if (problems.size() >= most_problems) break;
  }
  values.shrink_to_fit();
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

double stated_factor(const FileText& text, std::string_view stated, std::size_t line,
                     const ReadOptions& options, std::vector<InputProblem>& problems) {
  const auto factor = acceleration_unit(stated, options.gravity);
  if (!factor) problems.push_back({text.name, line, "a unit of acceleration", in_quotes(stated)});
  check_stated_units(text, stated, options, problems);
  return factor.value_or(1.0);
}

double declared_factor(const FileText& text, const std::string& hint, const ReadOptions& options,
                       std::vector<InputProblem>& problems) {
  const auto wanted = fmt::format("the units of the values: option units = {}", known_units());
  if (!options.units) {
    problems.push_back({text.name, 0, wanted, hint.empty() ? "none" : "none (" + hint + ")"});
    return 1.0;
  }
  if (is_counts(*options.units)) {
    if (options.count_scale) return *options.count_scale;
    problems.push_back(
        {text.name, 0, "the scale of the counts, such as 3920(gal)/6182761 (option scale)", "none"});
    return 1.0;
  }
  const auto factor = acceleration_unit(*options.units, options.gravity);
  if (!factor) problems.push_back({text.name, 0, wanted, in_quotes(*options.units)});
  return factor.value_or(1.0);
}

Record make_record(const FileText& text, std::string_view format, std::vector<double> values, double factor,
                   double interval, std::string units) {
  Record record;
  bool finite = true;
  for (double& value : values) {
    value *= factor;
    finite = finite && std::isfinite(value);
  }
  if (!finite) throw InputError(text.name, 0, "accelerations that are finite", "a value beyond any number");
  record.acceleration = std::move(values);
  record.interval = interval;
  record.provenance.format = format;
  record.provenance.file = text.name;
  record.provenance.sha256 = text.sha256;
  record.provenance.units = std::move(units);
  record.provenance.scale = fmt::format("1 unit of the file = {:.10g} m/s2", factor);
  return record;
}

Record make_channel(const FileText& text, ChannelSamples samples, const ReadOptions& options,
                    std::vector<InputProblem>&& problems) {
  if (problems.empty())
    check_series(text, samples.values.size(), samples.interval, samples.line, options, problems);
  throw_if_any(std::move(problems));
  Record record = make_record(text, samples.format, std::move(samples.values), samples.factor,
                              samples.interval, std::move(samples.units));
  name_component(record, std::move(samples.component));
  return record;
}

void name_component(Record& record, std::string component) {
  record.provenance.component = component;
  record.component = std::move(component);
  record.axis = axis_of(record.component);
  record.azimuth = azimuth_of(record.component);
}

namespace {

// A few samples say nothing of an offset.
void warn_of_offset(Record& record, double offset) {
  constexpr std::size_t fewest = 100;
  constexpr double worth_a_word = 0.1;  // of the peak
  const double top = peak(record.acceleration, record.interval).value;
  if (record.acceleration.size() < fewest || std::abs(offset) <= worth_a_word * top) return;
  record.warnings.push_back(
      fmt::format("the mean of {} is {:.3g} m/s2, {:.0f} % of its peak: an offset, left as it is",
                  record.component, offset, 100.0 * std::abs(offset) / top));
}

}  // namespace

void remove_recorded_offset(Record& record, bool by_default, const ReadOptions& options) {
  const double offset = mean(record.acceleration);
  if (!options.remove_mean.value_or(by_default)) return warn_of_offset(record, offset);
  for (double& a : record.acceleration) a -= offset;
  const char* unit = record.dimensionless ? "" : " m/s2";
  record.processing.push_back(
      fmt::format("read: {}: whole-record mean of {:.6g}{} removed", record.component, offset, unit));
}

void check_stated_peak(Record& record, double stated, double printed, bool without_mean) {
  const double offset = without_mean ? mean(record.acceleration) : 0.0;
  double found = 0.0;
  for (const double a : record.acceleration) found = std::max(found, std::abs(a - offset));
  const double asked = std::abs(stated);
  record.provenance.stated_peak = asked;
  if (std::abs(found - asked) <= 1e-4 * asked + printed) return;
  record.warnings.push_back(
      fmt::format("the header states a peak of {:.6g} m/s2, the samples{} peak at {:.6g} m/s2", asked,
                  without_mean ? " without their mean" : "", found));
}

}  // namespace dougong::seismic
