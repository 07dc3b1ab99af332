// The energy ledger of a scene (J).
//
//   error = (kinetic - stagger + gravity + field + elastic + friction + fracture + damping - input)
//           - (the same at the start)
//
// input, damping and the tangential work are cumulated by the integrator: those with one evaluation a step
// take the trapezoidal rule along the displacements, 1/2 (F(n) + F(n+1)) . (q(n+1) - q(n)), for which the
// kinetic energy of Verlet's method balances exactly,
//     dT = that sum + h^2/8 (|F(n+1)|^2 - |F(n)|^2)/m,
// so that with the kinetic energy less its last term (the stagger, (omega h)^2/4 of a vibration's energy at
// its turning points) dashpots that start with a jump and linear springs make no error; what is left comes
// from springs that close or open within a step. Kinetic, gravity, field and elastic energy are read off the
// state. What drag takes is damping. Friction is the tangential work less what the friction springs store.
// The error is what numerics made or lost: nothing is booked against it.
#pragma once

#include "engine/state.h"

namespace dougong::engine {

struct Energies {
  double input = 0.0, kinetic = 0.0, gravity = 0.0, elastic = 0.0, friction = 0.0, damping = 0.0;
  double field = 0.0;      // of gravitation, charges and the electric field
  double fracture = 0.0;   // lost in bonds: broken, yielded, rubbed
  double agitation = 0.0;  // kinetic energy relative to the ground, or else to the common centre of mass
  double stagger = 0.0;    // of Verlet's kinetic energy: h^2/8 (sum m |a|^2 less that of the start)
  double terms = 0.0;      // of all bodies in gravity, without signs: what rounding is measured by
  double balance() const {
    return kinetic - stagger + gravity + field + elastic + friction + fracture + damping - input;
  }
};

Energies energies_of(const Model& model, const State& state);

/// What the errors of a run are measured by: the greatest sum so far of |input| and of what gravity, the
/// fields, the contacts and the motion of the start gave. A collapse is driven by gravity, whose energy is a
/// hundred times that of the shaking.
class EnergyTurnover {
 public:
  void note(const Energies& energies);
  double turnover() const { return turnover_; }            // J
  double largest_error() const { return largest_error_; }  // J
  double largest_input() const { return largest_input_; }  // J, of |input|
  /// Greatest |error| over the turnover; a scene that turns nothing over, whose error is rounding, is
  /// measured by a millionth of the elastic and kinetic energy it started with, bodies that fly about by the
  /// agitation they started with (between elastic impacts all of it is kinetic); bodies that orbit, which
  /// turn all of theirs over and gain nothing, by the energy of the fields at the start; at least by 1e-9 of
  /// the terms in gravity. 0 when there is none.
  double relative_error() const;
  /// Error of the energies noted last (J).
  double error() const { return error_; }

 private:
  bool started_ = false;
  Energies first_;
  double turnover_ = 0.0, largest_error_ = 0.0, largest_input_ = 0.0, error_ = 0.0;
};

}  // namespace dougong::engine
