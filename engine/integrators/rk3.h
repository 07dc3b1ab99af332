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

#include "engine/integrators/integrator.h"

namespace dougong::engine {

class Rk3 {
 public:
  static constexpr IntegratorTraits traits{"rk3", 3, 3, 3, false, 1.7320508075688772};

  static double stable_step(double w2, double c) {
    return 2.0 * traits.stability_limit / (c + std::sqrt(c * c + 4.0 * w2));
  }

  template <SecondOrderSystem S>
  Powers step(S& system, double t, double h, std::span<double> q, std::span<double> v) {
    const std::size_t n = q.size();
    resize(n);
    const Powers p1 = system.accelerate(t, q, v, a_[0], true);
    for (std::size_t i = 0; i < n; ++i) v_[0][i] = v[i];
    const Powers p2 = stage(system, t + 0.5 * h, 0.5 * h, q, v, 1);
    const Powers p3 = stage(system, t + 0.75 * h, 0.75 * h, q, v, 2);
    for (std::size_t i = 0; i < n; ++i) {
      q[i] += h / 9.0 * (2.0 * v_[0][i] + 3.0 * v_[1][i] + 4.0 * v_[2][i]);
      v[i] += h / 9.0 * (2.0 * a_[0][i] + 3.0 * a_[1][i] + 4.0 * a_[2][i]);
    }
    return (h / 9.0) * (2.0 * p1 + 3.0 * p2 + 4.0 * p3);
  }

  void restart() {}

 private:
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

  std::array<std::vector<double>, 3> a_, v_;
  std::vector<double> q_;
};

}  // namespace dougong::engine
