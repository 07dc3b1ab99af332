#include "engine/nonsmooth/cone_descent.h"
#include <cstdlib>

#include <algorithm>
#include <cmath>

namespace dougong::engine {
namespace {

constexpr std::size_t most_iterations = 200;
struct Projection {
  Vec2 impulse;
  int face;  // 0 inside, 1 and -1 on the faces of positive and negative friction, 2 at the tip
};

Projection project_on_cone(Vec2 z, double friction) {
  if (std::abs(z.y) <= friction * z.x) return {z, 0};
  if (friction * std::abs(z.y) <= -z.x) return {{}, 2};
  const double side = z.y > 0.0 ? friction : -friction;
  const double along = (z.x + side * z.y) / (1.0 + side * side);
  return {{along, side * along}, z.y > 0.0 ? 1 : -1};
}

}  // namespace

void ConeDescent::hold(const ImpulseProblem& problem, double kappa) {
  points_.resize(problem.points.size());
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const ImpulsePoint& p = problem.points[i];
    Point& q = points_[i];
    q.rho = kappa / std::max(p.compliance.x, p.compliance.y);
    q.velocity = relative_velocity(p, problem.velocity);
    const double slides = p.friction * std::abs(q.velocity.y + p.bias.y);
    q.slides = fresh_ ? slides : 0.5 * (q.slides + slides);
    q.target = p.impulse - q.rho * (p.bias + Vec2{q.slides, 0.0});
  }
}

void ConeDescent::project(const ImpulseProblem& problem) {
  for (std::size_t i = 0; i < points_.size(); ++i) {
    Point& q = points_[i];
    const Projection projection = project_on_cone(q.target - q.rho * q.velocity, problem.points[i].friction);
    q.impulse = projection.impulse;
    q.side = projection.face == 0   ? Side::inside
             : projection.face == 2 ? Side::outside
             : projection.face > 0  ? Side::forward
                                    : Side::back;
  }
}

// Minus the gradient, in direction_; returns the greatest velocity that it would change (m/s).
double ConeDescent::find_gradient(const ImpulseProblem& problem) {
  direction_.assign(problem.velocity.size(), {});
  for (std::size_t i = 0; i < problem.bodies; ++i) {
    const PlaneVelocity &v = problem.velocity[i], &f = problem.free_velocity[i];
    direction_[i] = {(f.x - v.x) / problem.inverse_mass[i], (f.y - v.y) / problem.inverse_mass[i],
                     (f.spin - v.spin) / problem.inverse_inertia[i]};
  }
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const ImpulsePoint& p = problem.points[i];
    const Vec2 force = points_[i].impulse.x * p.normal + points_[i].impulse.y * turned(p.normal);
    PlaneVelocity &c = direction_[p.corner], &e = direction_[p.edge];
    if (p.corner < problem.bodies) c.x += force.x, c.y += force.y, c.spin += cross(p.arm_corner, force);
    if (p.edge < problem.bodies) e.x -= force.x, e.y -= force.y, e.spin -= cross(p.arm_edge, force);
  }
  double greatest = 0.0;
  for (std::size_t i = 0; i < problem.bodies; ++i)
    greatest = std::max({greatest, std::abs(direction_[i].x) * problem.inverse_mass[i],
                         std::abs(direction_[i].y) * problem.inverse_mass[i]});
  return greatest;
}

bool ConeDescent::find_direction(const ImpulseProblem& problem, ContactMatrix& matrix) {
  matrix.set_mass(problem);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Point& q = points_[i];
    if (q.side == Side::outside) continue;
    const double mu = q.side == Side::forward ? problem.points[i].friction : -problem.points[i].friction;
    const double g = q.rho / (1.0 + mu * mu);
    matrix.add(problem.points[i], q.side == Side::inside ? PointGain{q.rho, 0.0, 0.0, q.rho}
                                                         : PointGain{g, g * mu, g * mu, g * mu * mu});
  }
  if (!matrix.factorise()) return false;
  matrix.solve(direction_);
  for (std::size_t i = 0; i < points_.size(); ++i)
    points_[i].turn = relative_velocity(problem.points[i], direction_);
  return true;
}

// Derivative of the function along the direction of search.
double ConeDescent::slope_at(const ImpulseProblem& problem, double way) const {
  double slope = 0.0;
  for (std::size_t i = 0; i < problem.bodies; ++i) {
    const PlaneVelocity &v = problem.velocity[i], &f = problem.free_velocity[i], &d = direction_[i];
    slope += (d.x * (v.x + way * d.x - f.x) + d.y * (v.y + way * d.y - f.y)) / problem.inverse_mass[i] +
             d.spin * (v.spin + way * d.spin - f.spin) / problem.inverse_inertia[i];
  }
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Point& q = points_[i];
    const Vec2 z = q.target - q.rho * (q.velocity + way * q.turn);
    slope -= dot(project_on_cone(z, problem.points[i].friction).impulse, q.turn);
  }
  return slope;
}

// The slope rises along the way: its root by false position (Illinois).
double ConeDescent::search(const ImpulseProblem& problem) const {
  const double start = slope_at(problem, 0.0);
  double low = 0.0, low_slope = start, high = 1.0, high_slope = slope_at(problem, 1.0);
  if (high_slope <= -0.1 * start) return high;
  double way = 1.0;
  for (int tries = 0; tries < 20; ++tries) {
    way = (low * high_slope - high * low_slope) / (high_slope - low_slope);
    const double slope = slope_at(problem, way);
    if (std::abs(slope) <= -0.1 * start) break;
    if (slope > 0.0)
      high = way, high_slope = slope, low_slope *= 0.5;
    else
      low = way, low_slope = slope, high_slope *= 0.5;
  }
  return way;
}

std::size_t ConeDescent::step(ImpulseProblem& problem, ContactMatrix& matrix, double kappa,
                              double tolerance) {
  hold(problem, kappa);
  fresh_ = false;
  project(problem);
  std::size_t iterations = 0;
  for (double left = find_gradient(problem); iterations < most_iterations && left > tolerance; ++iterations) {
    if (!find_direction(problem, matrix)) break;
    const double way = search(problem);
    for (std::size_t i = 0; i < problem.bodies; ++i) {
      PlaneVelocity& v = problem.velocity[i];
      v.x += way * direction_[i].x, v.y += way * direction_[i].y, v.spin += way * direction_[i].spin;
    }
    for (Point& q : points_) q.velocity += way * q.turn;
    project(problem);
    left = find_gradient(problem);
  }
  for (std::size_t i = 0; i < points_.size(); ++i) problem.points[i].impulse = points_[i].impulse;
  apply_impulses(problem);
  return iterations;
}

}  // namespace dougong::engine
