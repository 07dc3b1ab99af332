// What a static analysis writes: tilt.html or pushover.html, its numbers as JSON and CSV, its figures.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/report/figures.h"
#include "app/report/report_output.h"
#include "app/study/statics.h"

namespace dougong::app {

/// Tidy: one row a trial, a point of the capacity curves, a bond that cracked, a block of a mechanism.
std::string trials_csv(const StaticResult& result);
std::string capacity_csv(const StaticResult& result);
std::string bond_events_csv(const StaticResult& result);
std::string mechanism_csv(const StaticResult& result);
/// As tilt.json and pushover.json.
std::string statics_json(const StaticResult& result, const std::string& command);

/// Resistance against roof drift, with the bracket and the first crack. Needs a curve.
Figure capacity_figure(const StaticResult& result);
/// Every trial of the search, what stood and what fell.
Figure trials_figure(const StaticResult& result);
/// Needs a mechanism.
Figure mechanism_figure(const StaticResult& result, const SideResult& side);

/// "0.3125 to 0.3140", "above 2 (the search ended there)".
std::string bracket_text(const structures::CollapseMultiplier& found);
/// What the mechanism is, in words: "12 of 33 blocks in motion, 3 hinges, 2 sliding joints".
std::string mechanism_text(const SideResult& side, std::size_t blocks);
/// Of a bracket's ends: degrees of the table.
double tilt_degrees(double multiplier);

std::string statics_page(const StaticResult& result, const std::vector<Picture>& pictures,
                         const std::string& command);
/// The page first. Throws PlotError, FileError.
std::vector<std::string> write_statics(const StaticResult& result, const std::string& command,
                                       const std::filesystem::path& folder);

}  // namespace dougong::app
