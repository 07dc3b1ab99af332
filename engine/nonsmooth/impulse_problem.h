// Rigid contacts over one step: which impulses keep bodies apart and hold or brake their sliding.
//
//     M (v - v_free) = J' P,    u = J v                                       momentum; relative velocities
//     0 <= P_N  _|_  u_N + b_N >= 0                                           Signorini
//     |P_T| <= mu P_N,  u_T + b_T = 0 inside,  P_T opposes u_T + b_T outside  Coulomb
//
//   v, v_free (m/s, rad/s) of every body with and without the impulses; terrains have v_free and no
//   inverse mass
//   P (N s) impulse on the corner's body, along the normal and the tangent of its point
//   b (m/s) what the gap, the slip and the restitution ask for (contact_impulses.h)
//
// Unknowns are coupled over the bodies. The residual is that of the natural map,
//     | P - proj(P - (u + b)/w) | w,   w = diagonal of J M^-1 J',
// a velocity (m/s): the greatest by which any point fails its law.
// Acary and Brogliato, Numerical Methods for Nonsmooth Dynamical Systems (2008), ch. 13.
#pragma once

#include <span>
#include <vector>

#include "engine/collision/broad_phase.h"
#include "engine/nonsmooth/plane_velocity.h"

namespace dougong::engine {

struct ImpulsePoint {
  std::uint32_t source = 0;    // index of its contact point
  Index corner = 0, edge = 0;  // bodies or terrains
  Vec2 normal;                 // -, from the edge's body to the corner's
  Vec2 arm_corner, arm_edge;   // m, from the centroids
  double friction = 0.0;       // -
  Vec2 bias;                   // m/s, b along normal (x) and tangent (y)
  Vec2 impulse;                // N s, P likewise: a guess before, the answer after
  Vec2 compliance;             // 1/kg, w
};

struct ImpulseProblem {
  std::size_t bodies = 0;                             // that move; terrains after them
  std::vector<double> inverse_mass, inverse_inertia;  // 1/kg, 1/(kg m2); 0 of terrain
  std::vector<PlaneVelocity> free_velocity, velocity;
  std::vector<ImpulsePoint> points;
};

/// Velocity of the corner's body relative to the edge's at the point: along normal and tangent (m/s).
Vec2 relative_velocity(const ImpulsePoint& point, std::span<const PlaneVelocity> v);
/// Fills in the compliance of every point.
void find_compliances(ImpulseProblem& problem);
/// Velocities that the impulses as they are make of the free ones.
void apply_impulses(ImpulseProblem& problem);
/// Adds one impulse more to the velocities.
void apply_impulse(ImpulseProblem& problem, const ImpulsePoint& point, Vec2 impulse);
/// Greatest residual of any point at the problem's impulses and velocities (m/s).
double residual_of(const ImpulseProblem& problem);

}  // namespace dougong::engine
