// The joints of a building under its weight alone: table, drawing, CSV.
#pragma once

#include <string>
#include <vector>

#include "app/report/gnuplot.h"
#include "app/report/html.h"
#include "app/study/run_result.h"

namespace dougong::app {

/// Every face as a line, coloured by how much of its nearest limit it uses. Needs joints.
Figure weight_figure(const ModelSheet& model, const std::vector<WeightJoint>& joints);
/// A graph of the blocks: lines through the joints, by the force that they press with. Needs joints.
Figure load_path_figure(const ModelSheet& model, const std::vector<WeightJoint>& joints);
std::string weight_joints_csv(const std::vector<WeightJoint>& joints);

/// Cells: joint, kind, compression (kN), shear (kN), eccentricity, greatest compression and tension (kPa),
/// used
/// (%), of what. At most so many.
std::vector<std::vector<std::string>> weight_rows(const std::vector<WeightJoint>& joints, std::size_t most);
/// Of all that have one: at a corner it is infinite. Null without.
const WeightJoint* most_compressed(const std::vector<WeightJoint>& joints);
/// "1.23 MPa in A / B"; "none" without.
std::string greatest_compression(const std::vector<WeightJoint>& joints);
/// "most used joint A / B: 12.3 % of friction; greatest compression 1.23 MPa in A / B". Needs joints.
std::string weight_text(const std::vector<WeightJoint>& joints);

Html page_weight(const RunResult& run, const std::vector<Picture>& pictures);

}  // namespace dougong::app
