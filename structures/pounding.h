// When neighbours touched.
#pragma once

#include <vector>

#include "structures/response.h"

namespace dougong::structures {

/// Nearer than this is a touch (m): contacts are springs, and output times miss the deepest moment.
inline constexpr double touching_gap = 1e-3;

/// Output times up to and including `last` at which blocks of two buildings that stand side by side touched
/// (Storey::stands_on_ground tells where the next begins). Empty without neighbours.
std::vector<std::size_t> touches(const Building& building, const Trajectory& trajectory, std::size_t last);

}  // namespace dougong::structures
