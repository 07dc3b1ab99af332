// Finds the equilibrium of a scene under its own weight before anything shakes it.
//
// The ground is held still and the scene runs with Cundall's local damping until every body's
// unbalanced force is a small part of its weight. What is left of the speed is then taken off. Bonds find
// their rest as if they could not break, and only then have their strength: those break that the weight at
// rest breaks.
#pragma once

#include <limits>

#include "engine/drive.h"

namespace dougong::engine {

struct SettleOptions {
  double longest_time = 20.0;      // s, simulated
  double unbalanced_ratio = 1e-4;  // of the weight
  double local_damping = 0.8;      // Cundall's usual value
  /// A body that has moved further has no equilibrium near by: it is given up (m).
  double longest_movement = std::numeric_limits<double>::infinity();
};

struct SettleReport {
  bool settled = false;
  Outcome outcome = Outcome::completed;
  std::string detail;
  double duration = 0.0;           // s, simulated
  double unbalanced_ratio = 0.0;   // largest net acceleration over gravity
  double greatest_movement = 0.0;  // m
  std::string moved_most;          // name of that body
};

/// Comes to rest under gravity with the terrain held still. Leaves the state at t = 0, with no work done and
/// the velocities that it had before. Without gravity there is nothing to settle.
SettleReport settle(const Model& model, State& state, const SettleOptions& options = {});

}  // namespace dougong::engine
