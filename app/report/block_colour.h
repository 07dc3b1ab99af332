// What the colours of the blocks tell: a number for every block and moment, on a scale that starts at 0.
#pragma once

#include <string>
#include <vector>

#include "app/study/run_result.h"

namespace dougong::app {

enum class BlockColour {
  displacement,  // m, relative to the ground since the start
  speed,         // m/s, relative to the ground
  force,         // horizontal inertial force over the block's own weight
  damage         // 1 of a block that has lost its support, 0 of all others; bonds have colours of their own
};
std::vector<std::string> block_colours();
/// Throws std::invalid_argument for a name that is none of block_colours().
BlockColour block_colour_named(const std::string& name);

double coloured_by(const RunResult& run, BlockColour colour, std::size_t step, std::size_t block);

/// Without the displacement, which has its scale from the picture.
struct ColourScale {
  double largest = 1.0;
  std::string unit, meaning;
};
ColourScale colour_scale(const RunResult& run, BlockColour colour, const std::vector<std::size_t>& steps);

}  // namespace dougong::app
