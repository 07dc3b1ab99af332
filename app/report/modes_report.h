// What `layout modes` writes: a page, the modes and their shapes as CSV, every shape drawn.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/report/gnuplot.h"
#include "app/study/modes_study.h"

namespace dougong::app {

/// One row a mode: period, frequency, angular frequency, effective mass and its sum.
std::string modes_csv(const ModesResult& result);
/// One row a mode and block, scaled so that the greatest horizontal movement is 1 (rad per m for the turn).
std::string mode_shapes_csv(const ModesResult& result);
Figure mode_figure(const ModesResult& result, std::size_t mode);

/// Cells of a table: number, period (s), frequency (Hz), effective mass (%), their sum (%).
std::vector<std::vector<std::string>> mode_rows(const ModesResult& result);

/// The page first.
std::vector<std::string> write_modes(const ModesResult& result, const std::string& command,
                                     const std::filesystem::path& folder);

}  // namespace dougong::app
