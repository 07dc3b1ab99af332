// Validation case E05: a disc that rolls, or slides until it rolls.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/engine/reference.h"
#include "tests/oracles/rolling.h"
#include "tests/scenes/discs.h"

namespace dougong::engine {
namespace {

using scenes::run_for;
using scenes::Running;
using testing::expect_relative;
using testing::text;

constexpr double degree = std::numbers::pi / 180.0;

// Rests on the springs of the contact from the start.
Scene disc_on_plane(double friction, double radius, double g, double slope) {
  Scene s = scenes::scene(friction);
  s.gravity.y = -g;
  s.terrains.push_back(scenes::ground(200.0, {}, -slope));
  const double weight = 2400.0 * std::numbers::pi * radius * radius * g * std::cos(slope);
  const double k = std::numbers::pi / 4.0 * 30e9 / (1.0 - 0.2 * 0.2);
  s.bodies.push_back(scenes::disc(radius, rotated({0.0, radius - weight / k}, -slope)));
  return s;
}

void check_slope(const oracles::DiscOnSlope& c) {
  const double end = 1.5;
  Running r(disc_on_plane(c.friction, c.radius, c.g, c.slope));
  const Vec2 start = r.position(), down = rotated({1.0, 0.0}, -c.slope);
  r.run(run_for(end));
  double friction = 0.0;
  for (const auto& f : scenes::point_forces(r.model, r.state)) friction += std::abs(f.tangential);
  const std::string name = "slope=" + text(c.slope / degree) + " mu=" + text(c.friction) + " ";
  expect_relative("E05", name + "went", 0.5 * c.acceleration() * end * end, dot(r.position() - start, down),
                  0.005);
  expect_relative("E05", name + "speed", c.acceleration() * end, dot(r.velocity(), down), 0.005);
  expect_relative("E05", name + "spin", c.spin_rate() * end, -r.spin(), 0.005);
  expect_relative("E05", name + "friction/W", c.friction_over_weight(), friction / (r.model.mass[0] * c.g),
                  0.005);
}

TEST(DiscOnASlope, RollsOrSlidesAsCoulombSays) {
  const oracles::DiscOnSlope reference{20.0 * degree, 0.5, 0.3, 9.81};
  EXPECT_NEAR(reference.acceleration(), 2.23681, 1e-5);
  EXPECT_NEAR(reference.friction_over_weight(), 0.114007, 1e-6);
  check_slope(reference);
  check_slope({60.0 * degree, 0.3, 0.3, 9.81});
  check_slope({35.0 * degree, 0.25, 0.7, 3.7});
}

// All of its mass at the rim: m R^2 in place of m R^2/2 leaves half of g sin(slope).
TEST(DiscOnASlope, RollsAsItsMomentOfInertiaSays) {
  const double slope = 20.0 * degree, radius = 0.3, g = 9.81, end = 1.5;
  Scene s = disc_on_plane(0.5, radius, g, slope);
  s.bodies[0].mass = 70.0;
  s.bodies[0].inertia = 70.0 * radius * radius;
  Running r(s);
  r.run(run_for(end));
  expect_relative("E05", "hoop, spin", 0.5 * g * std::sin(slope) * end / radius, -r.spin(), 0.005);
}

void check_thrown(const oracles::ThrownDisc& c) {
  Scene s = disc_on_plane(c.friction, c.radius, c.g, 0.0);
  s.bodies[0].velocity.x = c.speed, s.bodies[0].spin = -c.spin;
  Running r(s);
  double rolls_from = 0.0, went = 0.0;
  r.run(run_for(3.0 * c.slides_until(), 1e-4), [&](const Sample& sample) {
    const double slip = r.velocity().x + r.spin() * c.radius;
    if (rolls_from == 0.0 && std::abs(slip) < 1e-4 * std::abs(c.slip()))
      rolls_from = sample.state.time, went = r.position().x;
    return Wish::go_on;
  });
  const std::string name = "v=" + text(c.speed) + " spin=" + text(c.spin) + " mu=" + text(c.friction) + " ";
  expect_relative("E05", name + "slides until", c.slides_until(), rolls_from, 0.005);
  expect_relative("E05", name + "went while sliding", c.went_while_sliding(), went, 0.005);
  expect_relative("E05", name + "speed long after", c.rolling_speed(), r.velocity().x, 0.005);
  expect_relative("E05", name + "spin long after", c.rolling_speed() / c.radius, -r.spin(), 0.005);
}

TEST(ThrownDisc, SlidesUntilItRollsAndThenKeepsItsSpeed) {
  const oracles::ThrownDisc reference{4.0, 0.0, 0.3, 0.3, 9.81};
  EXPECT_NEAR(reference.slides_until(), 0.453052, 1e-6);
  EXPECT_NEAR(reference.went_while_sliding(), 1.51017, 1e-5);
  check_thrown(reference);
  check_thrown({3.0, -8.0, 0.2, 0.5, 9.81});  // with backspin
  check_thrown({1.0, 9.0, 0.5, 0.4, 3.7});    // spinning faster than it goes
}

}  // namespace
}  // namespace dougong::engine
