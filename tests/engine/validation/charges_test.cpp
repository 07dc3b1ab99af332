// Validation case E10: charges that part, and Rutherford's scattering.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/engine/reference.h"
#include "tests/oracles/two_bodies.h"
#include "tests/scenes/points.h"

namespace dougong::engine {
namespace {

using scenes::point;
using scenes::Running;
using testing::expect_absolute;
using testing::expect_relative;

DriveOptions settings(const std::string& integrator, double end) {
  DriveOptions options = scenes::run_for(end, end / 100.0, integrator);
  options.tolerance = 1e-12;
  if (integrator == "rk4") options.step = end / 20000.0;
  return options;
}

TEST(ChargesOracle, IsTheReferenceTable) {
  EXPECT_NEAR(oracles::time_to_part(0.75, 2.0, 1.0, 2.0), 0.994018394, 1e-9);
  EXPECT_NEAR(oracles::time_to_part(0.75, 2.0, 1.0, 10.0), 4.895329596, 1e-9);
  const oracles::Hyperbola path(2.0, {-30.0, 0.8, 1.5, 0.0});
  const oracles::PlaneMotion end = path.at(40.0);
  EXPECT_NEAR(end.x, -2.837114478, 1e-8);
  EXPECT_NEAR(end.y, 26.81129061, 1e-8);
  EXPECT_NEAR(end.vx, -0.1129844661, 1e-9);
  EXPECT_NEAR(end.vy, 1.490690414, 1e-9);
  // From infinity with the same speed and impact parameter.
  const oracles::Hyperbola far(2.0, {-1e9, 0.8, 1.5, 0.0});
  EXPECT_NEAR(far.deflection() * 180.0 / std::numbers::pi, 96.02557501, 1e-6);
  EXPECT_NEAR(far.closest(), 2.084766582, 1e-7);
}

struct Charges {
  double m1, m2, q1, q2, k, distance;
  double reduced() const { return m1 * m2 / (m1 + m2); }
};

void check_parting(const Charges& c, double ratio, const std::string& integrator, double tolerance) {
  Scene s = scenes::space();
  s.fields.coulomb_constant = c.k;
  s.bodies = {point(c.m1, {0, 0}, {}, c.q1), point(c.m2, {0, c.distance}, {}, c.q2)};
  Running r(s);
  const double strength = c.k * c.q1 * c.q2, end = c.distance * ratio;
  const double time = oracles::time_to_part(c.reduced(), strength, c.distance, end);
  ASSERT_EQ(r.run(settings(integrator, time)).outcome, Outcome::completed);
  const double speed = std::sqrt(2.0 * strength / c.reduced() * (1.0 / c.distance - 1.0 / end));
  expect_relative("E10", integrator + " distance", end, norm(r.position(1) - r.position(0)), tolerance);
  expect_relative("E10", integrator + " relative speed", speed, norm(r.velocity(1) - r.velocity(0)),
                  tolerance);
  EXPECT_LT(norm(scenes::momentum(r)), 1e-12);
}

TEST(Charges, PartAsTheirEnergySays) {
  for (const char* integrator : {"rk4", "dormand-prince", "rk8"}) {
    check_parting({1.0, 3.0, 1.0, 2.0, 1.0, 1.0}, 2.0, integrator, 1e-8);
    check_parting({1.0, 3.0, 1.0, 2.0, 1.0, 1.0}, 10.0, integrator, 1e-8);
  }
}
TEST(Charges, DoSoWithOtherValuesToo) {
  check_parting({0.2, 0.5, -3e-6, -2e-6, 8.99e9, 0.4}, 5.0, "rk4", 1e-8);
  check_parting({0.2, 0.5, -3e-6, -2e-6, 8.99e9, 0.4}, 5.0, "rk8", 1e-8);
}

// The centre is held by its inertia.
void check_scattering(double mass, double strength, const oracles::PlaneMotion& start, double time,
                      const std::string& integrator) {
  Scene s = scenes::space();
  s.fields.coulomb_constant = strength;
  s.bodies = {point(mass, {start.x, start.y}, {start.vx, start.vy}, 1.0), point(1e30, {}, {}, 1.0)};
  Running r(s);
  const oracles::Hyperbola path(strength / mass, start);
  ASSERT_EQ(r.run(settings(integrator, time)).outcome, Outcome::completed);
  const oracles::PlaneMotion exact = path.at(time);
  expect_absolute("E10", integrator + " x", exact.x, r.position().x, 1e-8);
  expect_absolute("E10", integrator + " y", exact.y, r.position().y, 1e-8);
  expect_absolute("E10", integrator + " vx", exact.vx, r.velocity().x, 1e-8);
  expect_absolute("E10", integrator + " vy", exact.vy, r.velocity().y, 1e-8);
}

TEST(RutherfordScattering, FollowsTheHyperbola) {
  for (const char* integrator : {"rk4", "dormand-prince", "rk8"})
    check_scattering(1.0, 2.0, {-30.0, 0.8, 1.5, 0.0}, 40.0, integrator);
}
TEST(RutherfordScattering, DoesSoOnOtherPathsToo) {
  check_scattering(0.3, 0.7, {4.0, -10.0, -0.2, 2.5}, 9.0, "rk8");
  check_scattering(2.0, 5.0, {10.0, 3.0, -2.0, 0.0}, 12.0, "dormand-prince");
}

}  // namespace
}  // namespace dougong::engine
