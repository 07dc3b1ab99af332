// A colonnade of stone: columns of drums, each with a capital, that carry an architrave of beams from axis to
// axis, laid dry. Two columns of one drum without capitals are a trilith.
//
//   width of a column at height y:  w(y) = w (1 - taper_ratio y/H),   H = drums x drum_height
//
// The outer beams end flush with the outer columns' feet; beams that meet on a column are open by 1 mm.
#pragma once

#include "structures/layouts/layout.h"

namespace dougong::structures {

Layout colonnade();

}  // namespace dougong::structures
