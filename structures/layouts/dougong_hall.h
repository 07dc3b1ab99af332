// A hall of timber as the Yingzao Fashi (1103) builds it, seen from the front: columns on stone bases, tied
// at their heads by lintels, bracket sets (dougong) on the columns, a plate and a heavy roof.
//
// A bracket set is a pile: the cap block (ludou), then in every tier an arm (gong), each longer than the one
// below by two steps, with three bearing blocks (sheng) on it. Nothing but weight and friction holds the pile
// to the column, the column to its base and the base to the ground; the columns rock, and the roof's weight
// brings them back. A lintel's tenons turn in the columns against a rotational stiffness.
//
// Sizes follow the fen of the sixth grade of timber: an arm is 15 fen high and 10 thick, a bearing block 10
// high, the cap block 32 wide and 20 high; defaults are those with a fen of 16 mm. Liang Ssu-ch'eng, A
// Pictorial History of Chinese Architecture (1984).
#pragma once

#include "structures/layouts/layout.h"

namespace dougong::structures {

Layout dougong_hall();

}  // namespace dougong::structures
