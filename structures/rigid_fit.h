// How much of the movement of some blocks is that of one rigid body.
//
// The points are the corners of the blocks, p at the first output time and p' at another, each about the
// centroid of its set and weighted by its share w of its block's mass. The rotation R by
//
//   angle = atan2( sum w p x p',  sum w p . p' )        (rad)
//
// leaves the least sum w |p' - R p|^2 (plane orthogonal Procrustes problem: J. C. Gower, G. B. Dijksterhuis,
// Procrustes problems, 2004), and explains 1 - that sum / sum w |p' - p|^2 of the movement about the
// centroid.
#pragma once

#include <vector>

#include "structures/response.h"

namespace dougong::structures {

struct RigidFit {
  double angle = 0.0;      // rad
  double explained = 0.0;  // -, 0 when nothing moved about the centroid
};

/// masses: one entry a block of the building (kg).
RigidFit fit_rigid_motion(const Building& building, const Trajectory& trajectory,
                          const std::vector<std::size_t>& blocks, const std::vector<double>& masses,
                          std::size_t step);

}  // namespace dougong::structures
