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

#include "engine/integrators/integrator.h"

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
    const std::size_t n = q.size();
    resize(n);
    const Powers p1 = system.accelerate(t, q, v, a_[0], true);
    for (std::size_t i = 0; i < n; ++i) v_[0][i] = v[i];
    const Powers p2 = stage(system, t + 0.5 * h, 0.5 * h, q, v, 1);
    const Powers p3 = stage(system, t + 0.5 * h, 0.5 * h, q, v, 2);
    const Powers p4 = stage(system, t + h, h, q, v, 3);
    for (std::size_t i = 0; i < n; ++i) {
      q[i] += h / 6.0 * (v_[0][i] + 2.0 * (v_[1][i] + v_[2][i]) + v_[3][i]);
      v[i] += h / 6.0 * (a_[0][i] + 2.0 * (a_[1][i] + a_[2][i]) + a_[3][i]);
    }
    return (h / 6.0) * (p1 + 2.0 * (p2 + p3) + p4);
  }

  void restart() {}

 private:
  // The least distance from the origin to the boundary of the stability region in the left half-plane is
  // 2.6 (found by sampling |1 + z + z^2/2 + z^3/6 + z^4/24| = 1); 2.5 leaves a little.
  static constexpr double left_radius = 2.5;

  void resize(std::size_t n) {
    for (auto* set : {&a_, &v_})
      for (auto& x : *set) x.resize(n);
    q_.resize(n);
  }

  template <SecondOrderSystem S>
  Powers stage(S& system, double t, double dt, std::span<const double> q, std::span<const double> v,
               std::size_t k) {
    for (std::size_t i = 0; i < q.size(); ++i) {
      q_[i] = q[i] + dt * v_[k - 1][i];
      v_[k][i] = v[i] + dt * a_[k - 1][i];
    }
    return system.accelerate(t, q_, v_[k], a_[k], false);
  }

  std::array<std::vector<double>, 4> a_, v_;
  std::vector<double> q_;
};

}  // namespace dougong::engine
