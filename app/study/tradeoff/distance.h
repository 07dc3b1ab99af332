// How far two runs of one scene lie apart.
//
//   d² = Δx² + Δy² + (ρ Δθ)²      of one body at one output time; ρ its radius of gyration, m
//   error = D / L                 D the rms of d over bodies and output times, its largest, or its rms at the
//                                 end; L the largest way of a body from its start in the reference
//
// Ways are those relative to the ground, where all terrains move as one: what both runs share is no motion of
// the scene. Both runs have the same output times.
#pragma once

#include <string_view>
#include <vector>

#include "engine/model.h"
#include "structures/response.h"

namespace dougong::app {

enum class Measure { rms, largest, end };
/// Throws std::invalid_argument, naming what there is.
Measure measure_from(std::string_view word);
std::string_view to_string(Measure measure);

struct Yardstick {
  Measure measure = Measure::rms;
  std::vector<std::size_t> bodies;  // that are compared
  std::vector<double> gyration;     // m, of every body
};
/// Of the named bodies, or all. Throws std::invalid_argument for a name there is not.
Yardstick yardstick_for(const engine::Model& model, Measure measure, const std::vector<std::string>& bodies);

/// D; not a number when they have other output times.
double distance(const Yardstick& by, const structures::Trajectory& a, const structures::Trajectory& b);
/// L
double largest_way(const Yardstick& by, const structures::Trajectory& reference);
/// m/s, the greatest mean speed between two output times, turning (ρ θ') included.
double greatest_speed(const Yardstick& by, const structures::Trajectory& reference);

}  // namespace dougong::app
