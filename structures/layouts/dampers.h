// Dampers between the levels of a building, or a tuned mass on its roof.
//
//   viscous      in every storey a dashpot from the left end of the level below to the right end of its own:
//                horizontally c cos2(a), a its inclination
//   friction     in the left half of every storey a brace of two bars from the level below to a shoe under
//   its
//                own level, which slips at the force F (Pall and Marsh, J. Struct. Div. ASCE 108 (1982)
//                1313-1323); the bars have the axial stiffness k each
//   tuned-mass   a mass m on the roof, free to slide, on a spring k = m (2 pi/T)2 and a dashpot 2 xi m (2
//   pi/T);
//                best against a harmonic force with T = T1 (1 + r), xi2 = 3 r / 8 (1 + r) (Den Hartog,
//                Mechanical Vibrations, 4th ed. (1956), section 3.3), r its part of the mass that moves in
//                the mode of T1
//
//   c  damper_coefficient  N s/m     F  damper_slip_force  N     k  brace_stiffness  N/m
//   r  tuned_mass_ratio  -           T  tuned_period  s          xi  tuned_damping  -
#pragma once

#include "structures/layouts/layout.h"

namespace dougong::structures {

std::vector<Parameter> damper_parameters();
/// As it is without dampers. Throws LayoutError for a tuned mass on a roof that is not level.
Building damped(Building building, const ParameterValues& values);

}  // namespace dougong::structures
