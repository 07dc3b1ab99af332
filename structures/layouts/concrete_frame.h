// A plane frame of reinforced concrete out of bonded blocks, one of a row of frames that share the floors.
//
// Columns and beams are chains of blocks that meet in blocks of their own, the nodes; a face between two
// blocks has the stiffness of Timoshenko's beam (parts.h) times cracked_stiffness. The floors act as mass of
// the beams: floor_load x frame_spacing/g a metre.
//
// Reinforcement: a bond yields in tension at
//
//   f = 0.8 rho f_y
//
//   rho  all longitudinal bars over the section   -     f_y  steel_yield   Pa
//
// Once it has yielded the face turns about its edge (docs/theory/bonds.md) with both its points at their
// yield force f A/2, which gives f A d/2 without axial force; a section of depth d with half the bars at each
// side, 0.8 d apart, gives 0.4 rho f_y A d. In shear a bond holds shear_strength, plus friction under
// compression, and then flows. Bars do not rupture; concrete crushes
// at compressive_strength, if that is given.
#pragma once

#include "structures/layouts/layout.h"

namespace dougong::structures {

Layout concrete_frame();

}  // namespace dougong::structures
