// The mechanism of blocks whose collapse is known: one that slides, a stack that topples, a trilith.
#include "structures/mechanism.h"

#include <gtest/gtest.h>

#include "tests/scenes/running.h"

namespace dougong::structures {
namespace {

Mechanism found_of(const engine::Scene& scene, Direction side = Direction::right) {
  TiltOptions options;
  options.precision = 0.02;
  options.trial.hold_time = 1.0;
  options.towards = side;
  const CollapseMultiplier found = find_collapse_multiplier(scene, options);
  return mechanism_of(engine::compile(scene), found.standing, found.mechanism);
}

TEST(Mechanism, OfASlidingBlockIsOneSlidingJoint) {
  const Mechanism m = found_of(scenes::block_on_ground(0.5, 0.5, 0.2, 1e8));
  ASSERT_EQ(m.joints.size(), 1u);
  EXPECT_EQ(m.joints[0].action, JointAction::sliding);
  EXPECT_EQ(m.joints[0].a, 0u);
  EXPECT_EQ(m.joints[0].b, 1u) << "the ground, numbered behind the blocks";
  EXPECT_NEAR(m.joints[0].place.x, 0.0, 1e-3);
  EXPECT_LT(std::abs(m.joints[0].opening), 0.1 * std::abs(m.joints[0].slip));
}

// It turns as one about the corner it leans on.
TEST(Mechanism, OfAStackIsAHingeAtItsFoot) {
  for (const Direction side : {Direction::left, Direction::right}) {
    const Mechanism m = found_of(scenes::column(2, 0.3, 0.5, 2.0, 1e9), side);
    ASSERT_EQ(m.joints.size(), 1u);
    EXPECT_EQ(m.joints[0].action, JointAction::hinge);
    EXPECT_EQ(m.joints[0].b, 2u);
    EXPECT_NEAR(m.joints[0].place.x, side == Direction::right ? 0.3 : -0.3, 1e-3);
    EXPECT_NEAR(m.joints[0].place.y, 0.0, 1e-3);
    EXPECT_EQ(m.moving, (std::vector<std::size_t>{1, 0}));
  }
}

TEST(Mechanism, OfNothingThatMovesIsEmpty) {
  const scenes::Running r(scenes::column(2, 0.3, 0.5, 2.0, 1e9));
  const Mechanism m = mechanism_of(r.model, r.state, {{}, {}});
  EXPECT_TRUE(m.moving.empty());
  EXPECT_TRUE(m.joints.empty());
  EXPECT_TRUE(mechanism_of(r.model, r.state, {}).joints.empty()) << "nothing fell";
}

}  // namespace
}  // namespace dougong::structures
