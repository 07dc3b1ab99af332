#include "seismic/motions/ground_motion.h"

#include <cstring>

#include "seismic/motions/harmonic_motion.h"
#include "seismic/motions/pulse_motion.h"
#include "tests/seismic/test_data.h"

namespace dougong::seismic {
namespace {

using engine::MotionSample;
using engine::PrescribedMotion;

// The derivative of a quantity from both sides of t by central differences.
template <typename Quantity>
double slope(const PrescribedMotion& motion, double t, double dt, Quantity quantity) {
  return (quantity(motion.at(t + dt)) - quantity(motion.at(t - dt))) / (2 * dt);
}

void expect_one_motion(const PrescribedMotion& motion, double end) {
  for (double t = 0.00331; t < end; t += 0.0277) {
    const MotionSample s = motion.at(t);
    const double v = slope(motion, t, 1e-5, [](const MotionSample& m) { return m.displacement.x; });
    const double a = slope(motion, t, 1e-5, [](const MotionSample& m) { return m.velocity.x; });
    ASSERT_NEAR(v, s.velocity.x, 1e-7) << t;
    ASSERT_NEAR(a, s.acceleration.x, 2e-5) << t;
  }
}

TEST(GroundMotion, IsOneFunctionOfTimeThroughRecordClosingAndAfter) {
  const auto a = testing::Syn(2008, 1.0).samples(0.01, 10.0);  // cut in the strong part: velocity is left
  const GroundMotion motion(a, std::nullopt, 0.01);
  EXPECT_GT(std::abs(motion.horizontal_velocity_left()), 0.005);
  expect_one_motion(motion, 14.0);
}

TEST(GroundMotion, PassesThroughTheSamplesAndTheirExactIntegrals) {
  const auto a = testing::record_a();
  const GroundMotion motion(a, std::nullopt, 0.01);
  const GroundHistory exact = integrate(a, 0.01);
  for (std::size_t k = 0; k < a.size(); k += 37) {
    const MotionSample s = motion.at(0.01 * static_cast<double>(k));
    EXPECT_NEAR(s.acceleration.x, a[k], 1e-11);
    EXPECT_NEAR(s.velocity.x, exact.velocity[k], 1e-12);
    EXPECT_NEAR(s.displacement.x, exact.displacement[k], 1e-12);
  }
  const MotionSample half = motion.at(5.005);
  EXPECT_NEAR(half.acceleration.x, 0.5 * (a[500] + a[501]), 1e-11);
}

TEST(GroundMotion, RestsBeforeTheStartAndBehindTheClosing) {
  const auto a = testing::Syn(2008, 1.0).samples(0.01, 10.0);
  const GroundMotion motion(a, std::nullopt, 0.01);
  EXPECT_EQ(motion.at(-1.0).acceleration.x, 0.0);
  EXPECT_EQ(motion.at(-1.0).displacement.x, 0.0);
  EXPECT_NEAR(motion.duration(), 11.0, 1e-12);
  const MotionSample end = motion.at(11.0), later = motion.at(1000.0);
  EXPECT_EQ(end.velocity.x, 0.0);
  EXPECT_EQ(later.velocity.x, 0.0);
  EXPECT_EQ(later.acceleration.x, 0.0);
  EXPECT_EQ(later.displacement.x, end.displacement.x);
  EXPECT_GT(motion.closing_acceleration(), 0.0);
}

TEST(GroundMotion, CoastsOnWhenAskedTo) {
  const std::vector<double> a = {1.0, 1.0, 1.0};
  const GroundMotion motion(a, std::nullopt, 0.5, {AfterEnd::coast, 1.0});
  EXPECT_DOUBLE_EQ(motion.at(3.0).velocity.x, 1.0);
  EXPECT_DOUBLE_EQ(motion.at(3.0).displacement.x, 2.5);
  EXPECT_EQ(motion.at(3.0).acceleration.x, 0.0);
}

TEST(GroundMotion, CarriesBothComponents) {
  const auto x = testing::Syn(1, 1.0).samples(0.01, 5.0), y = testing::Syn(2, 1.0).samples(0.01, 4.0);
  const GroundMotion motion(x, y, 0.01);
  const GroundMotion alone(y, std::nullopt, 0.01);
  EXPECT_EQ(motion.at(2.345).acceleration.y, alone.at(2.345).acceleration.x);
  EXPECT_EQ(motion.at(2.345).displacement.y, alone.at(2.345).displacement.x);
  EXPECT_EQ(motion.at(100.0).velocity.y, 0.0);
  EXPECT_EQ(motion.vertical()->acceleration.size(), motion.horizontal().acceleration.size());
}

TEST(GroundMotion, GivesTheSameBitsInAnyOrder) {
  const auto a = testing::record_a();
  const GroundMotion first(a, std::nullopt, 0.01), second(a, std::nullopt, 0.01);
  std::vector<MotionSample> forward;
  for (int i = 0; i < 5000; ++i) forward.push_back(first.at(0.0083 * i));
  for (int i = 4999; i >= 0; --i) {
    const MotionSample again = second.at(0.0083 * i);
    ASSERT_EQ(std::memcmp(&again, &forward[static_cast<std::size_t>(i)], sizeof again), 0) << i;
  }
}

TEST(GroundMotion, StatesItsKnots) {
  const std::vector<double> a(10, 0.0);
  EXPECT_EQ(GroundMotion(a, std::nullopt, 0.02).knot_interval(), 0.02);
}

TEST(GroundMotion, RefusesWhatIsNoMotion) {
  const std::vector<double> one = {1.0}, bad = {0.0, std::nan("")}, good = {0.0, 1.0};
  EXPECT_THROW(GroundMotion(one, std::nullopt, 0.01), std::invalid_argument);
  EXPECT_THROW(GroundMotion(bad, std::nullopt, 0.01), std::invalid_argument);
  EXPECT_THROW(GroundMotion(good, std::nullopt, 0.0), std::invalid_argument);
}

TEST(HarmonicMotion, StartsFromRestAndDrifts) {
  const HarmonicMotion motion(0.5 * 9.81, 2.0);
  EXPECT_EQ(motion.at(0.0).velocity.x, 0.0);
  EXPECT_EQ(motion.at(0.0).displacement.x, 0.0);
  EXPECT_NEAR(motion.at(0.125).acceleration.x, 0.5 * 9.81, 1e-12);
  const double w = 4 * std::numbers::pi;
  EXPECT_NEAR(motion.at(0.25).velocity.x, 2 * 4.905 / w, 1e-12);
  EXPECT_NEAR(motion.at(0.5).displacement.x, 4.905 / w * 0.5, 1e-12);
  EXPECT_EQ(motion.knot_interval(), 0.0);
  expect_one_motion(motion, 1.0);
}

TEST(PulseMotion, HasTheVelocityAndDistanceOfARectangle) {
  const PulseMotion motion({0.6 * 9.81}, 0.3);
  EXPECT_DOUBLE_EQ(motion.at(0.2).acceleration.x, 5.886);
  EXPECT_EQ(motion.at(0.31).acceleration.x, 0.0);
  EXPECT_NEAR(motion.at(0.3).velocity.x, 1.7658, 1e-14);
  EXPECT_NEAR(motion.at(1.3).displacement.x, 1.7658 * (0.15 + 1.0), 1e-13);
  EXPECT_EQ(motion.knot_interval(), 0.3);
  EXPECT_NEAR(motion.at(0.3 - 1e-12).velocity.x, motion.at(0.3 + 1e-12).velocity.x, 1e-10);
}

}  // namespace
}  // namespace dougong::seismic
