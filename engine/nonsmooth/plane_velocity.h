// The three velocities of a plane body: what an impulse changes.
#pragma once

namespace dougong::engine {

struct PlaneVelocity {
  double x = 0.0, y = 0.0, spin = 0.0;  // m/s, m/s, rad/s
};

}  // namespace dougong::engine
