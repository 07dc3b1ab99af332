#include "app/study/tradeoff/distance.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dougong::app {
namespace {

using structures::Trajectory;

/// Two bodies at two output times.
Trajectory trajectory(double second_x, double second_angle, double ground = 0.0) {
  Trajectory t;
  t.times = {0.0, 0.5};
  t.blocks = 2;
  t.poses = {0, 0, 0, 5, 0, 0, 0, 0, 0, 5 + second_x, 0, second_angle};
  t.ground_displacement = {{0, 0}, {ground, 0}};
  return t;
}

Yardstick yardstick(Measure measure) {
  return {measure, {0, 1}, {1.0, 2.0}};
}

TEST(Distance, OfARunFromItselfIsNothing) {
  const Trajectory t = trajectory(3.0, 1.0);
  for (const Measure m : {Measure::rms, Measure::largest, Measure::end})
    EXPECT_EQ(distance(yardstick(m), t, t), 0.0);
}

TEST(Distance, CountsTurnsAtTheRadiusOfGyration) {
  const Trajectory a = trajectory(0.0, 0.0), b = trajectory(3.0, 2.0);
  EXPECT_DOUBLE_EQ(distance(yardstick(Measure::largest), a, b), 5.0) << "3 m and 2 m x 2";
  EXPECT_DOUBLE_EQ(distance(yardstick(Measure::end), a, b), std::sqrt(25.0 / 2.0)) << "one of two bodies";
  EXPECT_DOUBLE_EQ(distance(yardstick(Measure::rms), a, b), std::sqrt(25.0 / 4.0)) << "and one of two times";
}

TEST(Distance, LooksAtTheChosenBodiesOnly) {
  Yardstick first = yardstick(Measure::largest);
  first.bodies = {0};
  EXPECT_EQ(distance(first, trajectory(0.0, 0.0), trajectory(3.0, 2.0)), 0.0);
}

TEST(Distance, IsNoNumberBetweenRunsOfOtherOutputTimes) {
  Trajectory shorter = trajectory(0.0, 0.0);
  shorter.times.pop_back();
  EXPECT_TRUE(std::isnan(distance(yardstick(Measure::rms), shorter, trajectory(0.0, 0.0))));
  EXPECT_TRUE(std::isnan(distance(yardstick(Measure::rms), {}, {})));
}

TEST(Distance, IsNoNumberWhenAMotionIsNotFinite) {
  EXPECT_FALSE(
      std::isfinite(distance(yardstick(Measure::largest), trajectory(NAN, 0.0), trajectory(0.0, 0.0))));
}

TEST(LargestWay, IsRelativeToTheGround) {
  EXPECT_DOUBLE_EQ(largest_way(yardstick(Measure::rms), trajectory(3.0, 0.0)), 3.0);
  EXPECT_DOUBLE_EQ(largest_way(yardstick(Measure::rms), trajectory(3.0, 0.0, 3.0)), 3.0)
      << "the second body rides, the first stays behind";
  EXPECT_DOUBLE_EQ(largest_way(yardstick(Measure::rms), trajectory(3.0, 0.0, 1.0)), 2.0);
}

TEST(GreatestSpeed, IsOverAnOutputInterval) {
  EXPECT_DOUBLE_EQ(greatest_speed(yardstick(Measure::rms), trajectory(3.0, 0.0)), 6.0);
}

TEST(Measure, IsReadByItsName) {
  EXPECT_EQ(measure_from("end"), Measure::end);
  EXPECT_EQ(to_string(Measure::rms), "rms");
  EXPECT_THROW(measure_from("mean"), std::invalid_argument);
}

}  // namespace
}  // namespace dougong::app
