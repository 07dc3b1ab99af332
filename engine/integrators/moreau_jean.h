// Moreau and Jean's time stepping for rigid contacts, theta = 1/2: impulses in place of stiffness.
//     q(n+1/2) = q(n) + h/2 v(n),   v~ = v(n) + h/2 a(n-1/2)
//     v(n+1)   = v(n) + h a(t_n + h/2, q(n+1/2), v~) + M^-1 J' P,   q(n+1) = q(n) + h/2 (v(n) + v(n+1))
//
// a are the smooth accelerations: gravity, fields, drag, springs. P are the impulses of the contacts over the
// step, impacts included: they obey the laws of contact at the level of velocities, with J, gaps and slips at
// mid-step (nonsmooth/contact_impulses.h). There is no stiffness, so contacts bound no step; springs do, as
// under leapfrog, which this is where nothing touches. An impact is found to within a step: the order of
// contact is 1.
// Moreau, in Moreau and Panagiotopoulos (eds.), Nonsmooth Mechanics and Applications (1988); Jean, Comput.
// Methods Appl. Mech. Engrg. 177 (1999) 235-257; Acary and Brogliato (2008), ch. 10.
#pragma once

#include <algorithm>
#include <cmath>

#include "engine/integrators/integrator.h"

namespace dougong::engine {

/// What a system with rigid contacts offers besides: after accelerate() at the mid-step, adds the impulses
/// over the step to v, whose value at the step's start was `before`. Returns their works (J).
template <class S>
concept HasImpulses = requires(S s, double t, double h, std::span<const double> before, std::span<double> v) {
  { s.add_impulses(t, h, before, v) } -> std::same_as<Powers>;
};

class MoreauJean {
 public:
  static constexpr IntegratorTraits traits{"moreau-jean", 2, 2, 1, true, 2.0, false, true, 1e-3};

  static double stable_step(double w2, double c) { return 2.0 / (c + std::sqrt(c * c + w2)); }

  template <SecondOrderSystem S>
  Powers step(S& system, double t, double h, std::span<double> q, std::span<double> v) {
    if (!ready_) begin(system, t, q, v);
    for (std::size_t i = 0; i < q.size(); ++i) {
      before_[i] = v[i];
      q[i] += 0.5 * h * v[i];
      predicted_[i] = v[i] + 0.5 * h * a_[i];
    }
    Powers work = h * system.accelerate(t + 0.5 * h, q, predicted_, a_, true);
    for (std::size_t i = 0; i < q.size(); ++i) v[i] += h * a_[i];
    if constexpr (HasImpulses<S>) work = work + system.add_impulses(t + 0.5 * h, h, before_, v);
    for (std::size_t i = 0; i < q.size(); ++i) q[i] += 0.5 * h * v[i];
    return work;
  }

  void restart() { ready_ = false; }

 private:
  template <SecondOrderSystem S>
  void begin(S& system, double t, std::span<const double> q, std::span<const double> v) {
    a_.resize(q.size()), before_.resize(q.size()), predicted_.resize(q.size());
    system.accelerate(t, q, v, a_, true);
    ready_ = true;
  }

  std::vector<double> a_, before_, predicted_;
  bool ready_ = false;
};

}  // namespace dougong::engine
