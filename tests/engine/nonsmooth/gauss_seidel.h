// Plain projected Gauss-Seidel on rigid contacts, to compare with: every point in turn meets its own law.
#pragma once

#include <algorithm>

#include "engine/nonsmooth/impulse_problem.h"

namespace dougong::testing {

inline void sweep(engine::ImpulseProblem& problem) {
  for (engine::ImpulsePoint& p : problem.points) {
    const engine::Vec2 before = p.impulse;
    const double un = relative_velocity(p, problem.velocity).x;
    p.impulse.x = std::max(0.0, before.x - (un + p.bias.x) / p.compliance.x);
    apply_impulse(problem, p, {p.impulse.x - before.x, 0.0});
    const double ut = relative_velocity(p, problem.velocity).y, limit = p.friction * p.impulse.x;
    p.impulse.y = std::clamp(before.y - (ut + p.bias.y) / p.compliance.y, -limit, limit);
    apply_impulse(problem, p, {0.0, p.impulse.y - before.y});
  }
}

/// Residual (m/s) after a number of sweeps from no impulses.
inline double residual_after_sweeps(engine::ImpulseProblem& problem, int sweeps) {
  for (engine::ImpulsePoint& p : problem.points) p.impulse = {};
  find_compliances(problem);
  apply_impulses(problem);
  for (int i = 0; i < sweeps; ++i) sweep(problem);
  return residual_of(problem);
}

}  // namespace dougong::testing
