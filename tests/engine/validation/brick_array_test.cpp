// Comparison M02: the 81-brick graphite array on a shaking table. docs/comparisons/m02-brick-array.md. The
// whole sweep is a bench; here are the bricks, their impacts and a short dwell at the resonance.
#include "tests/scenes/brick_array.h"

#include <gtest/gtest.h>

#include "tests/engine/reference.h"

namespace dougong::engine {
namespace {

using testing::expect_relative;

std::shared_ptr<const scenes::SweptSine> dwell(double frequency) {
  return std::make_shared<const scenes::SweptSine>(0.3 * 9.81, frequency, frequency + 1.0, 0.1, 1e3);
}

// Areas as published; masses and moments of inertia with the bore taken out, the bore's by shells.
TEST(BrickArray, HasThePublishedBricks) {
  const Scene s = scenes::brick_array(dwell(5.0));
  EXPECT_EQ(s.bodies.size(), 81u + 100u);
  EXPECT_EQ(s.terrains.size(), 40u);
  const auto fuel =
      std::find_if(s.bodies.begin(), s.bodies.end(), [](const Body& b) { return b.name == "FB2(2)(2)"; });
  const AreaProperties outline = area_properties(fuel->shape);
  EXPECT_NEAR(outline.area, 0.144899, 1e-6);
  expect_relative("M02", "mass of a fuel brick", 1687.7 * 0.907 * (0.144899 - 0.053437), *fuel->mass, 1e-5);
  // A 24-gon is a disc to 1 % here: A^2/(2 pi).
  const double bore = 0.053437 * 0.053437 / (2.0 * std::numbers::pi);
  expect_relative("M02", "moment of inertia of a fuel brick", 1687.7 * 0.907 * (outline.second_moment - bore),
                  *fuel->inertia, 0.001);
}

// Octagon less bore at full height, bearing keys of 58.49 x 29.75 x 260 mm.
TEST(BrickArray, HasInterstitialBricksWithBearingKeys) {
  const Body brick = scenes::bricks::interstitial_body(1637.4, 0.907);
  EXPECT_NEAR(area_properties(scenes::bricks::octagon()).area, 0.04395, 1e-5);
  expect_relative("M02", "mass of an interstitial brick",
                  1637.4 * (0.907 * (0.04395 - 0.01228) + 4 * 0.26 * 0.05849 * 0.02975), *brick.mass, 1e-3);
  EXPECT_EQ(std::get<Compound>(brick.shape).parts.size(), 5u);
  EXPECT_NEAR(0.03 - 0.029245, 0.000755, 1e-12) << "the play of a bearing key in its slot, m";
}

// A row of fuel bricks could roll along the fixed ones like gears on a rack, did the bearing keys not hold
// it.
TEST(BrickArray, HoldsTheRowBesideTheFrame) {
  const auto motion = dwell(4.0);
  scenes::BrickArrayOptions options;
  options.key_stiffness = 0.01;
  const auto measured = scenes::measured_velocities(scenes::brick_array(motion, options), *motion,
                                                    {"FB1(3)(4)", "FB2(2)(2)"}, 3.0, 1.0);
  const double beside = measured.ratio.at("FB1(3)(4)").at(1), middle = measured.ratio.at("FB2(2)(2)").at(1);
  EXPECT_LT(beside, 0.85 * middle) << beside << " and " << middle;
  EXPECT_GT(middle, 1.4) << "bricks in the middle are thrown from side to side";
}

// The least gap in the array is half of what a key has in the width of its slot: nothing touches at the
// start.
TEST(BrickArray, StartsWithItsGapsOpen) {
  const scenes::Running r(scenes::brick_array(dwell(5.0)));
  const auto frames = frames_of(r.model, r.state);
  double deepest = 0.0;
  for (std::size_t i = 0; i < r.state.contacts.points.size(); ++i)
    deepest = std::max(deepest, geometry_of(r.state.contacts.points, i, frames).overlap);
  EXPECT_EQ(deepest, 0.0);
  EXPECT_NEAR(0.5 * scenes::brick_pitch - 0.214 - 0.11025, 0.0022, 1e-12);
}

// Velocity and acceleration are the derivatives of the displacement, in the dwell and in the sweep.
TEST(SweptSine, IsOneMotion) {
  const scenes::SweptSine motion(0.3 * 9.81, 3.0, 10.0, 0.1, 2.0);
  const double dt = 1e-5;
  for (const double t : {0.3, 1.9, 2.5, 40.0, 71.0}) {
    const MotionSample before = motion.at(t - dt), now = motion.at(t), after = motion.at(t + dt);
    const auto rate = [&](double a, double b) { return (b - a) / (2.0 * dt); };
    EXPECT_NEAR(rate(before.displacement.x, after.displacement.x), now.velocity.x, 1e-6) << t;
    EXPECT_NEAR(rate(before.velocity.x, after.velocity.x), now.acceleration.x, 1e-4) << t;
  }
  EXPECT_NEAR(motion.end(), 72.0, 1e-12);
  EXPECT_NEAR(motion.frequency(37.0), 6.5, 1e-12);
}

// Speed at which two fuel bricks part over that at which they meet, face to face.
double binary_ratio(double point_restitution, double speed) {
  scenes::BrickArrayOptions options;
  options.restitution = point_restitution;
  Scene s = scenes::brick_array(dwell(5.0), options);
  std::erase_if(s.bodies, [](const Body& b) { return b.name != "FB2(1)(1)" && b.name != "FB2(2)(1)"; });
  s.terrains.clear();
  for (Body& brick : s.bodies) brick.velocity = {};
  s.bodies[0].position = {0.0, 0.0}, s.bodies[0].velocity = {speed, 0.0};
  s.bodies[1].position = {2.0 * 0.214 + 0.005, 0.0};
  scenes::Running r(s);
  auto run = scenes::run_for(0.02 / speed, 1e-3);
  run.step_fraction = 0.02;
  r.run(run);
  return (r.velocity(1).x - r.velocity(0).x) / speed;
}

// As in the published binary tests at 5 to 35 cm/s, about 0.9, and at the restitutions of the page's table.
TEST(FuelBricks, BounceAsMeasured) {
  for (const auto& [point, binary] : {std::pair{0.943, 0.90}, {0.917, 0.85}, {0.889, 0.80}})
    for (const double speed : {0.05, 0.35})
      expect_relative("M02",
                      "point restitution " + testing::text(point) + ", binary impact at " +
                          testing::text(speed) + " m/s, velocity ratio",
                      binary, binary_ratio(point, speed), 0.02);
}

}  // namespace
}  // namespace dougong::engine
