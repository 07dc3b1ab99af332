// What `dougong compare` leaves in its folder beside the runs: compare.html, compare.csv, differences.csv and
// the figures, drawn from what the results files hold.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/study/compare/differences.h"

namespace dougong::app {

/// The run as described of a case; read when it is drawn, so that not all of them are in memory.
using RunLoader = std::function<RunResult(const ComparedRun&)>;

/// Returns the names of the files, from the folder. Throws FileError and PlotError.
std::vector<std::string> write_comparison(const Comparison& comparison, const RunLoader& load,
                                          const std::filesystem::path& folder);

}  // namespace dougong::app
