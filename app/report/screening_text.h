// The screening by standards in a line each, and as a table for programs.
#pragma once

#include <string>
#include <vector>

#include "app/study/run_result.h"

namespace dougong::app {

/// In the order of the checks, each once.
std::vector<std::string> screened_standards(const ScreeningSheet& sheet);
/// "FEMA 356: 1 of 5 limits exceeded; IO of concrete frames (1/100) by a factor of 1.32".
std::vector<std::string> screening_lines(const ScreeningSheet& sheet);
std::string screening_csv(const ScreeningSheet& sheet);

}  // namespace dougong::app
