// Validation case E02: a projectile with linear drag; and quadratic drag along a line.
#include <gtest/gtest.h>

#include "tests/engine/reference.h"
#include "tests/oracles/drag.h"
#include "tests/scenes/points.h"

namespace dougong::engine {
namespace {

using scenes::Running;
using testing::expect_absolute;

Scene thrown(double mass, double drag, Vec2 velocity) {
  Scene s = scenes::space();
  s.gravity = {0.0, -9.81};
  s.bodies.push_back(scenes::point(mass, {}, velocity));
  s.bodies[0].linear_drag = drag;
  return s;
}

void check_thrown(double mass, double drag, Vec2 velocity, double time, const char* integrator, int steps,
                  double tolerance) {
  const oracles::DraggedProjectile exact{velocity.x, velocity.y, drag / mass, 9.81};
  Running r(thrown(mass, drag, velocity));
  DriveOptions options = scenes::run_for(time, time, integrator);
  options.step = time / steps;
  ASSERT_EQ(r.run(options).outcome, Outcome::completed);
  const std::string name = integrator;
  expect_absolute("E02", name + " x", exact.x(time), r.position().x, tolerance);
  expect_absolute("E02", name + " y", exact.y(time), r.position().y, tolerance);
  expect_absolute("E02", name + " vx", exact.speed_x(time), r.velocity().x, tolerance);
  expect_absolute("E02", name + " vy", exact.speed_y(time), r.velocity().y, tolerance);
}

TEST(DragOracle, IsTheReferenceTable) {
  const oracles::DraggedProjectile exact{12.0, 9.0, 0.3, 9.81};
  EXPECT_NEAR(exact.x(1.7), 15.9801768, 1e-7);
  EXPECT_NEAR(exact.y(1.7), -0.0588854549, 1e-10);
  EXPECT_NEAR(exact.speed_x(1.7), 7.20594695, 1e-8);
  EXPECT_NEAR(exact.speed_y(1.7), -7.65933436, 1e-8);
}

TEST(ProjectileWithDrag, FliesAsTheExponentialSays) {
  check_thrown(2.0, 0.6, {12.0, 9.0}, 1.7, "rk4", 400, 1e-10);
  check_thrown(2.0, 0.6, {12.0, 9.0}, 1.7, "velocity-verlet", 4000, 1e-6);
}
TEST(ProjectileWithDrag, DoesSoWithOtherParametersToo) {
  check_thrown(0.5, 1.1, {-3.0, 20.0}, 2.5, "rk4", 2000, 1e-10);
  check_thrown(0.5, 1.1, {-3.0, 20.0}, 2.5, "velocity-verlet", 20000, 1e-6);
}

TEST(QuadraticDrag, SlowsAsTheLogarithmSays) {
  for (const double c2 : {0.4, 3.0}) {
    Scene s = scenes::space();
    s.bodies.push_back(scenes::point(2.0, {}, {6.0, 8.0}));
    s.bodies[0].quadratic_drag = c2;
    Running r(s);
    DriveOptions options = scenes::run_for(1.5, 1.5, "rk4");
    options.step = 1e-4;
    r.run(options);
    const double way = oracles::coasted(10.0, c2 / 2.0, 1.5);
    expect_absolute("E02", "coasted", way, norm(r.position()), 1e-10);
    EXPECT_NEAR(r.position().x / r.position().y, 0.75, 1e-12);
  }
}

TEST(QuadraticDrag, LimitsAFall) {
  Scene s = scenes::space();
  s.gravity = {0.0, -9.81};
  s.bodies.push_back(scenes::point(2.0, {}));
  s.bodies[0].quadratic_drag = 0.7;
  Running r(s);
  DriveOptions options = scenes::run_for(3.0, 3.0, "rk4");
  options.step = 1e-3;
  r.run(options);
  expect_absolute("E02", "fallen", oracles::fallen(9.81, 0.35, 3.0), -r.position().y, 1e-10);
}

}  // namespace
}  // namespace dougong::engine
