// What `dougong tradeoff` leaves in its folder: tradeoff.csv, the figure as SVG and PNG, the scene.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/report/gnuplot.h"
#include "app/study/tradeoff/tradeoff.h"

namespace dougong::app {

/// Tidy: one row a run, reference and ensemble member, failures with their reasons; cells that have no
/// meaning are empty.
std::string tradeoff_csv(const Tradeoff& tradeoff);

/// Log-log: error over processor time per simulated second; a colour an integrator, a mark a stiffness.
/// Failures are crosses above the axis; what the reference does not resolve, and the spread of a chaotic
/// motion, are bands.
Figure tradeoff_figure(const Tradeoff& tradeoff);

/// Returns the names of the files.
std::vector<std::string> write_tradeoff(const Tradeoff& tradeoff, const SceneDescription& description,
                                        const std::filesystem::path& directory);

}  // namespace dougong::app
