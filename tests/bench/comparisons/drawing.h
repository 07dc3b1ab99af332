// Blocks drawn to scale by gnuplot: where they stand, and moved as a mechanism says.
#pragma once

#include "structures/collapse_multiplier.h"

namespace dougong::comparisons {

/// Closed outlines, each a block of lines, in m; every motion is magnified by `scale` (a small one turns
/// about the centroid).
std::string outlines(const engine::Scene& scene, const std::vector<structures::BlockMotion>& motions = {},
                     double scale = 1.0);
/// The factor that makes the largest movement `length` (m).
double magnification(const std::vector<structures::BlockMotion>& motions, double length);

}  // namespace dougong::comparisons
