// Horizontal loads that a static analysis pushes a building with: one force at every block's centroid, in
// proportions that stay, scaled so that they add up to the weight. Their multiplier lambda is then the base
// shear over the weight, V/W.
//
//   mass        p_i = W_i                              as under a steady ground acceleration
//   triangular  p_i ~ W_i (y_i - y_foot)               of linear drift over the height
//   first-mode  p_i ~ m_i phi_i                        phi the horizontal shape of the mode that carries
//                                                      most of the mass
// Eurocode 8 (EN 1998-1:2004), 4.3.3.4.2.2, asks for a uniform and a modal pattern in a pushover analysis.
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/modes.h"

namespace dougong::structures {

enum class LoadPattern { mass, triangular, first_mode };

/// "mass", "triangular", "first-mode".
std::string to_string(LoadPattern pattern);
std::span<const LoadPattern> load_patterns();

/// The mode that carries most of the mass among those that swing; null when there is none.
const engine::Mode* main_mode(const std::vector<engine::Mode>& modes);

/// N, horizontal, one for each body; their sum is the weight. `state` is at rest under the weight. Throws
/// std::runtime_error when a modal pattern is asked for and no mode swings.
std::vector<double> pattern_forces(const engine::Model& model, const engine::State& state,
                                   LoadPattern pattern);

}  // namespace dougong::structures
