// Frictionless impacts of two free rigid bodies: impulse J = (1 + e) u / (1/m_a + 1/m_b + s_a^2/I_a +
// s_b^2/I_b) along the normal, u the speed of approach and s the arms of the normal about the centroids
// (Newton).
#pragma once

#include <cmath>

namespace dougong::oracles {

struct Vector {
  double x, y;
};

struct AfterImpact {
  Vector first, second;  // m/s
};

/// Two discs; `direction` is the angle of the normal from the first to the second.
struct DiscImpact {
  double mass1, mass2;
  Vector velocity1, velocity2;
  double direction, restitution;

  AfterImpact after() const {
    const double nx = std::cos(direction), ny = std::sin(direction);
    const double approach = (velocity1.x - velocity2.x) * nx + (velocity1.y - velocity2.y) * ny;
    const double impulse = (1.0 + restitution) * approach / (1.0 / mass1 + 1.0 / mass2);
    return {{velocity1.x - impulse / mass1 * nx, velocity1.y - impulse / mass1 * ny},
            {velocity2.x + impulse / mass2 * nx, velocity2.y + impulse / mass2 * ny}};
  }
};

/// A disc at `speed` along the normal of a free rod of `length` x `depth`, `arm` from the rod's centre.
struct RodImpact {
  double disc_mass, rod_mass, length, depth, arm, speed, restitution;

  double inertia() const { return rod_mass * (length * length + depth * depth) / 12.0; }
  double impulse() const {
    return (1.0 + restitution) * speed / (1.0 / disc_mass + 1.0 / rod_mass + arm * arm / inertia());
  }
  double disc_speed() const { return speed - impulse() / disc_mass; }
  double rod_speed() const { return impulse() / rod_mass; }
  double rod_spin() const { return impulse() * arm / inertia(); }
};

}  // namespace dougong::oracles
