// A rocking frame: free-standing columns capped by one rigid beam, laid dry, as bridge piers under a deck,
// with or without tendons along the columns' axes.
//
// Without tendons and slip all columns start to rock together at lambda = width/height, whatever the beam's
// weight; the heavier the beam, the more stable the frame (Makris and Vassiliou, Bull. Earthq. Eng. 12 (2014)
// 1131-1149: the frame rocks as a larger column of the same slenderness).
// A tendon runs from the ground under a column to the middle of the beam with a force P at the start and its
// own stiffness; it holds the frame as weight on the beam would that has no inertia.
#pragma once

#include "structures/layouts/layout.h"

namespace dougong::structures {

Layout rocking_frame();

}  // namespace dougong::structures
