// Validation cases S02 and S03: a block that slides under a record, on level ground and on a slope.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/engine/reference.h"
#include "tests/oracles/record_sliding.h"
#include "tests/oracles/synthetic_record.h"
#include "tests/scenes/record_motion.h"
#include "tests/scenes/running.h"

namespace dougong::engine {
namespace {

using oracles::RecordSlider;
using oracles::SlidingHistory;
using scenes::run_for;
using scenes::Running;
using testing::expect_absolute;
using testing::expect_relative;
using testing::text;

constexpr double degree = std::numbers::pi / 180.0, g = 9.81, record_step = 0.01;

std::vector<double> record(std::uint32_t seed, double amplitude) {
  return oracles::SyntheticMotion(seed, amplitude).samples(record_step);
}

TEST(SyntheticRecord, IsTheReference) {
  double peak = 0.0;
  for (const double a : record(2008, 1.0)) peak = std::max(peak, std::abs(a));
  EXPECT_NEAR(peak, 2.634698442, 1e-9);
  EXPECT_NEAR(oracles::SyntheticMotion(2008, 1.0).at(5.004), 0.6865403397, 1e-10);
  EXPECT_NEAR(oracles::SyntheticMotion(2008, 1.0).at(10.004), 0.0681104363, 1e-10);
}

TEST(RecordMotion, IsItsOwnIntegral) {
  const auto motion = scenes::record_motion(record(2008, 1.0), record_step);
  for (const double t : {0.005, 3.1415, 7.7777, 39.99, 45.0}) {
    const double h = 1e-5;
    const auto before = motion->at(t - h), now = motion->at(t), after = motion->at(t + h);
    EXPECT_NEAR((after.displacement.x - before.displacement.x) / (2 * h), now.velocity.x, 1e-9) << t;
    EXPECT_NEAR((after.velocity.x - before.velocity.x) / (2 * h), now.acceleration.x, 1e-6) << t;
  }
  EXPECT_NEAR(motion->at(40.0).displacement.x, -0.323637733, 1e-9);
}

// A low block that lies in equilibrium, E 0.3 GPa.
Scene block_on_slope(double slope, double friction, const std::vector<double>& samples) {
  const double b = 0.5, h = 0.05, young_modulus = 0.3e9;
  Scene s = scenes::scene(friction, young_modulus);
  s.terrains.push_back(scenes::ground(200.0, {}, -slope, scenes::record_motion(samples, record_step)));
  const double sunk = 2400.0 * 2.0 * h * g * std::cos(slope) * h / young_modulus;
  s.bodies.push_back(scenes::block(b, h, rotated({0.0, h - sunk}, -slope), -slope));
  return s;
}

SlidingHistory measured_sliding(double slope, double friction, const std::vector<double>& samples) {
  Running r(block_on_slope(slope, friction, samples));
  const auto motion = r.model.motions.at(0);
  const Vec2 start = r.position(), down = rotated({1.0, 0.0}, -slope);
  SlidingHistory measured;
  double last_place = 0.0;
  bool slipped = false;
  r.run(run_for(40.0, 1e-3), [&](const Sample& sample) {
    const auto ground = motion->at(sample.state.time);
    const double place = dot(r.position() - start - ground.displacement, down);
    measured.path += std::abs(place - last_place), last_place = place;
    measured.last = place, measured.greatest = std::max(measured.greatest, std::abs(place));
    measured.greatest_speed =
        std::max(measured.greatest_speed, std::abs(dot(r.velocity() - ground.velocity, down)));
    const bool slips = std::abs(dot(sample.terrain_reaction, down)) >
                       0.99999 * friction * dot(sample.terrain_reaction, turned(down));
    if (measured.first_slip < 0.0 && slips) measured.first_slip = sample.state.time;
    measured.episodes += slips && !slipped ? 1 : 0, slipped = slips;
    return Wish::go_on;
  });
  return measured;
}

void compare(const std::string& name, const std::string& label, const SlidingHistory& exact,
             const SlidingHistory& measured) {
  expect_relative(name, label + " final", exact.last, measured.last, 0.02);
  expect_relative(name, label + " greatest", exact.greatest, measured.greatest, 0.02);
  expect_relative(name, label + " path", exact.path, measured.path, 0.02);
  expect_relative(name, label + " greatest speed", exact.greatest_speed, measured.greatest_speed, 0.02);
  expect_relative(name, label + " first slip", exact.first_slip, measured.first_slip, 0.02);
  if (name == "S03") expect_absolute(name, label + " slips", exact.episodes, measured.episodes, 0);
}

void check_level(std::uint32_t seed, double amplitude, double friction) {
  const auto samples = record(seed, amplitude);
  compare("S02", "SYN(" + std::to_string(seed) + ", " + text(amplitude) + ") mu=" + text(friction),
          RecordSlider::on_level_ground(friction, g).under(samples, record_step),
          measured_sliding(0.0, friction, samples));
}

TEST(SlidingUnderARecord, IsTheReference) {
  const auto exact = RecordSlider::on_level_ground(0.2, g).under(record(2008, 2.0), record_step);
  EXPECT_NEAR(exact.last, 0.0382781, 1e-7);
  EXPECT_NEAR(exact.path, 0.107822, 1e-6);
  // The reference table reads the peaks at the record's samples: 0.0435839 m and 0.161706 m/s.
  EXPECT_NEAR(exact.greatest, 0.0435995, 1e-7);
  EXPECT_NEAR(exact.greatest_speed, 0.163211, 1e-6);
  EXPECT_NEAR(exact.first_slip, 2.83589, 1e-5);
  check_level(2008, 2.0, 0.2);
}
TEST(SlidingUnderARecord, IsTheReferenceForOtherRecordsToo) {
  check_level(2011, 3.0, 0.35);
}

void check_slope(std::uint32_t seed, double amplitude, double slope, double friction) {
  const auto samples = record(seed, amplitude);
  compare("S03",
          "SYN(" + std::to_string(seed) + ", " + text(amplitude) + ") slope=" + text(slope / degree) +
              " mu=" + text(friction),
          RecordSlider::on_slope(slope, friction, g).under(samples, record_step),
          measured_sliding(slope, friction, samples));
}

TEST(SlidingDownASlopeUnderARecord, IsTheReference) {
  const auto exact = RecordSlider::on_slope(15.0 * degree, 0.5, g).under(record(2008, 1.5), record_step);
  EXPECT_NEAR(exact.last, 0.0129159, 1e-7);
  EXPECT_EQ(exact.episodes, 11);
  check_slope(2008, 1.5, 15.0 * degree, 0.5);
}
TEST(SlidingDownASlopeUnderARecord, IsTheReferenceForOtherSlopesToo) {
  check_slope(2011, 1.0, 10.0 * degree, 0.3);
}

}  // namespace
}  // namespace dougong::engine
