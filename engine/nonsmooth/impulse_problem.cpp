#include "engine/nonsmooth/impulse_problem.h"

#include <algorithm>
#include <cmath>

namespace dougong::engine {
namespace {

double compliance_along(const ImpulseProblem& problem, const ImpulsePoint& p, Vec2 direction) {
  const double rc = cross(p.arm_corner, direction), re = cross(p.arm_edge, direction);
  return problem.inverse_mass[p.corner] + problem.inverse_mass[p.edge] +
         rc * rc * problem.inverse_inertia[p.corner] + re * re * problem.inverse_inertia[p.edge];
}

// What each of the two laws makes of an impulse when its own relative velocity is corrected.
Vec2 projected(const ImpulsePoint& p, Vec2 u) {
  const double normal = std::max(0.0, p.impulse.x - (u.x + p.bias.x) / p.compliance.x);
  const double limit = p.friction * normal;
  return {normal, std::clamp(p.impulse.y - (u.y + p.bias.y) / p.compliance.y, -limit, limit)};
}

}  // namespace

Vec2 relative_velocity(const ImpulsePoint& p, std::span<const PlaneVelocity> v) {
  const PlaneVelocity &c = v[p.corner], &e = v[p.edge];
  const Vec2 u{c.x - e.x - c.spin * p.arm_corner.y + e.spin * p.arm_edge.y,
               c.y - e.y + c.spin * p.arm_corner.x - e.spin * p.arm_edge.x};
  return {dot(p.normal, u), dot(turned(p.normal), u)};
}

void find_compliances(ImpulseProblem& problem) {
  for (ImpulsePoint& p : problem.points)
    p.compliance = {compliance_along(problem, p, p.normal), compliance_along(problem, p, turned(p.normal))};
}

void apply_impulse(ImpulseProblem& problem, const ImpulsePoint& p, Vec2 impulse) {
  const Vec2 force = impulse.x * p.normal + impulse.y * turned(p.normal);
  PlaneVelocity &c = problem.velocity[p.corner], &e = problem.velocity[p.edge];
  c.x += problem.inverse_mass[p.corner] * force.x, c.y += problem.inverse_mass[p.corner] * force.y;
  c.spin += problem.inverse_inertia[p.corner] * cross(p.arm_corner, force);
  e.x -= problem.inverse_mass[p.edge] * force.x, e.y -= problem.inverse_mass[p.edge] * force.y;
  e.spin -= problem.inverse_inertia[p.edge] * cross(p.arm_edge, force);
}

void apply_impulses(ImpulseProblem& problem) {
  std::copy(problem.free_velocity.begin(), problem.free_velocity.end(), problem.velocity.begin());
  for (const ImpulsePoint& p : problem.points)
    if (p.impulse.x != 0.0 || p.impulse.y != 0.0) apply_impulse(problem, p, p.impulse);
}

double residual_of(const ImpulseProblem& problem) {
  double worst = 0.0;
  for (const ImpulsePoint& p : problem.points) {
    const Vec2 wanted = projected(p, relative_velocity(p, problem.velocity));
    const double normal = std::abs(wanted.x - p.impulse.x) * p.compliance.x;
    const double tangential = std::abs(wanted.y - p.impulse.y) * p.compliance.y;
    // Written so that a residual that is not a number is not lost.
    if (!(normal <= worst)) worst = normal;
    if (!(tangential <= worst)) worst = tangential;
  }
  return worst;
}

}  // namespace dougong::engine
