// Leapfrog, drift-kick-drift, with a predicted velocity for dashpots:
//     q(n+1/2) = q(n) + h/2 v(n),   v~ = v(n) + h/2 a(n-1/2)
//     v(n+1)   = v(n) + h a(t_n + h/2, q(n+1/2), v~),   q(n+1) = q(n+1/2) + h/2 v(n+1)
//
// v~ is the velocity of mid-step up to O(h^2), so the order stays 2 with damping. The first step predicts
// with a(0). Its step has the characteristic polynomial of velocity Verlet, so its limits too:
// w2 h^2 + 4 c h < 4 (docs/theory/integrators.md). Work is the mid-step force along the step, which is what
// the kinetic energy gains exactly. Contacts are seen at mid-steps.
// Hairer, Lubich and Wanner, Geometric Numerical Integration, 2nd ed. (2006), I.1.4.
#pragma once

#include <cmath>

#include "engine/integrators/integrator.h"

namespace dougong::engine {

class Leapfrog {
 public:
  static constexpr IntegratorTraits traits{"leapfrog", 2, 2, 1, true, 2.0};

  static double stable_step(double w2, double c) { return 2.0 / (c + std::sqrt(c * c + w2)); }

  template <SecondOrderSystem S>
  Powers step(S& system, double t, double h, std::span<double> q, std::span<double> v) {
    if (!ready_) begin(system, t, q, v);
    for (std::size_t i = 0; i < q.size(); ++i) {
      q[i] += 0.5 * h * v[i];
      predicted_[i] = v[i] + 0.5 * h * a_[i];
    }
    const Powers powers = system.accelerate(t + 0.5 * h, q, predicted_, a_, true);
    for (std::size_t i = 0; i < q.size(); ++i) {
      v[i] += h * a_[i];
      q[i] += 0.5 * h * v[i];
    }
    return h * powers;
  }

  void restart() { ready_ = false; }

 private:
  template <SecondOrderSystem S>
  void begin(S& system, double t, std::span<const double> q, std::span<const double> v) {
    a_.resize(q.size());
    predicted_.resize(q.size());
    system.accelerate(t, q, v, a_, true);
    ready_ = true;
  }

  std::vector<double> a_, predicted_;
  bool ready_ = false;
};

}  // namespace dougong::engine
