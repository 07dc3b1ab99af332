// Validation cases R05 and R06: how a block, and a stack of two, start to move on a ground that begins to
// accelerate.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/settle.h"
#include "tests/engine/reference.h"
#include "tests/oracles/block_modes.h"
#include "tests/oracles/driven_rocking.h"
#include "tests/scenes/running.h"

namespace dougong::engine {
namespace {

using scenes::run_for;
using scenes::Running;
using testing::expect_absolute;
using testing::expect_relative;
using testing::text;

constexpr double g = 9.81;

Terrain accelerating_ground(double a) {
  return scenes::ground(
      200.0, {}, 0.0,
      scenes::horizontal_motion([=](double) { return a * g; }, [=](double t) { return a * g * t; },
                                [=](double t) { return 0.5 * a * g * t * t; }));
}

// Accelerations over 10 ms: after the elastic start, and of blocks that turn before the angle matters.
struct Accelerations {
  std::vector<double> spin_rate, relative;  // rad/s2, m/s2, of every body
};
Accelerations measured_start(Running& r, double a, bool turns) {
  EXPECT_TRUE(settle(r.model, r.state).settled);
  const double from = turns ? 0.005 : 0.2, to = from + 0.01;
  Accelerations measured{std::vector<double>(r.bodies()), std::vector<double>(r.bodies())};
  const auto add = [&](double sign, double t) {
    for (std::size_t i = 0; i < r.bodies(); ++i) {
      measured.spin_rate[i] += sign * r.spin(i) / (to - from);
      measured.relative[i] += sign * (r.velocity(i).x - a * g * t) / (to - from);
    }
  };
  r.run(run_for(to, 0.001), [&](const Sample& sample) {
    const double t = sample.state.time;
    if (std::abs(t - from) < 1e-9) add(-1.0, t);
    if (std::abs(t - to) < 1e-9) add(1.0, t);
    return Wish::go_on;
  });
  return measured;
}

void compare(const std::string& name, const std::string& quantity, double reference, double measured) {
  if (reference == 0.0)
    expect_absolute(name, quantity, 0.0, measured, 1e-6);
  else
    expect_relative(name, quantity, reference, measured, 0.01);
}

void check_block(const oracles::ShakenBlock& c, double a) {
  Scene s = scenes::block_on_ground(c.b, c.h, c.friction, 3e12);
  s.terrains[0] = accelerating_ground(a);
  Running r(s);
  const oracles::FirstMotion exact = c.start(a);
  const Accelerations measured = measured_start(r, a, exact.spin_rate > 0.0);
  const std::string label =
      "b=" + text(c.b) + " h=" + text(c.h) + " mu=" + text(c.friction) + " A=" + text(a) + " " + exact.mode;
  compare("R06", label + " spin rate", exact.spin_rate, measured.spin_rate[0]);
  compare("R06", label + " acceleration", exact.acceleration, measured.relative[0]);
}

TEST(ShakenBlock, RestsSlidesOrRocksAsTheReferenceSays) {
  struct Row {
    double friction, a;
    const char* mode;
    double spin_rate, acceleration;
  };
  for (const Row& row :
       {Row{0.1, 0.05, "rest", 0, 0}, Row{0.1, 0.3, "slide", 0, -1.962}, Row{0.15, 0.3, "slide", 0, -1.4715},
        Row{0.3, 0.22, "rest", 0, 0}, Row{0.3, 0.26, "rock", 0.069247, -0.069247},
        Row{0.5, 0.26, "rock", 0.069247, -0.069247}, Row{0.5, 0.6, "rock", 2.4236, -2.4236},
        Row{0.5, 1, "rock", 5.1935, -5.1935}, Row{0.7, 1, "rock", 5.1935, -5.1935},
        Row{0.3, 1, "slide-rock", 1.4356, -6.7593}, Row{0.26, 0.8, "slide-rock", 0.27896, -5.2793},
        Row{0.9, 3, "rock", 19.043, -19.043}}) {
    const oracles::ShakenBlock c{0.25, 1.0, row.friction, g};
    const auto exact = c.start(row.a);
    EXPECT_EQ(exact.mode, row.mode);
    EXPECT_NEAR(exact.spin_rate, row.spin_rate, 5e-5 * row.spin_rate);
    EXPECT_NEAR(exact.acceleration, row.acceleration, -5e-5 * row.acceleration);
    check_block(c, row.a);
  }
}
TEST(ShakenBlock, DoesSoWithOtherProportionsToo) {
  for (const double friction : {0.3, 0.6, 1.2})
    for (const double a : {0.25, 0.55, 1.5}) check_block({0.3, 0.6, friction, g}, a);
}

Scene two_blocks(const oracles::TwoBlocks& c, double a, double young_modulus) {
  Scene s = scenes::scene(10.0, young_modulus);
  s.bodies.push_back(scenes::block(c.b1, c.h1, {0.0, c.h1}));
  s.bodies.push_back(scenes::block(c.b2, c.h2, {0.0, 2.0 * c.h1 + c.h2}));
  s.terrains.push_back(accelerating_ground(a));
  return s;
}

void check_stack(const oracles::TwoBlocks& c, double a) {
  Running r(two_blocks(c, a, 3e12));
  const auto exact = c.start(a);
  const Accelerations measured = measured_start(r, a, exact.upper > 0.0);
  const std::string label = "h1=" + text(c.h1) + " h2=" + text(c.h2) + " a=" + text(a) + "g " + exact.mode;
  compare("R05", label + " lower", exact.lower, measured.spin_rate[0]);
  compare("R05", label + " upper", exact.upper, measured.spin_rate[1]);
}

TEST(StackOfTwo, StartsInTheModeOfTheReference) {
  struct Row {
    double a;
    const char* mode;
    double lower, upper;
  };
  for (const Row& row :
       {Row{0.2, "rest", 0, 0}, Row{0.3, "rest", 0, 0}, Row{0.36, "top", 0, 0.23544},
        Row{0.45, "top", 0, 1.03005}, Row{0.6, "top", 0, 2.3544}, Row{1, "both", 2.22146, 3.72007},
        Row{2, "monolith", 8.15698, 8.15698}, Row{4, "monolith", 18.9094, 18.9094}}) {
    const oracles::TwoBlocks c{0.5, 0.5, 0.25, 0.75, g};
    const auto exact = c.start(row.a);
    EXPECT_EQ(exact.mode, row.mode);
    EXPECT_NEAR(exact.lower, row.lower, 1e-5 * row.lower);
    EXPECT_NEAR(exact.upper, row.upper, 1e-5 * row.upper);
    check_stack(c, row.a);
  }
}
TEST(StackOfTwo, StartsInItsModeWithOtherProportionsToo) {
  for (const double a : {0.3, 0.6, 1.0, 1.4}) check_stack({0.4, 0.6, 0.3, 0.5, g}, a);
}

// The upper block alone, on a lower one that stands. What the springs of its far corner give back as it
// lifts is an impulse that falls with the root of the stiffness: E 100 000 GPa.
TEST(StackOfTwo, RocksItsTopBlockAsOneOnTheGround) {
  const oracles::TwoBlocks c{0.5, 0.5, 0.25, 0.75, g};
  const double a = 0.45, known[] = {0.00519397, 0.0213074, 0.0499873, 0.0941559};
  Running r(two_blocks(c, a, 1e14));
  ASSERT_TRUE(settle(r.model, r.state).settled);
  for (int i = 1; i <= 4; ++i) {
    const double t = 0.1 * i;
    const auto exact = oracles::DrivenRocking(
                           oracles::RockingBlock{c.b2, c.h2, g}, [&](double) { return a * g; }, 1e-3)
                           .run(t - 1e-6);
    EXPECT_NEAR(exact.angle / known[i - 1], 1.0, 2e-6);
  }
  r.run(run_for(0.4), [&](const Sample& sample) {
    const long tenth = std::lround(sample.state.time * 100.0);
    if (tenth == 0 || tenth % 10 != 0) return Wish::go_on;
    expect_relative("R05", "a=0.45g t=" + text(sample.state.time) + " theta2", known[tenth / 10 - 1],
                    r.angle(1), 0.01);
    expect_absolute("R05", "a=0.45g t=" + text(sample.state.time) + " theta1", 0.0, r.angle(0), 1e-6);
    return Wish::go_on;
  });
}

}  // namespace
}  // namespace dougong::engine
