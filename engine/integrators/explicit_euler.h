// Explicit Euler, for comparison only:
//     q(n+1) = q(n) + h v(n),   v(n+1) = v(n) + h a(t_n, q(n), v(n))
//
// Order 1, one evaluation. |1 + lambda h| > 1 for every undamped vibration: its limit is 0, and drive()
// refuses it there. A damped one, lambda = (-c +- sqrt(c^2 - 4 w2))/2, is stable for h < c/w2 (c^2 < 4 w2)
// and h < 2/|lambda| (else); 2/c suits every softer mode of that damping. For modes damped in proportion to
// their stiffness, as by contacts, c/w2 is the same for all; a mode with less damping still grows.
// Euler, Institutionum calculi integralis (1768), vol. 1, par. 650.
#pragma once

#include <cmath>
#include <limits>

#include "engine/integrators/integrator.h"

namespace dougong::engine {

class ExplicitEuler {
 public:
  static constexpr IntegratorTraits traits{"explicit-euler", 1, 1, 1, false, 0.0};

  static double stable_step(double w2, double c) {
    if (w2 == 0.0) return c == 0.0 ? std::numeric_limits<double>::infinity() : 2.0 / c;
    return c * c < 2.0 * w2 ? c / w2 : 2.0 / c;
  }

  template <SecondOrderSystem S>
  Powers step(S& system, double t, double h, std::span<double> q, std::span<double> v) {
    a_.resize(q.size());
    system.accelerate(t, q, v, a_, true);
    for (std::size_t i = 0; i < q.size(); ++i) {
      q[i] += h * v[i];
      v[i] += h * a_[i];
    }
    return system.work();
  }

  void restart() {}

 private:
  std::vector<double> a_;
};

}  // namespace dougong::engine
