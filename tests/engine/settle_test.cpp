#include "engine/settle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/scenes/running.h"

namespace dougong::engine {
namespace {

using scenes::Running;

// Each joint carries what stands on it, on two springs; the block above is lowered by the sum below.
TEST(Settle, CompressesAColumnByItsWeight) {
  for (const auto& [count, b, h] : {std::tuple{1, 0.25, 1.0}, std::tuple{5, 0.3, 0.2}}) {
    Running r(scenes::column(count, b, h, 0.6, 1e9));
    const SettleReport report = settle(r.model, r.state);
    ASSERT_TRUE(report.settled) << report.detail;
    EXPECT_LT(report.unbalanced_ratio, 1e-4);
    const double weight = r.model.mass[0] * 9.81;
    double lowered = 0.0;
    for (int i = 0; i < count; ++i) {
      const double per_area = 1e9 / (i == 0 ? h : 2.0 * h);
      lowered += (count - i) * weight / (per_area * 2.0 * b);
      const double sunk = (2 * i + 1) * h - r.position(static_cast<std::size_t>(i)).y;
      EXPECT_NEAR(sunk / lowered, 1.0, 2e-3) << i << " of " << count;
    }
    EXPECT_NEAR(report.greatest_movement / lowered, 1.0, 2e-3);
  }
}

TEST(Settle, KeepsTheVelocitiesOfTheStartForTheRun) {
  Scene s = scenes::block_on_ground(0.5, 0.1, 0.6, 1e9);
  s.bodies[0].velocity = {2.0, 0.0};
  Running r(s);
  const double x = r.position().x;
  ASSERT_TRUE(settle(r.model, r.state).settled);
  EXPECT_NEAR(r.position().x, x, 1e-9);
  EXPECT_EQ(r.velocity().x, 2.0);
  r.run(scenes::run_for(1.0));
  EXPECT_NEAR(r.position().x - x, 4.0 / (2.0 * 0.6 * 9.81), 1e-3);
}

TEST(Settle, BringsAWallToRestWithItsWeightOnTheGround) {
  Running r(scenes::wall(3, 5, 0.6, 1e9));
  const SettleReport report = settle(r.model, r.state);
  ASSERT_TRUE(report.settled) << report.detail;
  for (const double v : r.state.v()) EXPECT_EQ(v, 0.0);
  EXPECT_EQ(r.state.time, 0.0);
  EXPECT_EQ(r.state.work.input, 0.0);
  Vec2 reaction;
  r.run(scenes::run_for(0.01), [&](const Sample& s) { return reaction = s.terrain_reaction, Wish::go_on; });
  EXPECT_NEAR(reaction.y / (r.model.total_mass() * 9.81), 1.0, 1e-3);
  EXPECT_NEAR(reaction.x / (r.model.total_mass() * 9.81), 0.0, 1e-3);
}

// A block that hangs from a bonded face: weight that comes at once would strain it twice as far.
TEST(Settle, BreaksNoBondThatHoldsTheWeightAtRest) {
  for (const double strength : {1.05, 0.95}) {
    Scene s = scenes::scene(0.6, 1e9);
    s.bodies.push_back(scenes::block(0.5, 0.5, {0.0, -0.5}));
    s.terrains.push_back(scenes::ground(2.0, {0.0, 2.0}));
    Bond b;
    b.name = "ceiling";
    b.a = {true, 0}, b.b = {false, 0};
    b.start = {-0.5, 0.0}, b.end = {0.5, 0.0};
    b.tensile_strength = strength * 2400.0 * 9.81;
    s.bonds.push_back(b);
    Running r(s);
    const SettleReport report = settle(r.model, r.state, {.longest_movement = 1.0});
    EXPECT_EQ(report.settled, strength > 1.0) << strength;
    EXPECT_EQ(r.state.bonds.broken, strength > 1.0 ? 0u : 2u) << strength;
  }
}

TEST(Settle, ReportsABuildingWithoutSupport) {
  Scene s = scenes::scene(0.6);
  s.bodies.push_back(scenes::block(0.5, 0.2, {0.0, 5.0}));
  s.bodies[0].name = "hanging";
  Running r(s);
  SettleOptions options;
  options.longest_time = 1.0;
  const SettleReport report = settle(r.model, r.state, options);
  EXPECT_FALSE(report.settled);
  EXPECT_EQ(report.moved_most, "hanging");
  EXPECT_GT(report.greatest_movement, 0.5);
}

// Let go over nothing it falls at g at most, and at least at what local damping leaves of it.
TEST(Settle, GivesUpWhatMovesAway) {
  Scene s = scenes::scene(0.6);
  s.bodies.push_back(scenes::block(0.5, 0.2, {0.0, 5.0}));
  Running r(s);
  SettleOptions options;
  options.longest_movement = 0.1;
  const SettleReport report = settle(r.model, r.state, options);
  EXPECT_FALSE(report.settled);
  EXPECT_GT(report.duration, std::sqrt(2.0 * 0.1 / 9.81));
  EXPECT_LT(report.duration, std::sqrt(2.0 * 0.1 / (0.2 * 9.81)));
  EXPECT_GT(report.greatest_movement, 0.1);
  EXPECT_LT(report.greatest_movement, 0.12);
}

TEST(Settle, HasNothingToDoWithoutGravity) {
  Scene s = scenes::block_on_ground(0.5, 0.2, 0.6);
  s.gravity = {};
  Running r(s);
  EXPECT_TRUE(settle(r.model, r.state).settled);
}

}  // namespace
}  // namespace dougong::engine
