// Validation cases X06 and X17: strong shaking that friction hardly passes on, and the two ways to describe a
// shaken scene, by a ground that moves or by the inertia it causes.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/settle.h"
#include "tests/engine/reference.h"
#include "tests/oracles/sliding.h"
#include "tests/scenes/running.h"
#include "tests/scenes/running_bond.h"

namespace dougong::engine {
namespace {

using scenes::run_for;
using scenes::Running;
using testing::expect_absolute;
using testing::expect_relative;
using testing::text;

constexpr double g = 9.81;

void check_strong_sine(double amplitude, double frequency, double friction, int cycles) {
  const double w = 2.0 * std::numbers::pi * frequency, mu_g = friction * g;
  const auto motion = scenes::sine_motion(amplitude, frequency);
  Scene s = scenes::block_on_ground(0.5, 0.05, friction);
  s.bodies[0].position.y -= 0.05 * 2400.0 * 0.1 * g / 30e9;  // in equilibrium
  s.terrains[0].motion = motion;
  Running r(s);
  const oracles::HarmonicSlider exact(amplitude, w, mu_g, cycles / frequency);
  double strongest = 0.0, low = 0.0, high = 0.0;
  std::vector<double> ends;
  const int outputs = 500;  // a cycle
  int count = 0;
  r.run(run_for(cycles / frequency, 1.0 / (outputs * frequency)), [&](const Sample& sample) {
    const double u = r.position().x - motion->at(sample.state.time).displacement.x;
    strongest = std::max(strongest, std::abs(sample.accelerations[0]));
    low = std::min(low, u), high = std::max(high, u);
    if (count++ % outputs == 0) ends.push_back(u);
    return Wish::go_on;
  });
  const std::string name = "A=" + text(amplitude) + " f=" + text(frequency) + " mu=" + text(friction) + " ";
  expect_relative("X06", name + "greatest acceleration over mu g", 1.0, strongest / mu_g, 0.01);
  expect_absolute("X06", name + "turn", 0.0, r.angle(), 1e-6);
  expect_relative("X06", name + "range", exact.range(), high - low, 0.01);
  for (std::size_t i = 1; i < ends.size(); ++i)
    expect_relative("X06", name + "after cycle " + std::to_string(i),
                    exact.displacement(static_cast<double>(i) / frequency), ends[i], 0.01);
}

TEST(StronglyShakenBlock, OnlySlidesWithWhatFrictionGives) {
  const oracles::HarmonicSlider exact(10.0 * g, 10.0 * std::numbers::pi, 0.5 * g, 0.8);
  const double ends[] = {-0.530071, -0.951764, -1.29154, -1.56697};
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(exact.displacement(0.2 * (i + 1)) / ends[i], 1.0, 1e-5) << i;
  EXPECT_NEAR(exact.range() / 1.61524, 1.0, 1e-5);
  check_strong_sine(10.0 * g, 5.0, 0.5, 4);
}
TEST(StronglyShakenBlock, DoesSoUnderOtherShakingToo) {
  check_strong_sine(6.0 * g, 3.0, 0.2, 3);
}

/// An acceleration of +a, -a, -a, +a ... each for a time: both ground velocity and displacement return to 0.
struct SquareShaking {
  double amplitude, interval;  // m/s2, s
  int intervals;

  double acceleration(int k) const { return (k % 4 == 0 || k % 4 == 3) ? amplitude : -amplitude; }
  MotionSample at(double t) const {
    double d = 0.0, v = 0.0;
    for (int k = 0; k < intervals; ++k) {
      const double a = acceleration(k), rest = t - k * interval, s = std::min(rest, interval);
      if (s <= 0.0) return {{d, 0.0}, {v, 0.0}, {}};
      d += v * s + 0.5 * a * s * s, v += a * s;
      if (rest < interval) return {{d, 0.0}, {v, 0.0}, {a, 0.0}};
    }
    return {{d, 0.0}, {v, 0.0}, {}};
  }
};

class SquareMotion final : public PrescribedMotion {
 public:
  explicit SquareMotion(SquareShaking shaking) : shaking_(shaking) {}
  MotionSample at(double t) const override { return shaking_.at(t); }
  double knot_interval() const override { return shaking_.interval; }

 private:
  SquareShaking shaking_;
};

// The one on a ground that moves; the other on a fixed one, with the inertia as a part of gravity that
// changes from one interval to the next. Returns the largest difference of places and angles in the ground's
// frame.
double difference(const Scene& scene, const SquareShaking& shaking, double step_fraction) {
  Running on_ground(scene), in_frame(scene);
  EXPECT_TRUE(settle(on_ground.model, on_ground.state).settled);
  EXPECT_TRUE(settle(in_frame.model, in_frame.state).settled);
  const Running start = in_frame;
  DriveOptions interval = run_for(shaking.interval, shaking.interval), whole = interval;
  interval.step_fraction = whole.step_fraction = step_fraction;
  whole.end_time = shaking.intervals * shaking.interval;
  on_ground.model.motions[0] = std::make_shared<SquareMotion>(shaking);
  on_ground.run(whole);
  for (int k = 0; k < shaking.intervals; ++k) {
    in_frame.model.gravity.x = -shaking.acceleration(k);
    in_frame.run(interval);
  }
  EXPECT_GT(scenes::greatest_drift(in_frame, start), 1e-3) << "it has hardly moved";
  const Vec2 way = shaking.at(on_ground.state.time).displacement;
  double worst = 0.0;
  for (std::size_t i = 0; i < in_frame.bodies(); ++i)
    worst = std::max({worst, norm(on_ground.position(i) - way - in_frame.position(i)),
                      std::abs(on_ground.angle(i) - in_frame.angle(i))});
  return worst;
}

// The integrator starts afresh where the inertia jumps, so they differ by what a step errs there.
void check_formulations(const std::string& name, const Scene& scene, const SquareShaking& shaking) {
  for (const auto& [fraction, tolerance] : {std::pair{0.5, 1e-3}, std::pair{0.02, 2e-6}})
    expect_absolute("X17", name + ", " + text(fraction) + " of the bound: largest difference (m, rad)", 0.0,
                    difference(scene, shaking, fraction), tolerance);
}

TEST(ShakenScene, IsTheSameOnAMovingGroundAndInItsFrame) {
  check_formulations("sliding and rocking wall", scenes::wall(3, 4, 0.3, 1e9), {5.0, 0.125, 8});
}
TEST(ShakenScene, IsSoForOtherScenesAndMotionsToo) {
  check_formulations("rocking block", scenes::block_on_ground(0.25, 1.0, 2.0, 3e9), {4.0, 0.25, 4});
}

}  // namespace
}  // namespace dougong::engine
