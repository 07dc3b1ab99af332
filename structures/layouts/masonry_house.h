// A masonry house in section: two walls of courses, floors that span between them and a roof, with or without
// ties.
//
//   concrete floors   slabs as long as the house is wide; the walls of the next storey stand on them
//   timber floors     joists that bear on the inner part of the walls; beside their ends the wall goes on
//   with a
//                     thinner course, 1 mm away
//
// A tie holds each end of a floor, and of the roof, to the wall block under it: an elastic bar that does not
// yield or break, whose ends lie in the floor's axis and in the block's. Courses lie dry or in mortar
// (mortar.h); floors and roof lie on the walls dry.
#pragma once

#include "structures/layouts/layout.h"

namespace dougong::structures {

Layout masonry_house();

}  // namespace dougong::structures
