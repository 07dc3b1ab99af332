#include "app/report/figures.h"

#include <algorithm>
#include <cmath>

#include "app/report/moved_joints_report.h"
#include "app/report/text.h"
#include "app/report/weight_joints_report.h"
#include "app/study/floor_spectra.h"

namespace dougong::app {
namespace {

bool anything_positive(const std::vector<double>& values) {
  for (const double v : values) {
    if (v > 0) return true;
  }
  return false;
}

std::string both(const structures::Envelope& e, std::string (*print)(double)) {
  return print(e.positive.value) + " at " + seconds(e.positive.time) + " and " + print(e.negative.value) +
         " at " + seconds(e.negative.time);
}

std::string drift_words(const RunResult& run) {
  std::string out;
  for (const auto& storey : run.response.storeys) {
    out += (out.empty() ? "" : "; ") + storey.name + ": " + both(storey.peak_drift, drift_percent);
    if (storey.lost_at) out += ", lost at " + seconds(*storey.lost_at);
  }
  return out;
}

std::string shear_words(const RunResult& run) {
  const auto& r = run.response;
  return "Roof displacement relative to the ground peaks at " + both(r.peak_roof_displacement, displacement) +
         "; base shear over weight below it on the same time axis.";
}

void add_motion(const RunResult& run, std::vector<NamedFigure>& out) {
  out.push_back(
      {"motion", "Ground acceleration, velocity and displacement against time.", motion_figure(run)});
  if (!anything_positive(run.motion.spectrum_psa)) return;
  out.push_back({"spectrum",
                 "Pseudo-acceleration against period, log-log, with the period of the building marked.",
                 spectrum_figure(run)});
}

void add_response(const RunResult& run, std::vector<NamedFigure>& out) {
  if (run.response.storeys.empty()) return;
  out.push_back(
      {"drift_profile", "Peak drift of each storey. " + drift_words(run), drift_profile_figure(run)});
  out.push_back({"floor_profiles",
                 "Peak, residual and shear drift and peak acceleration over the height of the building.",
                 floor_profiles_figure(run)});
  if (run.response.times.empty()) return;
  out.push_back({"drift_histories", "Interstorey drift against time, one panel a storey. " + drift_words(run),
                 drift_histories_figure(run)});
}

void add_loops_and_floors(const RunResult& run, std::vector<NamedFigure>& out) {
  const auto& r = run.response;
  if (r.weight > 0 && r.height > 0 && r.times.size() > 1 && !r.overturning_moment.empty())
    out.push_back({"hysteresis", "Loops of base shear and overturning moment against roof drift.",
                   hysteresis_figure(run)});
  if (!floor_spectra(run).floors.empty())
    out.push_back(
        {"floor_spectra",
         "Pseudo-acceleration of every floor's acceleration against period, log-log, with the ground's.",
         floor_spectra_figure(run)});
}

void add_balance(const RunResult& run, std::vector<NamedFigure>& out) {
  if (!run.energy.input.empty()) {
    out.push_back(
        {"energy_stack",
         "Friction, damping, fracture, strain, kinetic and lifted energy stacked over time, with the "
         "input and the error as lines.",
         energy_stack_figure(run)});
    out.push_back(
        {"energy",
         "Input, kinetic, gravity, elastic, friction and damping energy against time, and the error "
         "of their balance below.",
         energy_figure(run)});
  }
  if (!run.numerics.overlap_ratio.empty()) {
    out.push_back({"overlap",
                   "Deepest overlap between blocks against time, in percent of the smaller block's width.",
                   overlap_figure(run)});
  }
}

}  // namespace

std::string run_line(const RunResult& run) {
  return run.model.layout + " on " + run.motion.title + (run.partial ? " (partial run)" : "");
}

std::vector<NamedFigure> all_figures(const RunResult& run) {
  std::vector<NamedFigure> out;
  if (!run.weight_joints.empty())
    out.push_back({"weight", "The building at rest; every joint coloured by how much of its limit it uses.",
                   weight_figure(run.model, run.weight_joints)});
  if (!run.weight_joints.empty())
    out.push_back({"load_path",
                   "The building at rest; lines from block to block through their joints, as wide as the "
                   "force that they press with.",
                   load_path_figure(run.model, run.weight_joints)});
  add_motion(run, out);
  add_response(run, out);
  if (!run.response.roof_displacement.empty()) {
    out.push_back({"roof_and_base_shear", shear_words(run), roof_and_base_shear_figure(run)});
  }
  if (std::ranges::any_of(run.model.bonded, [](const DrawnBond& b) { return !b.mode.empty(); }))
    out.push_back({"damage",
                   "The building at rest; every damaged bond coloured by when it left its elastic range.",
                   damage_figure(run)});
  if (!run.moved_joints.empty())
    out.push_back({"joints", "The building at rest; every joint coloured by how far it opened or slid.",
                   moved_joints_figure(run.model, run.moved_joints)});
  add_loops_and_floors(run, out);
  if (has_end_load_path(run))
    out.push_back({"load_path_end",
                   "The building at the end of the run; lines from block to block that press each other.",
                   end_load_path_figure(run)});
  if (run.collapse.happened())
    out.push_back(
        {"mass_lost", "Part of each storey's mass that was lost, against time.", mass_lost_figure(run)});
  if (has_ensemble_figure(run))
    out.push_back({"ensemble",
                   "Roof drift of every run of the ensemble against time, the one described bold; below, the "
                   "peak drift of each, their spread, and the change by half the step.",
                   ensemble_figure(run)});
  add_balance(run, out);
  return out;
}

}  // namespace dougong::app
