// A timber pagoda: storeys that stand on one another without a tie, each of columns, cap blocks on them and a
// roof that the next storey stands on, narrower upwards.
//
//   width between the outer columns' axes in storey i of n:  w_i = w (1 - taper_ratio (i - 1)/n)
//
// Horyu-ji and its kind: the storeys rock and slide on one another, one this way and the next that way.
#pragma once

#include "structures/layouts/layout.h"

namespace dougong::structures {

Layout pagoda();

}  // namespace dougong::structures
