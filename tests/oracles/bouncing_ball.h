// A ball that is dropped on a rigid floor.
//
// With a coefficient of restitution e every impact is instantaneous: v -> e v, and the flights shorten as a
// geometric series that ends at t = sqrt(2h/g) (1 + e)/(1 - e).
// On a spring and dashpot that never pulls, contact is integrated in time until the force is zero, found by
// bisection; the restitution is that of the speed at the floor's level, which it has yet to rise to.
#pragma once

#include <cmath>

namespace dougong::oracles {

struct BouncingBall {
  double clearance, restitution, g;

  double fall_time() const { return std::sqrt(2.0 * clearance / g); }
  /// n = 0 is the end of the first fall.
  double impact_time(int n) const {
    const double e = restitution;
    return fall_time() * (1.0 + 2.0 * e * (1.0 - std::pow(e, n)) / (1.0 - e));
  }
  double apex_after(int n) const { return clearance * std::pow(restitution, 2 * (n + 1)); }
  double rest_time() const { return fall_time() * (1.0 + restitution) / (1.0 - restitution); }
};

struct CompliantImpact {
  double restitution, penetration, duration;  // -, m, s
};

/// A mass that meets spring k and dashpot 2 zeta sqrt(k m) at the speed of a fall through `clearance`.
struct BallOnSpring {
  double mass, stiffness, damping_ratio, clearance, g;

  CompliantImpact impact(double dt = 1e-6) const {
    const double w = std::sqrt(stiffness / mass), v0 = std::sqrt(2.0 * g * clearance);
    State s{0.0, v0};
    CompliantImpact result{0.0, 0.0, 0.0};
    for (State next = after(s, dt, w); force(next, w) > 0.0; next = after(s, dt, w)) {
      s = next, result.duration += dt;
      if (s.x > result.penetration) result.penetration = s.x;
    }
    double low = 0.0, high = dt;
    for (int i = 0; i < 50; ++i) {
      const double middle = 0.5 * (low + high);
      (force(after(s, middle, w), w) > 0.0 ? low : high) = middle;
    }
    result.duration += low;
    const State end = after(s, low, w);
    result.restitution = std::sqrt(end.v * end.v - 2.0 * g * end.x) / v0;
    return result;
  }

 private:
  struct State {
    double x, v;  // overlap and its rate
  };
  double force(State s, double w) const { return w * w * s.x + 2.0 * damping_ratio * w * s.v; }
  State after(State s, double dt, double w) const {  // RK4
    const auto a = [&](State y) { return g - force(y, w); };
    const State y1 = s, y2{s.x + 0.5 * dt * y1.v, s.v + 0.5 * dt * a(y1)};
    const State y3{s.x + 0.5 * dt * y2.v, s.v + 0.5 * dt * a(y2)};
    const State y4{s.x + dt * y3.v, s.v + dt * a(y3)};
    return {s.x + dt / 6.0 * (y1.v + 2.0 * (y2.v + y3.v) + y4.v),
            s.v + dt / 6.0 * (a(y1) + 2.0 * (a(y2) + a(y3)) + a(y4))};
  }
};

}  // namespace dougong::oracles
