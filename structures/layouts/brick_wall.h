// A brick wall in its own plane: courses of bricks, dry or in mortar, with openings under lintels and a
// gable.
//
// Head joints lie, with pitch p = brick_length + head_joint and n = bricks_per_course, at
//
//   running  odd courses  x = (k - n/2) p, k = 1 .. n-1       even courses  x = (k - (n+1)/2) p, k = 1 .. n
//   stack    the odd courses of running bond throughout
//   English  odd courses those of running bond, of stretchers; even courses of headers half as long, with a
//            quarter brick behind the first and before the last: x = (q/4 - n/2) p, q = 2, 3, 5 ... 4n-3,
//            4n-2
//
// A course that an opening, a lintel or the rake of the gable cuts short keeps the joints that lie further
// than a quarter brick from its ends. Head joints are open by head_joint (1 mm unless told otherwise). Were
// dry bricks to touch end to end, rounding and settling would leave each joint an arbitrary compression that
// friction then locks in; and the head joints of a real wall are the least filled. Bed joints are closed:
// there the weight acts.
//
// In mortar the blocks are bricks with half their joints (Lourenco and Rots, J. Eng. Mech. 123 (1997)
// 660-668): bonds that break lie in all joints, with the stiffness of brick and mortar in series (parts.h).
#pragma once

#include "structures/layouts/layout.h"

namespace dougong::structures {

Layout brick_wall();

}  // namespace dougong::structures
