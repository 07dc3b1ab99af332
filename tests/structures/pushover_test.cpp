// Pushover against statics: where a stack overturns under each pattern, how a rocking block resists, where a
// bonded wall cracks (B07).
#include "structures/pushover.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "structures/load_pattern.h"
#include "tests/engine/reference.h"
#include "tests/scenes/bonded_bars.h"
#include "tests/scenes/running.h"

namespace dougong::structures {
namespace {

using ::testing::HasSubstr;

std::vector<double> forces_of(const engine::Scene& scene, LoadPattern pattern) {
  scenes::Running r(scene);
  engine::settle(r.model, r.state);
  return pattern_forces(r.model, r.state, pattern);
}

CollapseMultiplier bracket(const engine::Scene& scene, const std::vector<double>& forces, Direction side,
                           double precision = 0.01) {
  TiltOptions options;
  options.precision = precision;
  options.trial.hold_time = 1.0;
  return find_collapse_multiplier(
      scene, [&](double multiplier) { return pushed(scene, forces, multiplier, side); }, options);
}

void expect_bracket(const std::string& name, double exact, const CollapseMultiplier& found,
                    double tolerance) {
  dougong::testing::report("R07", name, exact, 0.5 * (found.stands + found.falls),
                           std::abs(0.5 * (found.stands + found.falls) / exact - 1.0), tolerance);
  EXPECT_EQ(found.end, TrialResult::falls) << name;
  EXPECT_GE(found.falls, (1.0 - tolerance) * exact) << name;
  EXPECT_LE(found.stands, (1.0 + tolerance) * exact) << name;
}

TEST(LoadPattern, AddsUpToTheWeight) {
  const engine::Scene scene = scenes::column(4, 0.4, 0.5, 0.7, 1e9);
  const double weight = 4 * 0.8 * 1.0 * scene.materials[0].density * 9.81;
  for (const LoadPattern pattern : load_patterns()) {
    const auto forces = forces_of(scene, pattern);
    EXPECT_NEAR(std::accumulate(forces.begin(), forces.end(), 0.0), weight, 1e-6 * weight)
        << to_string(pattern);
  }
  const auto triangle = forces_of(scene, LoadPattern::triangular);
  EXPECT_NEAR(triangle[3] / triangle[0], 7.0, 1e-3) << "compressed by its weight";
}

TEST(LoadPattern, OfTheFirstModeGrowsUpwards) {
  const auto forces = forces_of(scenes::column(4, 0.4, 0.5, 0.7, 1e9), LoadPattern::first_mode);
  for (std::size_t i = 0; i + 1 < forces.size(); ++i) EXPECT_LT(forces[i], forces[i + 1]);
  EXPECT_GT(forces.front(), 0.0);
}

// One block, b/h = 0.25, topples at 0.25 or slides at its friction, towards either side.
TEST(Pushover, OfOneBlockIsItsSlendernessOrItsFriction) {
  for (const Direction side : {Direction::left, Direction::right})
    for (const auto& [friction, exact] : {std::pair{0.7, 0.25}, {0.15, 0.15}}) {
      const engine::Scene scene = scenes::block_on_ground(0.25, 1.0, friction, 1e9);
      expect_bracket("block pushed, mu " + dougong::testing::text(friction), exact,
                     bracket(scene, forces_of(scene, LoadPattern::mass), side), 0.01);
    }
}

// Forces W y_i sum(W)/sum(W y) topple n blocks of half sizes b, h about the foot at
// lambda = n b / sum y, ..., here sum y / sum y^2 b: 9/35 b/h for three, against b/(3 h) under equal forces.
TEST(Pushover, OfAStackDependsOnThePattern) {
  const double b = 0.4, h = 0.5;
  const engine::Scene scene = scenes::column(3, b, h, 2.0, 1e9);
  expect_bracket("stack of 3 pushed, mass", b / (3.0 * h),
                 bracket(scene, forces_of(scene, LoadPattern::mass), Direction::right), 0.015);
  expect_bracket("stack of 3 pushed, triangular", 9.0 / 35.0 * b / h,
                 bracket(scene, forces_of(scene, LoadPattern::triangular), Direction::right), 0.015);
}

PushoverOptions until(double peak, double target, Direction side = Direction::right) {
  PushoverOptions options;
  options.peak = peak, options.target = target, options.towards = side;
  return options;
}

// A rigid block turned by theta about its corner is held by lambda = tan(alpha - theta), its centroid
// displaced by R (sin(alpha) - sin(alpha - theta)).
TEST(CapacityCurve, OfARockingBlockFallsAsItTurns) {
  const double b = 0.25, h = 1.0, alpha = std::atan(b / h), radius = std::hypot(b, h);
  const engine::Scene scene = scenes::block_on_ground(b, h, 0.8, 30e9);
  for (const Direction side : {Direction::left, Direction::right}) {
    const CapacityCurve curve =
        capacity_curve(scene, forces_of(scene, LoadPattern::mass), until(0.25, 0.22, side));
    double worst = 0.0;
    std::size_t turned = 0;
    for (const CapacityPoint& p : curve.points) {
      if (p.roof < 1e-3) continue;
      const double theta = alpha - std::asin(std::sin(alpha) - p.roof / radius);
      worst = std::max(worst, std::abs(p.multiplier - std::tan(alpha - theta)));
      ++turned;
    }
    dougong::testing::report("R07", "rocking block pushed over, worst of V/W", 0.0, worst, worst, 2e-3);
    EXPECT_LT(worst, 2e-3);
    EXPECT_GT(turned, 20u);
    EXPECT_GT(curve.points.back().roof, 0.2);
    EXPECT_EQ(curve.events.size(), 0u);
  }
}

// B07: bonded to the ground over its whole width, its base opens at 0.102749 g. What is left of the joint
// then helps its weight to hold it.
TEST(CapacityCurve, OfABondedWallCracksWhereItsBaseOpens) {
  engine::Scene scene = scenes::scene(0.8, 5e9);
  scene.terrains.push_back(scenes::ground());
  const engine::Owner base{true, 0};
  scenes::BondedBar wall;
  wall.depth = 1.0, wall.modulus = 5e9, wall.shear_modulus = 2e9, wall.density = 2000.0, wall.count = 6,
  wall.end = {0.0, 6.0};
  scenes::add_bar(scene, wall, &base, nullptr);
  for (engine::Body& body : scene.bodies) body.collides = true;
  for (engine::Bond& bond : scene.bonds) bond.tensile_strength = 1e5, bond.cohesion = 1e6;
  PushoverOptions options = until(0.1667, 0.1);
  options.rising_step = 0.01;
  const CapacityCurve curve = capacity_curve(scene, forces_of(scene, LoadPattern::mass), options);
  ASSERT_FALSE(curve.events.empty());
  const BondEvent& first = curve.events.front();
  const auto at_base = std::ranges::find(curve.events, 5u, &BondEvent::bond);
  ASSERT_NE(at_base, curve.events.end());
  EXPECT_EQ(at_base->point, first.point) << "its jolt may crack another, none cracks before it";
  EXPECT_EQ(at_base->how, "tension");
  const double before = curve.points[first.point - 1].multiplier;
  dougong::testing::report("B07", "pushed bonded wall cracks after V/W", 0.102749, before,
                           std::abs(before / 0.102749 - 1.0), 0.03);
  EXPECT_NEAR(before, 0.102749, 0.03 * 0.102749);
  EXPECT_GT(curve.points[curve.peak()].multiplier, 1.0 / 6.0) << "what is left of the joint holds it too";
}

std::string refusal(const engine::Scene& scene, const std::vector<double>& forces,
                    const PushoverOptions& options) {
  try {
    capacity_curve(scene, forces, options);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(CapacityCurve, RefusesWhatCannotBePushed) {
  const engine::Scene scene = scenes::block_on_ground(0.25, 1.0, 0.7, 1e9);
  EXPECT_THAT(refusal(scene, {1.0, 2.0}, until(0.2, 0.1)),
              HasSubstr("a force for each of 1 blocks, found 2"));
  EXPECT_THAT(refusal(scene, {1.0}, until(0.0, 0.1)), HasSubstr("a positive peak"));
  engine::Scene floating = scene;
  floating.gravity = {};
  EXPECT_THAT(refusal(floating, {1.0}, until(0.2, 0.1)), HasSubstr("gravity"));
}

}  // namespace
}  // namespace dougong::structures
