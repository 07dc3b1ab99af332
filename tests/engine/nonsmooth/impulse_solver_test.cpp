#include "engine/nonsmooth/impulse_solver.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/allocations.h"
#include "tests/engine/nonsmooth/gauss_seidel.h"
#include "tests/scenes/running.h"

namespace dougong::engine {
namespace {

constexpr double step = 1e-3, gravity_step = 9.81 * step;  // s, m/s

// A scene's bodies after a step under gravity and the sideways acceleration given, with all its points.
ImpulseProblem problem_of(const scenes::Running& r, double sideways) {
  ImpulseProblem problem;
  problem.bodies = r.bodies();
  for (std::size_t i = 0; i < r.model.size(); ++i) {
    const bool moves = i < r.bodies();
    problem.inverse_mass.push_back(moves ? 1.0 / r.model.mass[i] : 0.0);
    problem.inverse_inertia.push_back(moves ? 1.0 / r.model.inertia[i] : 0.0);
    problem.free_velocity.push_back(moves ? PlaneVelocity{sideways * step, -gravity_step, 0.0}
                                          : PlaneVelocity{});
  }
  problem.velocity = problem.free_velocity;
  const auto frames = frames_of(r.model, r.state);
  const ContactPoints& points = r.state.contacts.points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PointGeometry g = geometry_of(points, i, frames);
    if (std::abs(g.overlap) > 1e-6) continue;
    ImpulsePoint p;
    p.corner = points.corner_body[i], p.edge = points.edge_body[i];
    p.normal = g.normal, p.arm_corner = g.arm_corner, p.arm_edge = g.arm_edge;
    p.friction = points.stiffness(i).friction;
    problem.points.push_back(p);
  }
  return problem;
}

double fastest(const ImpulseProblem& problem) {
  double speed = 0.0;
  for (std::size_t i = 0; i < problem.bodies; ++i)
    speed = std::max({speed, std::abs(problem.velocity[i].x), std::abs(problem.velocity[i].y)});
  return speed;
}

TEST(ImpulseSolver, HoldsARestingBlockByHalfItsWeightAtEachCorner) {
  const scenes::Running r(scenes::block_on_ground(0.5, 0.2, 0.6));
  ImpulseProblem problem = problem_of(r, 0.0);
  const ImpulseSolution s = ImpulseSolver().solve(problem, gravity_step);
  EXPECT_TRUE(s.converged);
  EXPECT_LT(s.residual, 1e-9);
  for (const ImpulsePoint& p : problem.points) {
    EXPECT_NEAR(p.impulse.x / (0.5 * r.model.mass[0] * gravity_step), 1.0, 1e-9);
    EXPECT_NEAR(p.impulse.y, 0.0, 1e-6);
  }
}

// Pushed sideways by a: sticks below mu g, slides above, tips about its corner above g b/h.
TEST(ImpulseSolver, LetsABlockStickSlideOrTipAsItsProportionsSay) {
  struct Case {
    double b, h, mu, a, sliding, spin;
  };
  const double g = 9.81;
  const double tipping = -0.75 * (0.4 * g * 1.0 - g * 0.25) / (0.0625 + 1.0);
  for (const auto& c :
       {Case{0.5, 0.2, 0.6, 0.5 * g, 0.0, 0.0}, Case{0.5, 0.2, 0.6, 0.8 * g, 0.2 * g, 0.0},
        Case{0.5, 0.2, 0.0, 0.3 * g, 0.3 * g, 0.0}, Case{0.25, 1.0, 2.0, 0.4 * g, -1.0, tipping}}) {
    const scenes::Running r(scenes::block_on_ground(c.b, c.h, c.mu));
    ImpulseProblem problem = problem_of(r, c.a);
    ASSERT_TRUE(ImpulseSolver().solve(problem, gravity_step).converged);
    EXPECT_NEAR(problem.velocity[0].spin / step, c.spin, 1e-5) << c.a;
    if (c.sliding >= 0.0) {
      EXPECT_NEAR(problem.velocity[0].x / step, c.sliding, 1e-5) << c.a;
    }
  }
}

// A wall of 250 bricks, where there are four times as many impulses as freedoms.
TEST(ImpulseSolver, SolvesAWallThatGaussSeidelLeavesCreeping) {
  const scenes::Running r(scenes::wall(12, 20, 0.6));
  ImpulseProblem problem = problem_of(r, 0.0);
  for (const int sweeps : {20, 50, 1000}) {
    const double residual = testing::residual_after_sweeps(problem, sweeps);
    std::printf("wall 12 x 20: %d sweeps of Gauss-Seidel leave %.2g m/s, the fastest brick %.2g m/s\n",
                sweeps, residual, fastest(problem));
    EXPECT_GT(residual, 1e-5);
  }
  for (ImpulsePoint& p : problem.points) p.impulse = {};
  const ImpulseSolution s = ImpulseSolver().solve(problem, gravity_step);
  std::printf(
      "wall 12 x 20: Newton's method leaves %.2g m/s after %zu iterations, the fastest brick %.2g m/s\n",
      s.residual, s.iterations, fastest(problem));
  EXPECT_TRUE(s.converged);
  EXPECT_LT(s.residual, 1e-7 * gravity_step);
  EXPECT_LT(fastest(problem), 1e-7 * gravity_step);
}

// The upper half slides off: the set of statuses goes round in circles and descents take over.
TEST(ImpulseSolver, SolvesAWallThatSlides) {
  for (const double a : {0.5, 0.8, 1.2}) {
    const scenes::Running r(scenes::wall(6, 8, 0.5));
    ImpulseProblem problem = problem_of(r, a * 9.81);
    const ImpulseSolution s = ImpulseSolver().solve(problem, gravity_step);
    std::printf("wall 6 x 8 at %.1f g: residual %.2g m/s, %zu iterations in %zu rounds\n", a, s.residual,
                s.iterations, s.rounds);
    EXPECT_TRUE(s.converged) << a;
    for (const ImpulsePoint& p : problem.points) {
      EXPECT_GE(p.impulse.x, 0.0);
      EXPECT_LE(std::abs(p.impulse.y), 0.5 * p.impulse.x * (1.0 + 1e-9) + 1e-9);
    }
  }
}

TEST(ImpulseSolver, CarriesAMillionTimesItsWeight) {
  Scene s = scenes::column(2, 0.5, 0.25, 0.6);
  s.bodies[0].mass = 1.0, s.bodies[1].mass = 1e6;
  ImpulseProblem problem = problem_of(scenes::Running(s), 0.0);
  const ImpulseSolution solution = ImpulseSolver().solve(problem, gravity_step);
  std::printf("1e6 kg on 1 kg: residual %.2g m/s after %zu iterations\n", solution.residual,
              solution.iterations);
  EXPECT_TRUE(solution.converged);
  EXPECT_LT(fastest(problem), 1e-3 * gravity_step);
}

TEST(ImpulseSolver, LeavesAGuessThatFits) {
  ImpulseProblem problem = problem_of(scenes::Running(scenes::column(5, 0.5, 0.25, 0.6)), 0.0);
  ImpulseSolver solver;
  solver.solve(problem, gravity_step);
  EXPECT_EQ(solver.solve(problem, gravity_step).iterations, 0u);
}

TEST(ImpulseSolver, AllocatesNothingWhileTheSameBodiesTouch) {
  ImpulseProblem problem = problem_of(scenes::Running(scenes::wall(6, 8, 0.5)), 0.8 * 9.81);
  ImpulseSolver solver;
  const auto cold = problem.points;
  solver.solve(problem, gravity_step);
  std::copy(cold.begin(), cold.end(), problem.points.begin());
  const std::size_t before = testing::allocations();
  EXPECT_GT(solver.solve(problem, gravity_step).iterations, 0u);
  EXPECT_EQ(testing::allocations(), before);
}

TEST(ImpulseSolver, FindsTheSameBitsWhateverItSolvedBefore) {
  const ImpulseProblem start = problem_of(scenes::Running(scenes::wall(6, 8, 0.5)), 0.8 * 9.81);
  ImpulseProblem first = start, second = start;
  ImpulseSolver fresh, used;
  ImpulseProblem other = problem_of(scenes::Running(scenes::column(5, 0.5, 0.25, 0.6)), 1.0);
  used.solve(other, gravity_step);
  fresh.solve(first, gravity_step), used.solve(second, gravity_step);
  for (std::size_t i = 0; i < first.points.size(); ++i)
    EXPECT_EQ(first.points[i].impulse, second.points[i].impulse);
}

}  // namespace
}  // namespace dougong::engine
