// Interstorey drift without the part that the rotation of the storey's base makes: what a rocking wall is
// sheared, and not how far it leans.
//
// The base of a storey is the level below, or of the lowest storey the blocks that stand on its foot. It
// turns by the rotation that fits the motion of its mass best (plane orthogonal Procrustes problem over the
// mass of rigid blocks, as in rigid_fit.h): p from the centre of the base to the centre of a block, m and I
// the mass and the moment of inertia of the block, d its own turn since the start,
//   phi = atan2( sum m p x p' + I sin d,  sum m p . p' + I cos d )                       (rad)
//   shear drift = ( u_i - u_(i-1) + sin(phi) (y_i - y_(i-1)) ) / h_i
// with y the elevation of a level's blocks at the start (m), of the foot for the lowest. A building that only
// turns about any point of the ground has none, but for 1 - cos(phi).
#pragma once

#include <vector>

#include "structures/loss.h"

namespace dougong::structures {

/// Of one storey at every output time; kept from its loss on, as its drift is.
std::vector<double> shear_drift(const Building& building, const Trajectory& trajectory, const Losses& losses,
                                std::size_t storey, const std::vector<double>& drift);

}  // namespace dougong::structures
