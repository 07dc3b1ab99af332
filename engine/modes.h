// Small vibrations about the present state, every touching contact stuck that has any friction.
//
// Tangent stiffness: K = sum over points of  kn dg dg' - N d2g + kt ds ds',  g the gap, s the slip, N the
// force. The second derivative of the gap carries the weight's overturning (P-Delta). Gravity itself is
// linear in the coordinates and the friction springs' own curvature is left out (it needs T/N of the
// order of the contact's strain to matter).
// Modes: K phi = omega^2 M phi by Lanczos with shift and invert, started from M r (r = 1 for every
// horizontal coordinate), which finds the modes that a horizontal motion excites.
#pragma once

#include <Eigen/SparseCore>

#include "engine/state.h"

namespace dougong::engine {

struct Mode {
  double angular_frequency_squared = 0.0;  // rad2/s2; negative when the state is not a stable equilibrium
  double participation = 0.0;              // effective horizontal mass over the total mass, 0..1
  std::vector<double> shape;               // [x | y | angle], mass-normalised
  double period() const;                   // s; 0 for an unstable mode
};

/// In the order [x | y | angle] of the state.
Eigen::SparseMatrix<double> tangent_stiffness(const Model& model, const State& state);

/// At most `count` modes in order of frequency. Empty when the stiffness cannot be factorised.
std::vector<Mode> horizontal_modes(const Model& model, const State& state, std::size_t count = 6);

}  // namespace dougong::engine
