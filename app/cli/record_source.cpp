#include "app/cli/record_source.h"

#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/record_choice.h"

namespace dougong::app {
namespace {

constexpr double shortest_period = 1e-3, longest_period = 100.0;  // s
constexpr std::size_t most_periods = 100000;

std::vector<Override> overrides_of(const RecordSource& source) {
  std::vector<Override> overrides{record_override(source.record)};
  const auto add = [&](const char* key, const std::string& value, const char* flag) {
    if (!value.empty()) overrides.push_back({key, value, flag});
  };
  add("record.component", source.component, "--component");
  add("record.units", source.units, "--units");
  add("record.interval", source.interval, "--interval");
  add("record.count_scale", source.count_scale, "--count-scale");
  for (const std::string& text : source.set) overrides.push_back(parse_override(text));
  return overrides;
}

double period_of(const std::string& text, const char* option) {
  const double period = quantity_of(text, Dimension::time, option);
  if (!(period >= shortest_period && period <= longest_period))
    refuse(std::string(option) + " " + text, "expected a period from 1 ms to 100 s");
  return period;
}

}  // namespace

void refuse(const std::string& where, const std::string& message) {
  throw ScenarioError({LocatedMessage{where, message}});
}

Scenario scenario_of(const RecordSource& source) {
  return scenario_from(overrides_of(source));
}

seismic::RecordSet read_source(const RecordSource& source) {
  return read_scenario_record(scenario_of(source).record, records_directory());
}

std::string title_of(const seismic::Record& record) {
  std::string title;
  for (const std::string& part : {record.provenance.event, record.provenance.station, record.component})
    if (!part.empty()) title += (title.empty() ? "" : " / ") + part;
  return title.empty() ? record.provenance.file : title;
}

SourceMotion motion_of(const RecordSource& source) {
  if (source.condition || !source.set.empty()) {
    const MotionInput input = make_motion(scenario_of(source), records_directory());
    return {input.conditioned.title,
            "conditioned",
            input.conditioned.horizontal,
            input.conditioned.interval,
            false,
            input.records.horizontal().provenance.synthetic,
            input.conditioned.processing,
            input.conditioned.warnings};
  }
  const seismic::RecordSet set = read_source(source);
  const seismic::Record& record = set.horizontal();
  SourceMotion motion{title_of(record),  "as read, mean removed", record.acceleration,
                      record.interval,   record.dimensionless,    record.provenance.synthetic,
                      record.processing, record.warnings};
  const double offset = seismic::mean(motion.acceleration);
  for (double& a : motion.acceleration) a -= offset;
  return motion;
}

double quantity_of(const std::string& text, Dimension dimension, const char* option) {
  try {
    return parse_quantity(text, dimension);
  } catch (const QuantityError& error) {
    refuse(std::string(option) + " " + text, error.what());
  }
}

double quantity_or(const std::string& text, Dimension dimension, const char* option, double otherwise) {
  return text.empty() ? otherwise : quantity_of(text, dimension, option);
}

std::pair<const seismic::Record*, const seismic::Record*> horizontal_pair(const seismic::RecordSet& set) {
  std::vector<const seismic::Record*> pair;
  for (const seismic::Record& r : set.components)
    if (r.axis == seismic::Axis::horizontal) pair.push_back(&r);
  if (pair.size() != 2)
    throw seismic::InputError(set.horizontal().provenance.file, 0,
                              "two horizontal components beside each other", std::to_string(pair.size()));
  return {pair[0], pair[1]};
}

double damping_of(const std::string& text) {
  const double damping = quantity_or(text, Dimension::ratio, "--damping", 0.05);
  if (!(damping >= 0.0 && damping < 1.0)) refuse("--damping " + text, "expected a ratio from 0 to 1");
  return damping;
}

std::vector<double> periods_of(const PeriodChoice& choice, double from, double to, std::size_t count) {
  std::vector<double> periods;
  for (const std::string& text : choice.periods) periods.push_back(period_of(text, "--periods"));
  if (!periods.empty()) return periods;
  if (!choice.from.empty()) from = period_of(choice.from, "--from");
  if (!choice.to.empty()) to = period_of(choice.to, "--to");
  if (choice.count > 0) count = choice.count;
  if (!(to > from))
    refuse("--to", fmt::format("expected a period above --from, {:g} s, found {:g} s", from, to));
  if (count < 2 || count > most_periods)
    refuse("--count", fmt::format("expected 2 to {} periods, found {}", most_periods, count));
  return seismic::log_spaced_periods(from, to, count);
}

}  // namespace dougong::app
