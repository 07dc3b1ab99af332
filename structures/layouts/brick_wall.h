// A brick wall in running bond, in its own plane: courses of bricks, every other course shifted by
// half a brick and closed by half bricks, so that no head joint stands on another.
//
//   odd courses  (1st, 3rd ...)   n bricks,      brick j at  x_j = (j - (n-1)/2)(l + g)
//   even courses (2nd, 4th ...)   n - 1 bricks   on the joints below, and a half brick (l - g)/2 at each end
//
//   n  bricks_per_course     l  brick_length   m     g  head_joint   m
//
// Head joints are open by g (1 mm unless told otherwise). Were the bricks to touch end to end, rounding
// and settling would leave each joint an arbitrary compression that friction then locks in; and the
// head joints of a real wall are the least filled. Bed joints are closed: there the weight acts.
#pragma once

#include "structures/layouts/layout.h"

namespace dougong::structures {

Layout brick_wall();

}  // namespace dougong::structures
