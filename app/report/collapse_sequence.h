// What gave way, in order of time: bonds that cracked and broke, blocks that lost their support, storeys.
#pragma once

#include <string>
#include <vector>

#include "app/study/run_result.h"

namespace dougong::app {

struct CollapseEvent {
  double time = 0.0;   // s
  std::string what;    // "bond cracked", "bond crushed", "bond broke", "support lost", "storey lost"
  std::string where;   // name of the bond, block or storey
  std::string storey;  // may be empty
  std::string how;     // "shear", "fell 1.30 m"; may be empty
};

std::vector<CollapseEvent> collapse_sequence(const RunResult& run);

std::string collapse_sequence_csv(const RunResult& run);
/// Each lost block: when it lost its support, how, and its hardest hit.
std::string falls_csv(const RunResult& run);
/// Of each storey over time, kg and as a part of its mass.
std::string mass_lost_csv(const RunResult& run);

}  // namespace dougong::app
