// A prescribed motion: how a terrain moves, as one function of time.
//
// displacement, velocity and acceleration are absolute, in an inertial frame, and belong together:
// velocity is the derivative of displacement and acceleration that of velocity, at every t.
#pragma once

#include "engine/vec2.h"

namespace dougong::engine {

struct MotionSample {
  Vec2 displacement;  // m
  Vec2 velocity;      // m/s
  Vec2 acceleration;  // m/s2
};

class PrescribedMotion {
 public:
  virtual ~PrescribedMotion() = default;
  virtual MotionSample at(double t) const = 0;
  /// Interval between the knots where the motion is not smooth (s); 0 when it is smooth everywhere.
  /// A time step should divide it: a step that straddles a knot loses its order.
  virtual double knot_interval() const { return 0.0; }
};

}  // namespace dougong::engine
