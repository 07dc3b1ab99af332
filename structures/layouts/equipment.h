// Equipment that stands free on a floor: a cabinet, a rack with what lies on its shelves, or a statue on its
// pedestal. The floor is a slab that lies on the ground and has the layout's material, or is left out.
//
//   cabinet   one block of item_width by item_height and item_mass
//   rack      two uprights and shelves from end to end, welded; on each shelf boxes that share item_mass
//   statue    a pedestal and on it, free, a figure: a plinth, a body that narrows, shoulders and a head as
//   one
//             block, of item_mass
#pragma once

#include "structures/layouts/layout.h"

namespace dougong::structures {

Layout equipment();

}  // namespace dougong::structures
