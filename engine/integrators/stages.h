// The stages of an explicit Runge-Kutta method on (q, v) whose stages each start from the one before: the
// lower diagonal is all its tableau has.
#pragma once

#include <array>

#include "engine/integrators/integrator.h"

namespace dougong::engine {

template <std::size_t count>
class Stages {
 public:
  /// Stage 0: the system at the beginning of the step.
  template <SecondOrderSystem S>
  Powers first(S& system, double t, std::span<const double> q, std::span<const double> v) {
    for (auto* set : {&velocity_, &acceleration_})
      for (auto& x : *set) x.resize(q.size());
    q_.resize(q.size());
    for (std::size_t i = 0; i < q.size(); ++i) velocity_[0][i] = v[i];
    return system.accelerate(t, q, v, acceleration_[0], true);
  }

  /// Stage k > 0, at t + dt: q + dt v(k-1), v + dt a(k-1).
  template <SecondOrderSystem S>
  Powers next(S& system, double t, double dt, std::span<const double> q, std::span<const double> v,
              std::size_t k) {
    for (std::size_t i = 0; i < q.size(); ++i) {
      q_[i] = q[i] + dt * velocity_[k - 1][i];
      velocity_[k][i] = v[i] + dt * acceleration_[k - 1][i];
    }
    return system.accelerate(t + dt, q_, velocity_[k], acceleration_[k], false);
  }

  double velocity(std::size_t k, std::size_t i) const { return velocity_[k][i]; }
  double acceleration(std::size_t k, std::size_t i) const { return acceleration_[k][i]; }

 private:
  std::array<std::vector<double>, count> velocity_, acceleration_;
  std::vector<double> q_;
};

}  // namespace dougong::engine
