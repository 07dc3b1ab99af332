// Base isolation: the whole building on a rigid raft that slides on the ground, M with raft and g as usual.
//
//   linear              no friction, spring k = M (2 pi/T)2 and dashpot c = 2 xi M (2 pi/T): rubber bearings
//   friction-pendulum   friction mu, spring k = M g/R; on the concave surface T = 2 pi sqrt(R/g)
//   sliding             friction mu alone: nothing brings the building back
//
//   T  isolation_period  s     xi  isolation_damping  -     R  pendulum_radius  m     mu  isolation_friction
//   -
//
// The raft carries the weight by contact, so it may lift off, and friction follows the momentary normal
// force; the pendulum's spring is that of the weight at rest, which takes no part in vertical shaking, and
// its surface is flat: the building does not rise by u2/2R. Zayas, Low and Mahin, Earthquake Spectra 6 (1990)
// 317-333; Naeim and Kelly, Design of Seismic Isolated Structures (1999).
#pragma once

#include "structures/layouts/layout.h"

namespace dougong::structures {

std::vector<Parameter> isolation_parameters();
/// As it is without isolation. The raft is a storey of its own below the others, named raft.
Building isolated(Building building, const ParameterValues& values);

}  // namespace dougong::structures
