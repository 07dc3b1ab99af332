// A semicircular arch on two piers of dry courses, with or without buttresses beside them.
//
// The arch is that of arch.h with an embrace angle of 180 degrees. A pier reaches from pier_projection beyond
// the extrados inwards by its width. A buttress leans on its pier's outer face with courses of its own; its
// outer face is battered, from buttress_width at the foot to buttress_head at the top.
#pragma once

#include "structures/layouts/layout.h"

namespace dougong::structures {

Layout arch_on_piers();

}  // namespace dougong::structures
