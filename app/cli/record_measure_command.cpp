#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/record_output.h"
#include "app/cli/record_tools.h"
#include "app/report/csv.h"
#include "app/report/safe_file.h"
#include "app/report/text.h"
#include "seismic/measures/instrumental_intensity.h"
#include "seismic/measures/rotated.h"

namespace dougong::app {
namespace {

using nlohmann::ordered_json;
using seismic::Measure;

struct Choice {
  seismic::MeasureOptions options;
  double period = 0.0;  // s; 0 for none
};

Choice choice_of(const MeasureOptions& o) {
  Choice c;
  c.options.damping_ratio = damping_of(o.damping);
  c.options.threshold = quantity_or(o.threshold, Dimension::acceleration, "--threshold", c.options.threshold);
  c.options.cav_threshold =
      quantity_or(o.standard_threshold, Dimension::acceleration, "--cav-threshold", c.options.cav_threshold);
  c.period = quantity_or(o.period, Dimension::time, "--period", 0.0);
  if (!o.period.empty() && !(c.period >= 1e-3 && c.period <= 30.0))
    refuse("--period " + o.period, "expected a period from 1 ms to 30 s");
  return c;
}

std::vector<Measure> measures_of(const std::vector<double>& a, double interval, const Choice& c) {
  std::vector<Measure> out = seismic::measures(a, interval, c.options);
  if (c.period <= 0.0) return out;
  const double damping = c.options.damping_ratio;
  out.push_back({"PSa(T1)", seismic::spectral_point(a, interval, c.period, {damping, 1}).pseudo_acceleration,
                 "m/s2", fmt::format("at {:g} s", c.period)});
  out.push_back({"Sa average",
                 seismic::average_spectral_acceleration(
                     a, interval, seismic::average_acceleration_periods(c.period), damping),
                 "m/s2", "geometric mean of PSa at ten periods from 0.2 T1 to 3 T1"});
  return out;
}

std::vector<Measure> pair_measures(const seismic::Record& first, const seismic::Record& second) {
  const seismic::RotatedPeaks p = seismic::rotated_peaks(first.acceleration, second.acceleration);
  return {{"PGA RotD00", p.rotd00, "m/s2", "least over all angles"},
          {"PGA RotD50", p.rotd50, "m/s2", "median over all angles"},
          {"PGA RotD100", p.rotd100, "m/s2",
           fmt::format("greatest, at {:g} degrees from {} towards {}", p.angle100, first.component,
                       second.component)},
          {"PGA geometric mean", p.geometric_mean, "m/s2", "of the two components"}};
}

std::vector<Measure> station_measures(const seismic::RecordSet& set) {
  seismic::Components all;
  double pga = 0.0, pgv = 0.0;
  const double interval = set.horizontal().interval;
  for (const seismic::Record& r : set.components) {
    all.push_back(r.acceleration);
    if (r.axis == seismic::Axis::vertical) continue;
    const seismic::RecordInfo info = seismic::describe(r);
    pga = std::max(pga, info.pga), pgv = std::max(pgv, info.pgv);
  }
  const std::string of = fmt::format("of {} component{}", all.size(), all.size() == 1 ? "" : "s");
  const seismic::JmaIntensity jma = seismic::jma_intensity(all, interval);
  const seismic::ChinaIntensity china = seismic::china_intensity(all, interval);
  return {
      {"JMA", jma.reported, "-",
       fmt::format("class {}, {:.3f} before rounding, {}", jma.scale, jma.value, of)},
      {"GB/T 17742-2020", china.value, "-",
       fmt::format("I_A {:.2f}, I_V {:.2f}, 0.1-10 Hz, {}", china.by_acceleration, china.by_velocity, of)},
      {"MMI by PGA", seismic::mmi_by_acceleration(pga), "-", "Worden et al. 2012, larger horizontal"},
      {"MMI by PGV", seismic::mmi_by_velocity(pgv), "-", "the same; PGV with the mean removed"}};
}

struct Group {
  std::string name;
  std::vector<Measure> measures;
};

std::vector<Group> groups_of(const MeasureOptions& o, const Choice& choice) {
  if (o.source.condition || !o.source.set.empty()) {
    const SourceMotion m = motion_of(o.source);
    return {{m.title + ", conditioned", measures_of(m.acceleration, m.interval, choice)}};
  }
  const seismic::RecordSet set = read_source(o.source);
  std::vector<Group> groups;
  std::vector<const seismic::Record*> horizontal;
  for (const seismic::Record& r : set.components) {
    if (r.axis == seismic::Axis::horizontal) horizontal.push_back(&r);
    groups.push_back({title_of(r), measures_of(r.acceleration, r.interval, choice)});
  }
  if (set.horizontal().dimensionless) return groups;
  if (horizontal.size() == 2)
    groups.push_back({"horizontal pair", pair_measures(*horizontal[0], *horizontal[1])});
  groups.push_back({"instrumental intensity", station_measures(set)});
  return groups;
}

void print_group(const Group& group) {
  fmt::print("{}\n", group.name);
  for (const Measure& m : group.measures)
    fmt::print("  {:<20}{:>14.7g} {:<6}{}\n", m.name, m.value, m.unit, m.meaning);
}

std::string csv_of_groups(const std::vector<Group>& groups) {
  std::string out = "of,measure,value,unit,meaning\n";
  for (const Group& group : groups)
    for (const Measure& m : group.measures)
      out += fmt::format("{},{},{},{},{}\n", csv_text(group.name), csv_text(m.name), exact(m.value), m.unit,
                         csv_text(m.meaning));
  return out;
}

}  // namespace

int record_measure_command(const MeasureOptions& o) {
  check_new_file(o.csv, o.force);
  const std::vector<Group> groups = groups_of(o, choice_of(o));
  ordered_json json = ordered_json::array();
  for (const Group& group : groups) {
    if (!o.json) print_group(group);
    ordered_json values = ordered_json::array();
    for (const Measure& m : group.measures)
      values.push_back({{"name", m.name}, {"value", m.value}, {"unit", m.unit}, {"meaning", m.meaning}});
    json.push_back({{"of", group.name}, {"measures", values}});
  }
  if (o.json) print_json({{"groups", json}});
  if (!o.csv.empty()) write_file(o.csv, csv_of_groups(groups));
  return exit_survived;
}

}  // namespace dougong::app
