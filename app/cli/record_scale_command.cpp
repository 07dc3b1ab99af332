#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/motion_file.h"
#include "app/cli/record_output.h"
#include "app/cli/record_tools.h"
#include "app/report/record_figures.h"
#include "app/report/safe_file.h"
#include "app/study/target_choice.h"
#include "seismic/design/scaling.h"

namespace dougong::app {
namespace {

using nlohmann::ordered_json;

struct Suite {
  std::vector<SourceMotion> motions;
  std::vector<double> periods;
  std::string target;          // what is met
  std::vector<double> wanted;  // m/s2
  std::vector<std::vector<double>> spectra;
  seismic::SuiteScaling scaling;
};

seismic::ScalingRule rule_of(const std::string& word) {
  if (word == "least-squares") return seismic::ScalingRule::least_squares;
  return word == "never-below" ? seismic::ScalingRule::never_below : seismic::ScalingRule::mean_log;
}

std::vector<SourceMotion> motions_of(const ScaleOptions& o) {
  std::vector<SourceMotion> motions;
  for (const std::string& record : o.records) {
    RecordSource source = o.source;
    source.record = record;
    motions.push_back(motion_of(source));
  }
  return motions;
}

double wanted_value(const std::string& text, const char* option) {
  const double value = quantity_of(text, Dimension::acceleration, option);
  if (!(value > 0.0)) refuse(std::string(option) + " " + text, "expected an acceleration above zero");
  return value;
}

// What every record is measured by: its spectrum over the band, one ordinate of it, or its peak.
void choose_target(const ScaleOptions& o, Suite& suite) {
  const int given = !o.target.empty() + !o.pga.empty() + !o.sa.empty();
  if (given != 1) refuse("record scale", "expected one of --target, --pga and --sa with --period");
  if (!o.sa.empty() && o.period.empty()) refuse("--sa", "expected the period too: --period \"0.5 s\"");
  double damping = damping_of(o.damping);
  if (!o.pga.empty()) {
    suite.target = "PGA";
    suite.periods = {0.0};
    suite.wanted = {wanted_value(o.pga, "--pga")};
    for (const SourceMotion& m : suite.motions)
      suite.spectra.push_back({seismic::peak(m.acceleration, m.interval).value});
    return;
  }
  if (!o.sa.empty()) {
    suite.target = fmt::format("PSa, {:g} %", 100.0 * damping);
    suite.periods = periods_of({"", "", 0, {o.period}}, 0.0, 0.0, 0);
    suite.wanted = {wanted_value(o.sa, "--sa")};
  } else {
    const auto target = target_spectrum(o.target);
    suite.target = target.name;
    if (o.damping.empty()) damping = target.damping_ratio;
    suite.periods = periods_of(o.periods, 0.2, 2.0, 50);
    suite.wanted = target.at(suite.periods);
  }
  for (const SourceMotion& m : suite.motions)
    suite.spectra.push_back(
        seismic::pseudo_accelerations(m.acceleration, m.interval, suite.periods, damping));
}

Suite suite_of(const ScaleOptions& o) {
  Suite suite;
  suite.motions = motions_of(o);
  choose_target(o, suite);
  std::optional<double> floor;
  if (!o.floor.empty()) floor = quantity_of(o.floor, Dimension::ratio, "--floor");
  if (floor && !(*floor > 0.0 && *floor <= 10.0))
    refuse("--floor " + o.floor, "expected a part of the target above zero");
  suite.scaling = seismic::scale_suite(suite.spectra, suite.wanted, rule_of(o.rule), floor);
  return suite;
}

void print_suite(const ScaleOptions& o, const Suite& suite) {
  const bool band = suite.periods.size() > 1;
  fmt::print("target     {}\n", suite.target);
  if (band)
    fmt::print("band       {:g} s to {:g} s, {} periods, by {}\n", suite.periods.front(),
               suite.periods.back(), suite.periods.size(), o.rule);
  fmt::print("\n{:>12}{:>12}{:>14}   record\n", "factor", "misfit", "PGA then");
  for (std::size_t i = 0; i < suite.motions.size(); ++i) {
    const SourceMotion& m = suite.motions[i];
    fmt::print("{:>12.9g}{:>12.4f}{:>9.4f} m/s2   {}\n", suite.scaling.factors[i], suite.scaling.misfits[i],
               suite.scaling.factors[i] * seismic::peak(m.acceleration, m.interval).value, m.title);
  }
  fmt::print(
      "\nmean of the scaled spectra: misfit {:.4f}, at least {:.4f} of the target; common factor {:.6g}\n",
      suite.scaling.mean_misfit, suite.scaling.least_ratio, suite.scaling.common_factor);
  fmt::print("misfit: root mean square of ln(scaled/target)\n");
}

ordered_json json_of(const ScaleOptions& o, const Suite& suite) {
  ordered_json records = ordered_json::array();
  for (std::size_t i = 0; i < suite.motions.size(); ++i)
    records.push_back({{"record", o.records[i]},
                       {"title", suite.motions[i].title},
                       {"factor", suite.scaling.factors[i]},
                       {"misfit", suite.scaling.misfits[i]}});
  return {{"target", suite.target},
          {"rule", o.rule},
          {"periods_s", suite.periods},
          {"target_m_s2", suite.wanted},
          {"records", records},
          {"mean_m_s2", suite.scaling.mean},
          {"mean_misfit", suite.scaling.mean_misfit},
          {"least_ratio", suite.scaling.least_ratio},
          {"common_factor", suite.scaling.common_factor}};
}

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

std::string spectra_csv(const Suite& suite) {
  std::vector<std::string> names = {"period_s", "target_m_s2", "mean_m_s2"};
  std::vector<std::vector<double>> columns = {suite.periods, suite.wanted, suite.scaling.mean};
  for (std::size_t i = 0; i < suite.spectra.size(); ++i) {
    names.push_back(fmt::format("record_{}_m_s2", i + 1));
    columns.push_back(scaled(suite.spectra[i], suite.scaling.factors[i]));
  }
  return csv_of(names, columns);
}

// Drawn over more than the band, so that one sees what happens beside it.
Figure suite_figure(const ScaleOptions& o, const Suite& suite) {
  const auto periods = seismic::log_spaced_periods(std::max(0.02, 0.2 * suite.periods.front()),
                                                   std::min(10.0, 3.0 * suite.periods.back()), 160);
  const auto target = target_spectrum(o.target);
  const double damping = o.damping.empty() ? target.damping_ratio : damping_of(o.damping);
  std::vector<SpectrumCurve> curves;
  std::vector<double> mean(periods.size(), 0.0);
  for (std::size_t i = 0; i < suite.motions.size(); ++i) {
    const SourceMotion& m = suite.motions[i];
    const auto psa = scaled(seismic::pseudo_accelerations(m.acceleration, m.interval, periods, damping),
                            suite.scaling.factors[i]);
    for (std::size_t k = 0; k < mean.size(); ++k)
      mean[k] += psa[k] / static_cast<double>(suite.motions.size());
    curves.push_back({"", periods, psa, false, true});
  }
  curves.push_back(
      {suite.motions.size() > 1 ? fmt::format("mean of {}", suite.motions.size()) : "scaled record", periods,
       mean});
  SpectrumCurve wanted{"target", {}, {}, true};
  for (const double period : periods)
    if (period >= target.shortest_period && period <= target.longest_period)
      wanted.x.push_back(period), wanted.y.push_back(target.at(period));
  curves.push_back(wanted);
  return spectra_figure(
      "Spectra scaled to a target",
      suite.target + fmt::format("; {}, {:g} s to {:g} s; misfit of the mean {:.3f}", o.rule,
                                 suite.periods.front(), suite.periods.back(), suite.scaling.mean_misfit),
      curves, suite.periods.front(), suite.periods.back());
}

}  // namespace

int record_scale_command(const ScaleOptions& o) {
  check_picture(o.plot, o.force);
  check_new_file(o.csv, o.force);
  if (!o.plot.empty() && o.target.empty())
    refuse("--plot", "expected a --target: the spectra are drawn beside it");
  const Suite suite = suite_of(o);
  if (!o.csv.empty()) write_file(o.csv, spectra_csv(suite));
  if (!o.plot.empty()) write_picture(o.plot, suite_figure(o, suite));
  if (o.json)
    print_json(json_of(o, suite));
  else
    print_suite(o, suite);
  return exit_survived;
}

}  // namespace dougong::app
