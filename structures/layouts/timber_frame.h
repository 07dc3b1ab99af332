// A frame of timber: posts from storey to storey and beams between them, rigid, in joints that turn.
//
// A node is the head of a post. A beam's ends turn in the nodes, and the feet of the posts above turn on
// them, against joint_stiffness k_r each (0: pinned); the lowest feet turn freely on the ground. Members are
// rigid: what gives way is the joints, which is where timber frames give way. Without braces a storey of n
// posts, height h and beams to hold 2 (n - 1) ends resists its drift with  K = 2 (n - 1) k_r/h2 in the first
// storey. Knee braces run from a post, brace_reach under the beam, to the beam, as far from the post;
// diagonals from node to node. They are axially elastic and do not buckle.
#pragma once

#include "structures/layouts/layout.h"

namespace dougong::structures {

Layout timber_frame();

}  // namespace dougong::structures
