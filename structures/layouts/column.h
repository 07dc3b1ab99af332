// A column of drums, one on another, of one width or tapering evenly to the top.
//
//   width at height y:  w(y) = w (1 - taper_ratio y/H),   H = drums x drum_height
//
//   w  width at the foot   m
#pragma once

#include "structures/layouts/layout.h"

namespace dougong::structures {

Layout column();

}  // namespace dougong::structures
