// The plots of a report, each from a run and nothing else. One message a plot; the title says what is
// shown, the line under it for which run.
#pragma once

#include <string>
#include <vector>

#include "app/report/gnuplot.h"
#include "app/study/run_result.h"

namespace dougong::app {

Figure motion_figure(const RunResult& run);
/// 5 % damped PSa, log-log, with the building's period. Needs a spectrum.
Figure spectrum_figure(const RunResult& run);
/// Height up, drift across, both signs, true storey heights, lost storeys marked.
Figure drift_profile_figure(const RunResult& run);
/// Peak drift with the limits of standards, residual and shear drift, peak acceleration over the height.
Figure floor_profiles_figure(const RunResult& run);
/// Every bonded face by the time at which it left its elastic range. Needs one that did.
Figure damage_figure(const RunResult& run);
/// How the load goes from block to block at the end of the run, the blocks where they are then.
Figure end_load_path_figure(const RunResult& run);
bool has_end_load_path(const RunResult& run);
Figure drift_histories_figure(const RunResult& run);
Figure roof_and_base_shear_figure(const RunResult& run);
/// Of each storey over time. Needs a lost block.
Figure mass_lost_figure(const RunResult& run);
Figure energy_figure(const RunResult& run);
/// Base shear and overturning moment against roof drift. Needs both and a weight.
Figure hysteresis_figure(const RunResult& run);
/// Needs floor_spectra() that are not empty.
Figure floor_spectra_figure(const RunResult& run);
/// Where the energy is and went, stacked.
Figure energy_stack_figure(const RunResult& run);
Figure overlap_figure(const RunResult& run);
/// Roof drift of every member over time, and their peaks beside the change by half the step. Needs members
/// that have histories.
Figure ensemble_figure(const RunResult& run);
bool has_ensemble_figure(const RunResult& run);

/// "two-storey slabs on SYN1 / EW": the line under every title.
std::string run_line(const RunResult& run);

struct NamedFigure {
  std::string name;  // of the files
  std::string alt;   // what it shows, in words
  Figure figure;
};

/// Every plot this run has data for, in the order of the report.
std::vector<NamedFigure> all_figures(const RunResult& run);

}  // namespace dougong::app
