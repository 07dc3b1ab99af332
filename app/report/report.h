// The whole report of a run, drawn from what its results file holds and nothing else.
//
//   results.h5  --read_results-->  RunResult  --write_report-->  report.html, summary.json, *.csv, figures/
//
// The caller writes results.h5 first, reads it back and passes what it read, so that a report can
// always be drawn again without running again.
#pragma once

#include <filesystem>
#include <vector>

#include "app/study/run_result.h"

namespace dougong::app {

/// Every file under a temporary name, then renamed. Returns the files in the order they were written.
/// Throws FileError (folder or disk) and PlotError (gnuplot missing or failing).
std::vector<std::filesystem::path> write_report(const RunResult& run, const std::filesystem::path& folder);

}  // namespace dougong::app
