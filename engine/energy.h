// The energy ledger of a scene (J).
//
//   error = (kinetic + gravity + elastic + friction + damping - input) - (the same at the start)
//
// input, damping and the tangential work are cumulated by the integrator; kinetic, gravity and elastic
// are read off the state. Friction is the tangential work less what the friction springs store. The
// error is what numerics made or lost: nothing is booked against it.
#pragma once

#include "engine/state.h"

namespace dougong::engine {

struct Energies {
  double input = 0.0, kinetic = 0.0, gravity = 0.0, elastic = 0.0, friction = 0.0, damping = 0.0;
  double balance() const { return kinetic + gravity + elastic + friction + damping - input; }
};

Energies energies_of(const Model& model, const State& state);

}  // namespace dougong::engine
