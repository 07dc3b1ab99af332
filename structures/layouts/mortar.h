// Mortar between bricks or stones: a joint that may open and slide, with the stiffness of a thin layer
// between the units.
//
// The defaults are those of a weak lime-cement mortar in tests of small walls: flexural bond 0.1 to 0.3 MPa,
// initial shear strength 0.2 to 0.4 MPa (EN 1996-1-1:2005, tables 3.4 and 3.6.3 give characteristic values of
// 0.2 and 0.1 MPa), fracture energy in tension 5 to 20 J/m2 (Van der Pluijm, Proc. 6th Canadian Masonry
// Symposium (1992) 909-920, and Rots (ed.), Structural Masonry (1997)).
#pragma once

#include "structures/layouts/parts.h"

namespace dougong::structures {

std::vector<Parameter> mortar_parameters();
/// Friction is that of the units.
Connection mortar_of(const ParameterValues& values);
/// Bonds all blocks that lie on or next to each other, over head joints as wide as that (m).
void lay_in_mortar(Building& building, const ParameterValues& values, double head_joint);
/// Throws LayoutError for joints thicker than the unit they lie between, joint included (m).
void require_mortar(const ParameterValues& values, double unit);

}  // namespace dougong::structures
