// Axes of logarithmic plots.
#pragma once

#include <string>
#include <vector>

#include "app/report/axis.h"

namespace dougong::app {

/// From a round number below to one above the positive values, at most `decades` of them below the greatest;
/// 0.01 to 1 when there are none.
Range log_range(const std::vector<double>& values, double decades = 3.0);
/// "set xtics ('0.1' 0.1, '0.2' 0.2, ...)": 1, 2 and 5 of every decade; over more than four decades 1 alone.
std::string log_tics(const char* axis, Range range);

}  // namespace dougong::app
