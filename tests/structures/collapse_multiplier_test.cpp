// The collapse multiplier against closed forms: a block slides at mu or topples at b/h, a stack at b/(n h).
#include "structures/collapse_multiplier.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <span>

#include "tests/engine/reference.h"
#include "tests/oracles/statics.h"
#include "tests/scenes/running.h"

namespace dougong::structures {
namespace {

using ::testing::HasSubstr;

TiltOptions within(double precision) {
  TiltOptions options;
  options.precision = precision;
  options.trial.hold_time = 1.0;
  return options;
}

void expect_bracket(const std::string& name, double exact, const CollapseMultiplier& found,
                    double precision) {
  dougong::testing::report("R07", name + " collapse multiplier", exact, 0.5 * (found.stands + found.falls),
                           std::abs(0.5 * (found.stands + found.falls) / exact - 1.0), 1.5 * precision);
  EXPECT_EQ(found.end, TrialResult::falls);
  EXPECT_LE(found.falls - found.stands, precision * found.falls);
}

TEST(CollapseMultiplier, OfASlidingBlockIsItsFriction) {
  for (const double friction : {0.15, 0.4})
    expect_bracket("block, mu " + dougong::testing::text(friction), friction,
                   find_collapse_multiplier(scenes::block_on_ground(0.5, 0.5, friction, 1e8), within(0.005)),
                   0.005);
}

TEST(CollapseMultiplier, OfAStackIsItsSlenderness) {
  for (const int count : {1, 3}) {
    const oracles::Stack stack{0.4, 0.5, count};
    expect_bracket("stack of " + std::to_string(count), std::tan(stack.toppling_tilt()),
                   find_collapse_multiplier(scenes::column(count, stack.b, stack.h, 2.0, 1e9), within(0.01)),
                   0.01);
  }
}

// The mechanism says how: a stack topples about the right corner of its base, or the left one.
TEST(CollapseMultiplier, ShowsTheMechanism) {
  for (const Direction side : {Direction::left, Direction::right}) {
    TiltOptions options = within(0.02);
    options.towards = side;
    const double sign = side == Direction::right ? 1.0 : -1.0;
    const auto found = find_collapse_multiplier(scenes::column(2, 0.3, 0.5, 2.0, 1e9), options);
    ASSERT_EQ(found.mechanism.size(), 2u);
    EXPECT_LT(sign * found.mechanism[0].turn, 0.0);
    EXPECT_NEAR(found.mechanism[1].turn / found.mechanism[0].turn, 1.0, 0.02);
    EXPECT_NEAR(found.mechanism[1].translation.x / found.mechanism[0].translation.x, 3.0, 0.05);
  }
}

// More of the same weight on the same base stands as well: the multiplier knows neither density nor g.
TEST(CollapseMultiplier, DoesNotKnowTheWeight) {
  engine::Scene heavy = scenes::block_on_ground(0.25, 0.5, 0.3, 1e8), light = heavy;
  light.gravity = 0.1 * light.gravity;
  const auto a = find_collapse_multiplier(heavy, within(0.02)),
             b = find_collapse_multiplier(light, within(0.02));
  EXPECT_EQ(a.stands, b.stands);
  EXPECT_EQ(a.falls, b.falls);
}

TEST(CollapseMultiplier, IsZeroForWhatDoesNotStand) {
  engine::Scene leaning = scenes::block_on_ground(0.25, 0.5, 0.7, 1e8);
  leaning.bodies[0].angle = 0.6;
  leaning.bodies[0].position.y += 0.1;
  const auto found = find_collapse_multiplier(leaning);
  EXPECT_EQ(found.stands, 0.0);
  EXPECT_EQ(found.falls, 0.0);
  EXPECT_EQ(found.end, TrialResult::falls);
  EXPECT_EQ(found.trials.size(), 1u);
}

TEST(CollapseMultiplier, IsInfiniteForWhatNeverFalls) {
  engine::Scene glued = scenes::block_on_ground(0.5, 0.02, 5.0, 1e7);
  TiltOptions options = within(0.02);
  options.largest = 0.3;
  const auto found = find_collapse_multiplier(glued, options);
  EXPECT_NEAR(found.stands, 0.3, 1e-12);
  EXPECT_TRUE(std::isinf(found.falls));
}

// A block that falls on past its limit is found in the watch, not at the first sight of rest.
TEST(CollapseMultiplier, CallsAFallThatCannotEndUndecided) {
  TiltOptions options = within(0.02);
  options.trial.longest_time = 0.05;
  const auto found = find_collapse_multiplier(scenes::block_on_ground(0.5, 0.5, 0.2, 1e8), options);
  EXPECT_EQ(found.end, TrialResult::undecided);
}

// The lower end has been watched to the end, the others below it shortly, and what falls as ever.
TEST(CollapseMultiplier, WatchesToTheEndWhatStandsAtItsLowerEnd) {
  const engine::Scene stack = scenes::column(3, 0.4, 0.5, 2.0, 1e9);
  TiltOptions options = within(0.01);
  const auto found = find_collapse_multiplier(stack, options);
  const Trial& last = found.trials.back();
  EXPECT_EQ(last.result, TrialResult::stands);
  EXPECT_EQ(last.multiplier, found.stands);
  EXPECT_NEAR(last.watched, 1.0, 1e-9);
  for (const Trial& trial : std::span(found.trials).first(found.trials.size() - 1))
    EXPECT_NEAR(trial.watched, 0.1, trial.result == TrialResult::stands ? 1e-9 : 0.1) << trial.multiplier;
  options.preliminary_hold = 1.0;
  const auto slowly = find_collapse_multiplier(stack, options);
  EXPECT_EQ(slowly.stands, found.stands);
  EXPECT_EQ(slowly.falls, found.falls);
  EXPECT_EQ(slowly.trials.size() + 1, found.trials.size()) << "none of them is watched on";
}

// With a loose idea of rest a block that begins to slide is taken to stand, and found out by the whole watch.
TEST(CollapseMultiplier, GoesOnFromTheTrialBelowWhenTheWatchEndsInAFall) {
  TiltOptions options = within(0.02);
  options.trial.unbalanced_ratio = 0.05;
  options.trial.hold_time = 2.0;
  const engine::Scene block = scenes::block_on_ground(0.5, 0.5, 0.3, 1e8);
  const auto found = find_collapse_multiplier(block, options);
  const auto late = std::ranges::count_if(found.trials, [](const Trial& trial) {
    return trial.result == TrialResult::falls && trial.watched > 0.2;
  });
  EXPECT_GT(late, 0) << "else this test says nothing";
  options.preliminary_hold = 1.0;
  const auto slowly = find_collapse_multiplier(block, options);
  EXPECT_NEAR(found.stands, slowly.stands, 0.02 * slowly.falls);
  EXPECT_NEAR(found.falls, slowly.falls, 0.02 * slowly.falls);
  EXPECT_EQ(found.trials.back().result, TrialResult::stands);
  EXPECT_EQ(found.trials.back().multiplier, found.stands);
}

std::string refusal(const engine::Scene& scene, const TiltOptions& options = {}) {
  try {
    find_collapse_multiplier(scene, options);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(CollapseMultiplier, RefusesWhatCannotBeTilted) {
  engine::Scene floating = scenes::block_on_ground(0.5, 0.5, 0.5);
  floating.gravity = {};
  EXPECT_THAT(refusal(floating), HasSubstr("expected a scene with gravity, found none"));
  engine::Scene empty = scenes::block_on_ground(0.5, 0.5, 0.5);
  empty.bodies.clear();
  EXPECT_THAT(refusal(empty), HasSubstr("expected a scene with blocks, found none"));
  TiltOptions options;
  options.preliminary_hold = 0.0;
  EXPECT_THAT(refusal(scenes::block_on_ground(0.5, 0.5, 0.5), options), HasSubstr("preliminary hold"));
  options.precision = 0.0;
  EXPECT_THAT(refusal(scenes::block_on_ground(0.5, 0.5, 0.5), options), HasSubstr("precision"));
}

}  // namespace
}  // namespace dougong::structures
