// Validation case S05: a rigid deck on friction pendulums, as a block on level ground whose pin to the ground
// has the stiffness of the dish, m g/R.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/reference.h"
#include "tests/oracles/friction_pendulum.h"
#include "tests/oracles/synthetic_record.h"
#include "tests/scenes/record_motion.h"
#include "tests/scenes/running.h"

namespace dougong::engine {
namespace {

using oracles::SlidingHistory;
using scenes::run_for;
using scenes::Running;
using testing::expect_relative;

constexpr double g = 9.81, record_step = 0.01;

struct Isolated {
  double radius, friction;
  std::uint32_t seed;
  double amplitude;  // m/s2, of the record
};

std::vector<double> record(const Isolated& c) {
  return oracles::SyntheticMotion(c.seed, c.amplitude).samples(record_step);
}

SlidingHistory exact(const Isolated& c) {
  const auto samples = record(c);
  return oracles::FrictionPendulum(c.radius, c.friction, g,
                                   [&](double t) { return oracles::interpolated(samples, record_step, t); })
      .run(40.0, record_step / 10.0);
}

// The pin is held by a peg that moves with the ground: ground and block keep touching.
Scene isolated_block(const Isolated& c) {
  const double b = 0.5, h = 0.05, young_modulus = 0.3e9;
  const auto motion = scenes::record_motion(record(c), record_step);
  Scene s = scenes::scene(c.friction, young_modulus);
  s.terrains.push_back(scenes::ground(200.0, {}, 0.0, motion));
  s.bodies.push_back(scenes::block(b, h, {0.0, h - 2400.0 * 2.0 * h * g * h / young_modulus}));
  Terrain peg;
  peg.name = "peg";
  peg.shape = make_circle(0.1);
  peg.position = {0.0, 5.0};
  peg.motion = motion;
  s.terrains.push_back(peg);
  Joint dish;
  dish.a = {false, 0}, dish.b = {true, 1};
  dish.anchor_b = s.bodies[0].position - peg.position;
  dish.stiffness = 2400.0 * 4.0 * b * h * g / c.radius;
  s.joints.push_back(dish);
  return s;
}

SlidingHistory measured(const Isolated& c) {
  Running r(isolated_block(c));
  const auto motion = r.model.motions.at(0);
  SlidingHistory m;
  r.run(run_for(40.0, 1e-3), [&](const Sample& sample) {
    const double place = r.position().x - motion->at(sample.state.time).displacement.x;
    m.path += std::abs(place - m.last), m.last = place;
    m.greatest = std::max(m.greatest, std::abs(place));
    return Wish::go_on;
  });
  return m;
}

void compare(const Isolated& c) {
  const SlidingHistory reference = exact(c), found = measured(c);
  expect_relative("S05", "greatest", reference.greatest, found.greatest, 0.02);
  expect_relative("S05", "residual", reference.last, found.last, 0.02);
  expect_relative("S05", "path", reference.path, found.path, 0.02);
}

TEST(FrictionPendulumOracle, IsTheReference) {
  const SlidingHistory h = exact({1.5, 0.06, 2011, 1.5});
  EXPECT_NEAR(h.greatest / 0.0462362, 1.0, 1e-4);
  EXPECT_NEAR(h.last / 0.004464, 1.0, 1e-3);
  EXPECT_NEAR(h.path / 0.513256, 1.0, 1e-4);
}

TEST(FrictionPendulum, SlidesAndStaysWhereTheBearingDoes) {
  compare({1.5, 0.06, 2011, 1.5});
}
TEST(FrictionPendulum, DoesSoWithOtherDishesToo) {
  compare({2.5, 0.09, 7, 2.2});
}

}  // namespace
}  // namespace dougong::engine
