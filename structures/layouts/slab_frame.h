// Slabs on pairs of columns, laid dry: every storey is two columns and one slab across them. Nothing
// ties the blocks together but weight and friction, so a storey fails when its columns rock over.
//
//   storey i:  columns from y = (i-1) H to (i-1) H + h_c,  slab from there to i H,  H = h_c + t
//
//   h_c  column_height   m       t  slab_thickness   m       H  storey height   m
#pragma once

#include "structures/layouts/layout.h"

namespace dougong::structures {

Layout four_storey();         // 0.3 m columns
Layout four_storey_strong();  // left columns twice as wide
Layout ten_storey();

}  // namespace dougong::structures
