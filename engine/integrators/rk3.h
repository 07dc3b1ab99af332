// Ralston's Runge-Kutta method of order 3 on (q, v): the three-stage method of least error bound.
//
//     0   |
//     1/2 | 1/2
//     3/4 | 0    3/4
//         | 2/9  1/3  4/9
//
// Three evaluations a step. R(z) = 1 + z + z^2/2 + z^3/6; |R(iy)|^2 = 1 - y^4/12 + y^6/36 <= 1 for y^2 <= 3.
// The nearest point of the stability region's boundary in the left half-plane is that one, at sqrt(3), and
// |lambda| of q'' + c q' + w2 q = 0 is at most (c + sqrt(c^2 + 4 w2))/2.
// Ralston, Math. Comp. 16 (1962) 431-437, eq. 3.11.
#pragma once

#include <cmath>

#include "engine/integrators/stages.h"

namespace dougong::engine {

class Rk3 {
 public:
  static constexpr IntegratorTraits traits{"rk3", 3, 3, 3, false, 1.7320508075688772};

  static double stable_step(double w2, double c) {
    return 2.0 * traits.stability_limit / (c + std::sqrt(c * c + 4.0 * w2));
  }

  template <SecondOrderSystem S>
  Powers step(S& system, double t, double h, std::span<double> q, std::span<double> v) {
    const Powers p1 = stages_.first(system, t, q, v);
    const Powers p2 = stages_.next(system, t, 0.5 * h, q, v, 1);
    const Powers p3 = stages_.next(system, t, 0.75 * h, q, v, 2);
    const auto combined = [](auto&& of) { return 2.0 * of(0) + 3.0 * of(1) + 4.0 * of(2); };
    for (std::size_t i = 0; i < q.size(); ++i) {
      q[i] += h / 9.0 * combined([&](std::size_t k) { return stages_.velocity(k, i); });
      v[i] += h / 9.0 * combined([&](std::size_t k) { return stages_.acceleration(k, i); });
    }
    return (h / 9.0) * (2.0 * p1 + 3.0 * p2 + 4.0 * p3);
  }

  void restart() {}

 private:
  Stages<3> stages_;
};

}  // namespace dougong::engine
