// A wall in its own plane whose courses are written as text, from below, with commas between them:
//
//   1  a block     h  half a block     _  an opening as long as a block
//
// so "h1111h, 11111" is running bond of five blocks, laid `repeats` times one on the other. Letters stand
// side by side on a grid of half blocks, with p = block_length + head_joint:
//
//   a block, an opening   p on the grid, a block being p - head_joint long
//   half a block          p/2 on the grid, p/2 - head_joint long
//
// Head joints are closed without compression unless head_joint opens them. Mortar is that of the brick wall.
#pragma once

#include "structures/layouts/layout.h"

namespace dougong::structures {

Layout pattern_wall();

}  // namespace dougong::structures
