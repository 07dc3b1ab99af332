// Experiment M04, and R10's need that the restitution of a rocking block be an input.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/reference.h"
#include "tests/oracles/rocking.h"
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

TEST(RockingRestitution, AboveHousnersIsHousners) {
  const RockingBlock c{0.25, 1.0, 9.81};
  RockingBlock asked = c;
  asked.restitution = 0.99;
  Running free(scenes::tilted_block(c, 0.5 * c.alpha(), 30e9, 2.0)), told(block_that_loses(asked, 30e9));
  free.run(run_for(1.0, 0.01)), told.run(run_for(1.0, 0.01));
  EXPECT_EQ(told.angle(), free.angle());
}

TEST(RockingRestitution, TakesItsLossFromTheLedger) {
  const RockingBlock c{0.2, 1.0, 9.81, 0.0, 0.6};
  Running r(block_that_loses(c, 30e9));
  const Energies start = r.energies();
  auto options = run_for(2.0, 0.01);
  options.step_fraction = 0.1;
  r.run(options);
  const Energies end = r.energies();
  EXPECT_GT(end.damping, 0.5 * (start.gravity - end.gravity));
  EXPECT_NEAR((end.balance() - start.balance()) / (start.gravity - end.gravity), 0.0, 0.01);
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
