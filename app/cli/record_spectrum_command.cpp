#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/motion_file.h"
#include "app/cli/record_output.h"
#include "app/cli/record_tools.h"
#include "app/report/record_figures.h"
#include "app/report/safe_file.h"
#include "app/study/target_choice.h"
#include "seismic/measures/bilinear_oscillator.h"
#include "seismic/measures/fourier_spectrum.h"
#include "seismic/measures/rotated.h"

namespace dougong::app {
namespace {

using nlohmann::ordered_json;

// One table whatever the kind: columns with their names, the first is the period or frequency.
struct Table {
  std::string heading;
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;
  std::vector<std::string> warnings;
  std::vector<SpectrumCurve> curves;

  void add(const std::string& name, std::vector<double> values) {
    names.push_back(name);
    columns.push_back(std::move(values));
  }
};

template <class Row, class Value>
std::vector<double> column(const std::vector<Row>& rows, Value value) {
  std::vector<double> out;
  for (const Row& row : rows) out.push_back(std::invoke(value, row));
  return out;
}

Table elastic_table(const SourceMotion& m, const std::vector<double>& periods, double damping,
                    bool continuous) {
  const auto s = seismic::response_spectrum(m.acceleration, m.interval, periods, {damping, 1, continuous});
  using P = seismic::SpectralPoint;
  Table t;
  t.heading = fmt::format("elastic, {:g} % damping, peaks {}", 100.0 * damping,
                          continuous ? "wherever they fall" : "at the samples");
  t.add("period_s", periods);
  t.add("sd_m", column(s, &P::displacement));
  t.add("sv_m_s", column(s, &P::velocity));
  t.add("sa_m_s2", column(s, &P::acceleration));
  t.add("psv_m_s", column(s, &P::pseudo_velocity));
  t.add("psa_m_s2", column(s, &P::pseudo_acceleration));
  t.curves.push_back({"PSa", periods, t.columns.back()});
  return t;
}

Table inelastic_table(const SourceMotion& m, const std::vector<double>& periods, double damping,
                      double ductility, double hardening) {
  const auto s = seismic::constant_ductility_spectrum(m.acceleration, m.interval, periods, ductility, damping,
                                                      hardening);
  using P = seismic::DuctilityPoint;
  Table t;
  t.heading = fmt::format("bilinear, constant ductility {:g}, hardening {:g}, {:g} % damping", ductility,
                          hardening, 100.0 * damping);
  t.add("period_s", periods);
  t.add("ductility", column(s, &P::ductility));
  t.add("yield_displacement_m", column(s, &P::yield_displacement));
  t.add("yield_acceleration_m_s2", column(s, &P::yield_acceleration));
  t.add("strength_reduction", column(s, &P::strength_reduction));
  t.add("inelastic_over_elastic", column(s, &P::inelastic_ratio));
  t.curves.push_back({fmt::format("yield, μ = {:g}", ductility), periods, t.columns[3]});
  t.curves.push_back(
      {"elastic PSa", periods, seismic::pseudo_accelerations(m.acceleration, m.interval, periods, damping)});
  return t;
}

Table rotated_table(const RecordSource& source, const std::vector<double>& periods, double damping) {
  if (source.condition || !source.set.empty())
    refuse("--rotated", "of the pair as read; leave out --condition and --set");
  const seismic::RecordSet set = read_source(source);
  const auto [first, second] = horizontal_pair(set);
  const auto s =
      seismic::rotated_spectrum(first->acceleration, second->acceleration, first->interval, periods, damping);
  using P = seismic::RotatedPeaks;
  Table t;
  t.heading = fmt::format("PSa of {} and {} at all angles, {:g} % damping", first->component,
                          second->component, 100.0 * damping);
  t.add("period_s", periods);
  t.add("rotd00_m_s2", column(s, &P::rotd00));
  t.add("rotd50_m_s2", column(s, &P::rotd50));
  t.add("rotd100_m_s2", column(s, &P::rotd100));
  t.add("geometric_mean_m_s2", column(s, &P::geometric_mean));
  t.add("angle100_deg", column(s, &P::angle100));
  for (std::size_t i = 1; i <= 3; ++i)
    t.curves.push_back({i == 1 ? "RotD00" : i == 2 ? "RotD50" : "RotD100", periods, t.columns[i]});
  return t;
}

// At the periods' frequencies, ascending.
Table fourier_table(const SourceMotion& m, const std::vector<double>& periods, double bandwidth) {
  std::vector<double> frequencies;
  for (auto period = periods.rbegin(); period != periods.rend(); ++period)
    if (1.0 / *period <= 0.5 / m.interval) frequencies.push_back(1.0 / *period);
  const auto spectrum = seismic::fourier_spectrum(m.acceleration, m.interval);
  Table t;
  t.heading = fmt::format("Fourier amplitude, Konno-Ohmachi bandwidth {:g}", bandwidth);
  t.add("frequency_hz", frequencies);
  std::vector<double> raw;
  for (const double f : frequencies) raw.push_back(seismic::fourier_amplitude(m.acceleration, m.interval, f));
  t.add("amplitude_m_s", std::move(raw));
  t.add("smoothed_m_s", seismic::konno_ohmachi(spectrum, frequencies, bandwidth));
  return t;
}

double positive(const std::string& text, const char* option, double otherwise, double least) {
  const double value = quantity_or(text, Dimension::ratio, option, otherwise);
  if (!(value >= least))
    refuse(std::string(option) + " " + text, fmt::format("expected {:g} or more", least));
  return value;
}

Table table_of(const SpectrumOptions& o, const SourceMotion& m, const std::vector<double>& periods) {
  const double damping = damping_of(o.damping);
  if (o.rotated) return rotated_table(o.source, periods, damping);
  if (o.fourier) return fourier_table(m, periods, positive(o.smoothing, "--smoothing", 40.0, 1.0));
  if (!o.ductility.empty()) {
    const double hardening = positive(o.hardening, "--hardening", 0.0, 0.0);
    if (hardening > 1.0) refuse("--hardening " + o.hardening, "expected a ratio from 0 to 1");
    return inelastic_table(m, periods, damping, positive(o.ductility, "--ductility", 1.0, 1.0), hardening);
  }
  Table t = elastic_table(m, periods, damping, o.peaks == "continuous");
  t.warnings = seismic::spectrum_warnings(periods, m.interval);
  return t;
}

void print_table(const SourceMotion& m, const Table& t) {
  fmt::print("{}\n{}; {}{}\n\n", m.title, m.state, t.heading,
             m.dimensionless ? "; dimensionless, in multiples of the peak" : "");
  for (const std::string& name : t.names) fmt::print("{:>24}", name);
  for (std::size_t row = 0; row < t.columns[0].size(); ++row) {
    fmt::print("\n");
    for (const auto& values : t.columns) fmt::print("{:>24.8g}", values[row]);
  }
  fmt::print("\n");
  for (const std::string& warning : t.warnings) fmt::print("warning: {}\n", warning);
  for (const std::string& warning : m.warnings) fmt::print("warning: {}\n", warning);
}

ordered_json json_of(const SourceMotion& m, const Table& t) {
  ordered_json columns = ordered_json::object();
  for (std::size_t i = 0; i < t.names.size(); ++i) columns[t.names[i]] = t.columns[i];
  std::vector<std::string> warnings = t.warnings;
  warnings.insert(warnings.end(), m.warnings.begin(), m.warnings.end());
  return {{"title", m.title},         {"state", m.state},   {"dimensionless", m.dimensionless},
          {"synthetic", m.synthetic}, {"dt_s", m.interval}, {"npts", m.acceleration.size()},
          {"spectrum", t.heading},    {"columns", columns}, {"processing", m.processing},
          {"warnings", warnings}};
}

void draw_table(const SpectrumOptions& o, const SourceMotion& m, Table t,
                const std::vector<double>& periods) {
  if (o.plot.empty()) return;
  if (!o.target.empty()) {
    const auto target = target_spectrum(o.target);
    SpectrumCurve curve{target.name, {}, {}, true};
    for (const double period : periods)
      if (period >= target.shortest_period && period <= target.longest_period)
        curve.x.push_back(period), curve.y.push_back(target.at(period));
    t.curves.push_back(curve);
  }
  write_picture(o.plot, spectra_figure("Response spectrum: " + t.heading, m.title, t.curves));
}

}  // namespace

int record_spectrum_command(const SpectrumOptions& o) {
  check_picture(o.plot, o.force);
  check_new_file(o.csv, o.force);
  if (o.fourier && !o.plot.empty()) refuse("--plot", "of a Fourier spectrum: dougong record plot draws it");
  const std::vector<double> periods = periods_of(o.periods, 0.02, 10.0, 121);
  const SourceMotion motion = motion_of(o.source);
  const Table table = table_of(o, motion, periods);
  if (!o.csv.empty()) write_file(o.csv, csv_of(table.names, table.columns));
  draw_table(o, motion, table, periods);
  if (o.json)
    print_json(json_of(motion, table));
  else
    print_table(motion, table);
  return exit_survived;
}

}  // namespace dougong::app
