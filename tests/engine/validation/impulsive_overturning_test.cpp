// Validation case R09: the least spin, step of the ground's velocity and rectangular pulse that overturn.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/reference.h"
#include "tests/scenes/rocking.h"

namespace dougong::engine {
namespace {

using oracles::RockingBlock;
using testing::expect_relative;
using testing::text;

constexpr double young_modulus = 300e9, damping_ratio = 2.0;

std::string label(const RockingBlock& c) {
  return "b=" + text(c.b) + " h=" + text(c.h) + " ";
}

/// Where `overturns` begins to hold, within 1 % of `reference`; the reference itself if it does not there.
template <class Overturns>
double threshold(double reference, Overturns overturns) {
  double low = 0.99 * reference, high = 1.01 * reference;
  EXPECT_FALSE(overturns(low)) << "at 0.99 of " << reference;
  EXPECT_TRUE(overturns(high)) << "at 1.01 of " << reference;
  while (high - low > 2e-4 * reference) {
    const double middle = 0.5 * (low + high);
    (overturns(middle) ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

double least_spin(const RockingBlock& c) {
  return c.p() * std::sqrt(2.0 * (1.0 - std::cos(c.alpha())));
}
/// The angular momentum about the corner that a step of the ground gives: m V h = 4/3 m R^2 spin.
double least_step(const RockingBlock& c) {
  return 4.0 * (c.b * c.b + c.h * c.h) / (3.0 * c.h) * least_spin(c);
}
double least_duration(const RockingBlock& c, double acceleration) {
  const auto overturns = [&](double duration) {
    const auto a = [&](double t) { return t < duration ? acceleration : 0.0; };
    return oracles::DrivenRocking(c, a, duration / 500.0).run(duration + 25.0 / c.p()).overturned;
  };
  double low = 0.01 / c.p(), high = 2.0 / c.p();
  while (high - low > 1e-7) {
    const double middle = 0.5 * (low + high);
    (overturns(middle) ? high : low) = middle;
  }
  return high;
}

void check_spin(const RockingBlock& c) {
  const auto overturns = [&](double spin) {
    auto run = scenes::rocking_run(c, 30e9, damping_ratio, nullptr, 0.0, 12.0 / c.p());
    run.scene.bodies[0].spin = spin;
    run.scene.bodies[0].velocity = spin * turned(Vec2{c.b, c.h});
    return scenes::measured_rocking(run).overturned;
  };
  expect_relative("R09", label(c) + "spin", least_spin(c), threshold(least_spin(c), overturns), 0.01);
}

// Seen from the ground: the block comes with the opposite velocity.
void check_step(const RockingBlock& c) {
  const auto overturns = [&](double speed) {
    auto run = scenes::rocking_run(c, young_modulus, damping_ratio, nullptr, 0.0, 12.0 / c.p());
    run.scene.bodies[0].velocity = {-speed, 0.0};
    return scenes::measured_rocking(run).overturned;
  };
  expect_relative("R09", label(c) + "velocity step", least_step(c), threshold(least_step(c), overturns),
                  0.01);
}

void check_pulse(const RockingBlock& c, double strength) {
  const double a = strength * c.g * c.b / c.h, exact = least_duration(c, a);
  const auto overturns = [&](double duration) {
    const auto motion = scenes::horizontal_motion(
        [=](double t) { return t < duration ? a : 0.0; }, [=](double t) { return a * std::min(t, duration); },
        [=](double t) { return t < duration ? 0.5 * a * t * t : a * duration * (t - 0.5 * duration); });
    auto run = scenes::rocking_run(c, young_modulus, damping_ratio, motion, duration, 12.0 / c.p());
    run.output_interval = duration / 100.0;
    return scenes::measured_rocking(run).overturned;
  };
  expect_relative("R09", label(c) + text(strength) + " g tan(alpha) duration", exact,
                  threshold(exact, overturns), 0.01);
}

TEST(ImpulsiveOverturning, NeedsTheSpinOfTheBarrier) {
  EXPECT_NEAR(least_spin({0.25, 1.0, 9.81}), 0.652867, 1e-6);
  check_spin({0.25, 1.0, 9.81});
  check_spin({0.3, 0.8, 9.81});
}
TEST(ImpulsiveOverturning, NeedsTheStepOfTheGroundThatGivesThatSpin) {
  EXPECT_NEAR(least_step({0.25, 1.0, 9.81}), 0.924895, 1e-6);
  check_step({0.25, 1.0, 9.81});
  check_step({0.4, 1.5, 9.81});
}
TEST(ImpulsiveOverturning, NeedsTheDurationOfThePulse) {
  const RockingBlock c{0.25, 1.0, 9.81};
  EXPECT_NEAR(least_duration(c, 2.0 * c.g * c.b / c.h), 0.260009, 1e-6);
  check_pulse(c, 2.0);
  check_pulse({0.3, 1.5, 9.81}, 3.0);
}

}  // namespace
}  // namespace dougong::engine
