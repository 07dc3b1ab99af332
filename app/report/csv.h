// The numbers behind the figures as CSV: one header row with names and units, one row an output time,
// doubles that read back exactly. A lost storey has empty cells from its loss on, and its `lost`
// column turns from 0 to 1: a frozen or meaningless drift never looks like a result.
#pragma once

#include <string>

#include "app/study/run_result.h"

namespace dougong::app {

/// RFC 4180: quoted only when needed.
std::string csv_text(const std::string& text);

std::string drift_csv(const RunResult& run);         // time; drift and lost of every storey
std::string shear_drift_csv(const RunResult& run);   // the same without the rotation of the storeys' bases
std::string acceleration_csv(const RunResult& run);  // time; absolute floor acceleration and lost
std::string roof_and_base_shear_csv(const RunResult& run);
/// Each bond with its storey, and how and when it cracked, was crushed and broke.
std::string damage_csv(const RunResult& run);
struct FloorSpectra;
/// Period; pseudo-acceleration of the ground and of every floor.
std::string floor_spectra_csv(const FloorSpectra& spectra);
std::string energy_csv(const RunResult& run);
/// Of both signs, with their times: a row a storey.
std::string storeys_csv(const RunResult& run);
/// The deepest overlap and the mean of what touches, over the smaller block's width.
std::string overlap_csv(const RunResult& run);
/// Period; pseudo-acceleration and displacement of the motion.
std::string spectrum_csv(const MotionSheet& motion);
/// A row a run: its verdict and metrics.
std::string ensemble_csv(const EnsembleSheet& ensemble);
/// Roof displacement over height, a column a run; empty once a storey of it was lost.
std::string ensemble_roof_drift_csv(const EnsembleSheet& ensemble);
std::string motion_csv(const RunResult& run);

struct SceneResult;
/// Tidy: one row a body and output time, with the quantities that the scene keeps.
std::string bodies_csv(const SceneResult& result);
/// When every bond cracked and broke; empty where it did not.
std::string bonds_csv(const SceneResult& result);

}  // namespace dougong::app
