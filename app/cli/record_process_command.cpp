#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/motion_file.h"
#include "app/cli/record_output.h"
#include "app/cli/record_tools.h"
#include "app/report/record_figures.h"

namespace dougong::app {
namespace {

using nlohmann::ordered_json;

struct Processed {
  seismic::RecordSet records;
  seismic::ConditionedMotion motion;
  std::vector<std::string> warnings;
};

Processed process(const ProcessOptions& o) {
  const Scenario scenario = scenario_of(o.source);
  Processed p;
  p.records = read_scenario_record(scenario.record, records_directory());
  seismic::ConditioningOptions options = conditioning_options(scenario);
  options.keep_stages = true;
  p.motion = seismic::condition(p.records, options);
  p.warnings = p.motion.warnings;
  const double period = quantity_or(o.period, Dimension::time, "--period", 0.0);
  for (std::string& warning : seismic::building_warnings(p.motion, period))
    p.warnings.push_back(std::move(warning));
  return p;
}

// Of every stage its peaks, integrated from rest: what the step did to the motion.
struct StagePeaks {
  std::string step;
  double pga, pgv, pgd, last_velocity, last_displacement;
};

StagePeaks peaks_of(const seismic::ConditioningStage& stage) {
  const seismic::GroundHistory h = seismic::integrate(stage.acceleration, stage.interval);
  return {stage.step,
          seismic::peak(h.acceleration, h.interval).value,
          seismic::peak(h.velocity, h.interval).value,
          seismic::peak(h.displacement, h.interval).value,
          h.velocity.back(),
          h.displacement.back()};
}

void print_processed(const Processed& p) {
  fmt::print("{}\n\n", p.motion.title);
  for (const std::string& step : p.motion.processing) fmt::print("  {}\n", step);
  fmt::print("\n  {:<10}{:>12}{:>12}{:>12}{:>15}{:>15}\n", "behind", "PGA m/s2", "PGV m/s", "PGD m",
             "v at end m/s", "d at end m");
  for (const auto& stage : p.motion.stages) {
    const StagePeaks s = peaks_of(stage);
    fmt::print("  {:<10}{:>12.5g}{:>12.5g}{:>12.5g}{:>15.3g}{:>15.3g}\n", s.step, s.pga, s.pgv, s.pgd,
               s.last_velocity, s.last_displacement);
  }
  for (const std::string& warning : p.warnings) fmt::print("warning: {}\n", warning);
}

ordered_json json_of(const Processed& p) {
  ordered_json stages = ordered_json::array();
  for (const auto& stage : p.motion.stages) {
    const StagePeaks s = peaks_of(stage);
    stages.push_back({{"step", s.step},
                      {"pga_m_s2", s.pga},
                      {"pgv_m_s", s.pgv},
                      {"pgd_m", s.pgd},
                      {"last_velocity_m_s", s.last_velocity},
                      {"last_displacement_m", s.last_displacement}});
  }
  return {{"title", p.motion.title},
          {"dt_s", p.motion.interval},
          {"npts", p.motion.horizontal.size()},
          {"lead_s", p.motion.lead},
          {"scale_factor", p.motion.scale_factor},
          {"residual_velocity_m_s", p.motion.residual_velocity},
          {"residual_displacement_m", p.motion.residual_displacement},
          {"processing", p.motion.processing},
          {"stages", stages},
          {"warnings", p.warnings}};
}

Figure figure_of(const Processed& p) {
  const seismic::ConditioningStage& read = p.motion.stages.front();
  std::vector<double> before = read.acceleration;
  for (double& a : before) a *= p.motion.scale_factor;  // so that both can be compared
  std::string heads;
  for (const auto& stage : p.motion.stages) heads += (heads.empty() ? "" : ", ") + stage.step;
  return conditioning_figure({"Before and after conditioning: " + heads, p.motion.title,
                              seismic::integrate(before, read.interval),
                              seismic::integrate(p.motion.horizontal, p.motion.interval), p.motion.lead});
}

MotionSheetLines lines_of(const Processed& p) {
  const seismic::Record& record = p.records.horizontal();
  return {
      std::string(record.provenance.synthetic ? "SYNTHETIC motion, " : "Motion ") + "conditioned by dougong",
      record.provenance.event.empty() ? p.motion.title : record.provenance.event, record.provenance.station,
      record.component};
}

}  // namespace

int record_process_command(const ProcessOptions& o) {
  if (!o.out.empty()) check_motion_file(o.out, o.force);
  check_picture(o.plot, o.force);
  const Processed p = process(o);
  if (!o.out.empty()) write_motion(o.out, lines_of(p), p.motion.interval, p.motion.horizontal, o.force);
  if (!o.plot.empty()) write_picture(o.plot, figure_of(p));
  if (o.json)
    print_json(json_of(p));
  else
    print_processed(p);
  return exit_survived;
}

}  // namespace dougong::app
