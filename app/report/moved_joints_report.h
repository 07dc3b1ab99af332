// The joints of a building in motion: how far they opened and slid, what they bore. Table, drawing, CSV.
#pragma once

#include <string>
#include <vector>

#include "app/report/gnuplot.h"
#include "app/report/html.h"
#include "app/study/run_result.h"

namespace dougong::app {

/// Every face as a line, coloured by its widest opening or its farthest slip, whichever is more. Needs
/// joints.
Figure moved_joints_figure(const ModelSheet& model, const std::vector<MovedJoint>& joints);
std::string moved_joints_csv(const std::vector<MovedJoint>& joints);

/// Cells: joint, kind, opening (mm) at (s), left (mm), slip (mm) at (s), left (mm), greatest compression,
/// tension, shear (kN). At most so many.
std::vector<std::vector<std::string>> moved_joint_rows(const std::vector<MovedJoint>& joints,
                                                       std::size_t most);

Html page_moved_joints(const RunResult& run, const std::vector<Picture>& pictures);

}  // namespace dougong::app
