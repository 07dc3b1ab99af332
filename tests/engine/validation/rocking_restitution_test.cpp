// Experiment M04, and R10's need that the restitution of a rocking block be an input.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/engine/reference.h"
#include "tests/oracles/rocking.h"
#include "tests/oracles/synthetic_record.h"
#include "tests/scenes/record_motion.h"
#include "tests/scenes/rocking.h"

namespace dougong::engine {
namespace {

using oracles::RockingBlock;
using scenes::measured_impacts;
using scenes::run_for;
using scenes::Running;
using testing::expect_relative;
using testing::text;

Scene block_that_loses(const RockingBlock& c, double young_modulus) {
  Scene scene = scenes::tilted_block(c, 0.5 * c.alpha(), young_modulus, 2.0);
  scene.materials[0].rocking_restitution = c.restitution;
  return scene;
}

// A swing's height gives the spin at its ends.
double spin_of_swing(const RockingBlock& c, double amplitude) {
  return std::sqrt(std::cos(c.alpha() - amplitude) - std::cos(c.alpha()));
}

void expect_ratio(const std::string& experiment, const RockingBlock& c, double young_modulus,
                  double tolerance) {
  Running r(block_that_loses(c, young_modulus));
  auto options = run_for(6.0, 2e-4);
  options.step_fraction = 0.125;
  const auto impacts = measured_impacts(r, options, 4);
  ASSERT_EQ(impacts.size(), 4u);
  double amplitude = 0.5 * c.alpha();
  for (std::size_t i = 0; i < impacts.size(); ++i) {
    const double after = impacts[i].amplitude_after;
    expect_relative(experiment, "b=" + text(c.b) + " h=" + text(c.h) + " impact " + std::to_string(i + 1),
                    *c.restitution, spin_of_swing(c, after) / spin_of_swing(c, amplitude), tolerance);
    amplitude = after;
  }
}

TEST(RockingRestitution, OfConcreteAndRubberIsAsMeasured) {
  expect_ratio("M04", {0.2, 1.0, 9.81, 0.0, 0.895}, 300e9, 0.01);
  expect_ratio("M04", {0.2, 1.0, 9.81, 0.0, 0.631}, 300e9, 0.01);
}

TEST(RockingRestitution, IsKeptForOtherProportions) {
  expect_ratio("M04", {0.3, 0.9, 9.81, 0.0, 0.80}, 300e9, 0.01);
  expect_ratio("M04", {0.5, 2.5, 9.81, 0.0, 0.75}, 300e9, 0.01);
}

TEST(RockingRestitution, HardlyDependsOnTheStiffness) {
  expect_ratio("M04 3 GPa", {0.2, 1.0, 9.81, 0.0, 0.895}, 3e9, 0.01);
  expect_ratio("M04 30 GPa", {0.2, 1.0, 9.81, 0.0, 0.895}, 30e9, 0.01);
}

TEST(RockingRestitution, DecaysAsTheRigidBlockOfThatRatio) {
  const RockingBlock c{0.25, 1.0, 9.81, 0.0, 0.82};
  const auto exact = c.impacts(0.5 * c.alpha(), 5);
  Running r(block_that_loses(c, 30e9));
  const auto measured = measured_impacts(r, run_for(6.0, 5e-4), 5);
  ASSERT_EQ(measured.size(), exact.size());
  for (std::size_t i = 0; i < exact.size(); ++i)
    expect_relative("R10", "impact " + std::to_string(i + 1) + " t", exact[i].time, measured[i].time,
                    i == 0 ? 0.005 : 0.02);
}

TEST(RockingRestitution, MayBeAboveHousners) {
  for (const auto& [b, h, ratio] :
       {std::tuple{0.125, 0.5, 0.936}, {0.2, 1.0, 0.965}, {0.06, 0.5, 0.985}, {0.4, 1.0, 0.85}})
    expect_ratio("R10", {b, h, 9.81, 0.0, ratio}, 300e9, 0.01);
}

// Classical theory (Housner's block with another ratio) under a sine that grows for a second: R10's second
// kind of motion. Greatest angle of 4 s.
void expect_classical_under_sine(const RockingBlock& c, double over_uplift, double frequency) {
  constexpr double step = 0.002, duration = 4.0;
  std::vector<double> samples;
  for (double t = 0.0; t <= duration; t += step)
    samples.push_back(over_uplift * c.g * c.b / c.h * std::min(t, 1.0) *
                      std::sin(2.0 * std::numbers::pi * frequency * t));
  const auto ground = [&](double t) { return oracles::interpolated(samples, step, t); };
  const oracles::RockingHistory exact = oracles::DrivenRocking(c, ground, step / 5.0).run(duration);
  auto run = scenes::rocking_run(c, 300e9, 2.0, scenes::record_motion(samples, step), duration, duration);
  run.scene.materials[0].rocking_restitution = c.restitution;
  run.step_fraction = 0.125, run.output_interval = 1e-3;
  const oracles::RockingHistory measured = scenes::measured_rocking(run);
  const std::string label =
      "b=" + text(c.b) + " h=" + text(c.h) + " ratio " + text(*c.restitution) + " sine ";
  EXPECT_FALSE(exact.overturned || measured.overturned) << label;
  expect_relative("R10", label + "uplift", exact.uplift_time, measured.uplift_time, 0.005);
  expect_relative("R10", label + "greatest angle", exact.greatest_angle, measured.greatest_angle, 0.02);
}

TEST(RockingRestitution, UnderASineIsThatOfClassicalTheory) {
  expect_classical_under_sine({0.125, 0.5, 9.81, 0.0, 0.936}, 1.5, 3.3);
  expect_classical_under_sine({0.085, 0.5, 9.81, 0.0, 0.97}, 1.4, 4.0);
  expect_classical_under_sine({0.2, 0.6, 9.81, 0.0, 0.80}, 1.6, 3.0);
}

// Half of Housner's loss is what damping ratio 1 can spare; 0.99 is more than that.
TEST(RockingRestitution, OfMoreThanTheImpactCanSpareIsTheMostItCan) {
  RockingBlock asked{0.25, 1.0, 9.81, 0.0, 0.99};
  const auto amplitude_after_impact = [&] {
    Running r(block_that_loses(asked, 30e9));
    return measured_impacts(r, run_for(2.0, 5e-4), 1).at(0).amplitude_after / (0.5 * asked.alpha());
  };
  const double most = amplitude_after_impact();
  EXPECT_LT(most, 1.0);
  asked.restitution = 0.95;
  EXPECT_GT(most, amplitude_after_impact());
}

// A face gives no energy at any time, and all that is gone is in the ledger.
void expect_paid(double restitution) {
  const RockingBlock c{0.2, 1.0, 9.81, 0.0, restitution};
  Running r(block_that_loses(c, 30e9));
  const Energies start = r.energies();
  auto options = run_for(2.0, 1e-3);
  options.step_fraction = 0.1;
  double damping = start.damping;
  const double fallen = std::pow(c.spin_at_impact(0.5 * c.alpha()) / c.p(), 2);
  const double turned_over = 0.5 * r.model.mass[0] * c.g * std::hypot(c.b, c.h) * fallen;
  r.run(options, [&](const Sample&) {
    EXPECT_GE(r.energies().damping, damping - 1e-6 * turned_over) << restitution;
    damping = r.energies().damping;
    return Wish::go_on;
  });
  EXPECT_GT(damping - start.damping, 0.0) << restitution;
  EXPECT_NEAR((r.energies().balance() - start.balance()) / turned_over, 0.0, 0.01) << restitution;
}

TEST(RockingRestitution, IsPaidFromTheLedger) {
  expect_paid(0.6);
  expect_paid(0.97);
}

TEST(RockingRestitution, LeavesAStandingBlockAlone) {
  const RockingBlock c{0.25, 1.0, 9.81, 0.0, 0.5};
  auto run = scenes::rocking_run(c, 30e9, 2.0, nullptr, 0.0, 2.0);
  run.scene.materials[0].rocking_restitution = c.restitution;
  Running r(run.scene);
  r.run(run_for(2.0, 0.01));
  EXPECT_NEAR(r.angle(), 0.0, 1e-12);
  EXPECT_NEAR(r.spin(), 0.0, 1e-12);
}

TEST(RockingRestitution, IsRefusedWhereItMakesNoSense) {
  const RockingBlock c{0.25, 1.0, 9.81, 0.0, 0.9};
  const auto refused = [&](double ratio, double damping_ratio) {
    Scene scene = block_that_loses(c, 30e9);
    scene.materials[0].rocking_restitution = ratio;
    scene.materials[0].damping_ratio = damping_ratio;
    EXPECT_THROW(compile(scene), std::invalid_argument) << ratio << " " << damping_ratio;
  };
  refused(0.0, 1.0), refused(1.5, 1.0), refused(std::nan(""), 1.0), refused(0.9, 0.0);
}

}  // namespace
}  // namespace dougong::engine
