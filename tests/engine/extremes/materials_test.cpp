// Moduli from 1e5 to 1e12 Pa, friction of 0 and 10.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/settle.h"
#include "tests/engine/reference.h"
#include "tests/oracles/incline.h"
#include "tests/scenes/audit.h"
#include "tests/scenes/burst.h"

namespace dougong::engine {
namespace {

using scenes::run_for;
using scenes::Running;
using testing::expect_absolute;
using testing::expect_relative;
using testing::report;
using testing::scientific;
using testing::text;

// A column settles by its closed form, is shaken at 0.3 g and 3 Hz for a second, and balances its energy.
void check_modulus(double young_modulus) {
  const double b = 0.1, h = 0.05, weight = 2400.0 * 4.0 * b * h * 9.81;
  Running r(scenes::column(3, b, h, 0.6, young_modulus));
  ASSERT_TRUE(settle(r.model, r.state, {.unbalanced_ratio = 1e-6}).settled) << young_modulus;
  const double joint = weight * h / (b * young_modulus);  // under one block
  const std::string name = "E=" + scientific(young_modulus) + " Pa: ";
  expect_relative("modulus", name + "sinks (m)", (1.5 + 2.0 + 1.0) * joint, 5.0 * h - r.position(2).y, 1e-3);
  r.model.motions[0] = std::make_shared<scenes::Burst>(3.0, 3.0, 1.0);
  const auto audit = scenes::audited(r, run_for(1.5));
  EXPECT_TRUE(audit.completed()) << name << audit.run.detail;
  report("modulus", name + "energy error", 0.0, audit.energy_error, audit.energy_error, 0.01);
  std::printf("modulus %ssteps of %.3g s\n", name.c_str(), audit.run.smallest_step);
}

TEST(YoungModulus, MayLieAnywhereBetweenFoamAndDiamond) {
  for (int exponent = 5; exponent <= 12; ++exponent) check_modulus(std::pow(10.0, exponent));
}

void check_slope(double friction, double slope) {
  const oracles::Incline c{slope, friction, 0.5, 0.05, 9.81};
  Scene s = scenes::scene(friction);
  s.terrains.push_back(scenes::ground(200.0, {}, -slope));
  s.bodies.push_back(scenes::block(c.b, c.h, rotated({0.0, c.h}, -slope), -slope));
  Running r(s);
  const Vec2 start = r.position();
  const auto audit = scenes::audited(r, run_for(1.0));
  EXPECT_TRUE(audit.completed()) << audit.run.detail;
  const double slid = dot(r.position() - start, rotated({1.0, 0.0}, -slope));
  const std::string name =
      "friction " + text(friction) + " on " + text(slope * 180.0 / std::numbers::pi) + " deg: ";
  if (c.sticks())
    expect_absolute("friction", name + "creep (m)", 0.0, slid, 1e-6);
  else
    expect_relative("friction", name + "slid (m)", c.slid(1.0), slid, 1e-4);
  expect_absolute("friction", name + "energy error", 0.0, audit.energy_error, 0.01);
}

TEST(Friction, OfZeroHoldsNothingAndOfTenAllThatDoesNotTip) {
  const double degree = std::numbers::pi / 180.0;
  for (const double slope : {5.0, 30.0, 80.0}) {
    check_slope(0.0, slope * degree);
    check_slope(10.0, slope * degree);
  }
}

// Without friction a wall is laid on ice: the ground moves and it stays. With 10 it goes along.
TEST(Friction, PassesOnAllOrNothingOfAShaking) {
  for (const double friction : {0.0, 10.0}) {
    Running r(scenes::wall(3, 3, friction, 1e9));
    const SettleReport settled = settle(r.model, r.state);
    ASSERT_TRUE(settled.settled) << settled.detail;
    const Running start = r;
    r.model.motions[0] = std::make_shared<scenes::Burst>(3.0, 2.0, 2.0);
    double relative = 0.0, absolute = 0.0;
    const RunOutcome run = r.run(run_for(2.0), [&](const Sample& sample) {
      const double ground = r.model.motions[0]->at(sample.state.time).displacement.x;
      absolute = std::max(absolute, std::abs(r.position().x - start.position().x));
      relative = std::max(relative, std::abs(r.position().x - start.position().x - ground));
      return Wish::go_on;
    });
    EXPECT_EQ(run.outcome, Outcome::completed) << run.detail;
    expect_absolute("friction",
                    "wall with friction " + text(friction) + ": greatest way that it should not go (m)", 0.0,
                    friction == 0.0 ? absolute : relative, 2e-5);
  }
}

}  // namespace
}  // namespace dougong::engine
