// Symplectic (semi-implicit) Euler, kick then drift:
//     v(n+1) = v(n) + h a(t_n, q(n), v(n)),   q(n+1) = q(n) + h v(n+1)
//
// Order 1, one evaluation, symplectic for forces of position only. With explicit dashpots the amplitude
// factor reaches -1 at w2 h^2 + 2 c h = 4, so h < (-c + sqrt(c^2 + 4 w2)) / w2 = 4 / (c + sqrt(c^2 + 4 w2)).
// Hairer, Lubich and Wanner, Geometric Numerical Integration, 2nd ed. (2006), eq. I.1.9.
#pragma once

#include <cmath>

#include "engine/integrators/integrator.h"

namespace dougong::engine {

class SymplecticEuler {
 public:
  static constexpr IntegratorTraits traits{"symplectic-euler", 1, 1, 1, true, 2.0};

  static double stable_step(double w2, double c) { return 4.0 / (c + std::sqrt(c * c + 4.0 * w2)); }

  template <SecondOrderSystem S>
  Powers step(S& system, double t, double h, std::span<double> q, std::span<double> v) {
    a_.resize(q.size());
    system.accelerate(t, q, v, a_, true);
    for (std::size_t i = 0; i < q.size(); ++i) {
      v[i] += h * a_[i];
      q[i] += h * v[i];
    }
    return system.work();
  }

  void restart() {}

 private:
  std::vector<double> a_;
};

}  // namespace dougong::engine
