// Velocity Verlet with the damping treated centrally:
//     v(n+1/2) = v(n) + h/2 a(n),    q(n+1) = q(n) + h v(n+1/2)
//     a(n+1)   = a(t_(n+1), q(n+1), v(n) + h a(n))
//     v(n+1)   = v(n+1/2) + h/2 a(n+1)
//
// Forces of velocity see the velocity predicted for the end of the step, not the one half a step ago, so
// the method stays of order 2 with dashpots (the half-step velocity would make it order 1).
// With W the trapezoidal work of the forces along the displacements the kinetic energy obeys
//     T(n+1) - T(n) = W + h^2/8 (|a(n+1)|^2_m - |a(n)|^2_m),    |a|^2_m = sum m a^2
// exactly: T less h^2/8 |a|^2_m, the kinetic energy by the two half steps, is what the work balances.
// One evaluation a step. Undamped limit omega h = 2; the amplitude factor of the damped oscillator
// reaches -1 at w2 h^2 + 4 c h = 4, so h < 2 (-c + sqrt(c^2 + w2)) / w2 = 2 / (c + sqrt(c^2 + w2)).
// Groot and Warren, J. Chem. Phys. 107 (1997) 4423-4435, eq. 22 with lambda = 1.
#pragma once

#include <cmath>
#include <utility>

#include "engine/integrators/integrator.h"

namespace dougong::engine {

class VelocityVerlet {
 public:
  static constexpr IntegratorTraits traits{"velocity-verlet", 2, 2, 1, true, 2.0};

  static double stable_step(double w2, double c) { return 2.0 / (c + std::sqrt(c * c + w2)); }

  template <SecondOrderSystem S>
  Powers step(S& system, double t, double h, std::span<double> q, std::span<double> v) {
    if (!ready_) begin(system, t, q, v);
    for (std::size_t i = 0; i < q.size(); ++i) {
      predicted_[i] = v[i] + h * a_[i];
      v[i] += 0.5 * h * a_[i];
      q[i] += h * v[i];
    }
    system.accelerate(t + h, q, predicted_, a_, true);
    for (std::size_t i = 0; i < q.size(); ++i) v[i] += 0.5 * h * a_[i];
    Powers work = system.work();
    const double before = std::exchange(square_, square_of(system));
    work.values[4] = 0.125 * h * h * (square_ - before);
    return work;
  }

  void restart() { ready_ = false; }

 private:
  template <SecondOrderSystem S>
  void begin(S& system, double t, std::span<const double> q, std::span<const double> v) {
    a_.resize(q.size());
    predicted_.resize(q.size());
    system.accelerate(t, q, v, a_, true);
    square_ = square_of(system);
    ready_ = true;
  }

  template <class S>
  double square_of(const S& system) const {
    if constexpr (requires { system.weighted_square(a_); })
      return system.weighted_square(a_);
    else
      return 0.0;
  }

  std::vector<double> a_, predicted_;
  double square_ = 0.0;  // of a_
  bool ready_ = false;
};

}  // namespace dougong::engine
