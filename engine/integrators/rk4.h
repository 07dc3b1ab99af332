// The classical Runge-Kutta method of order 4 on (q, v).
//
//     0   |
//     1/2 | 1/2
//     1/2 | 0    1/2
//     1   | 0    0    1
//         | 1/6  1/3  1/3  1/6
//
// Four evaluations a step. Undamped limit omega h = 2 sqrt(2). With damping: the stability region holds
// the part of the left half-plane within radius 2.5 of the origin, and |lambda| of q'' + c q' + w2 q = 0
// is at most (c + sqrt(c^2 + 4 w2)) / 2.
// Kutta, Z. Math. Phys. 46 (1901) 435-453.
#pragma once

#include <algorithm>
#include <cmath>

#include "engine/integrators/stages.h"

namespace dougong::engine {

class Rk4 {
 public:
  static constexpr IntegratorTraits traits{"rk4", 4, 4, 4, false, 2.8284271247461903};

  static double stable_step(double w2, double c) {
    const double undamped = traits.stability_limit / std::sqrt(w2);
    return c == 0.0 ? undamped : std::min(undamped, 2.0 * left_radius / (c + std::sqrt(c * c + 4.0 * w2)));
  }

  template <SecondOrderSystem S>
  Powers step(S& system, double t, double h, std::span<double> q, std::span<double> v) {
    const Powers p1 = stages_.first(system, t, q, v);
    const Powers p2 = stages_.next(system, t, 0.5 * h, q, v, 1);
    const Powers p3 = stages_.next(system, t, 0.5 * h, q, v, 2);
    const Powers p4 = stages_.next(system, t, h, q, v, 3);
    const auto combined = [](auto&& of) { return of(0) + 2.0 * (of(1) + of(2)) + of(3); };
    for (std::size_t i = 0; i < q.size(); ++i) {
      q[i] += h / 6.0 * combined([&](std::size_t k) { return stages_.velocity(k, i); });
      v[i] += h / 6.0 * combined([&](std::size_t k) { return stages_.acceleration(k, i); });
    }
    return (h / 6.0) * (p1 + 2.0 * (p2 + p3) + p4);
  }

  void restart() {}

 private:
  // The least distance from the origin to the boundary of the stability region in the left half-plane is
  // 2.6 (found by sampling |1 + z + z^2/2 + z^3/6 + z^4/24| = 1); 2.5 leaves a little.
  static constexpr double left_radius = 2.5;

  Stages<4> stages_;
};

}  // namespace dougong::engine
