#include "structures/response.h"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "structures/layouts/layout.h"
#include "tests/structures/scripted_run.h"

namespace dougong::structures {
namespace {

using engine::Vec2;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double degree = std::numbers::pi / 180.0;

Script frame() {
  return {.building = build_layout("four-storey")};
}
Script wall() {
  return {.building = build_layout("brick-wall")};
}

TEST(Drift, IsTheDifferenceOfLevelsOverTheOriginalHeight) {
  Script script = frame();
  script.block = [](const std::string& name, double t) {
    const double u = 0.028 * std::sin(2.0 * std::numbers::pi * t);
    if (name == "S1.slab") return Pose{u, 0, 0};
    if (name == "S2.slab") return Pose{3.0 * u, 0, 0};
    return Pose{};
  };
  const Response response = script.response();
  EXPECT_NEAR(response.storeys[0].drift[25], 0.01, 1e-12);  // 28 mm over 2.8 m
  EXPECT_NEAR(response.storeys[1].drift[25], 0.02, 1e-12);
  EXPECT_NEAR(response.storeys[2].drift[25], -0.03, 1e-12);
}

TEST(Drift, IsRelativeToTheMovingGround) {
  Script script = frame();
  script.ground = [](double t) { return Vec2{2.0 * t, -0.3 * t}; };
  const Response response = script.response();
  for (const StoreyResponse& storey : response.storeys) {
    EXPECT_NEAR(storey.drift.back(), 0.0, 1e-12);
    EXPECT_FALSE(storey.lost_at) << "the ground's own descent is no fall";
  }
  EXPECT_THAT(response.losses, IsEmpty());
}

TEST(Drift, KeepsBothSignedPeaksWithTheirTimes) {
  Script script = frame();
  script.block = [](const std::string&, double t) {
    return Pose{t < 2.5 ? 0.014 * std::sin(std::numbers::pi * t) : -0.056 * (t - 2.5), 0, 0};
  };
  const StoreyResponse first = script.response().storeys[0];
  EXPECT_NEAR(first.peak_drift.positive.value, 0.005, 1e-12);
  EXPECT_NEAR(first.peak_drift.positive.time, 0.5, 1e-12);
  EXPECT_NEAR(first.peak_drift.negative.value, -0.05, 1e-12);
  EXPECT_NEAR(first.peak_drift.negative.time, 5.0, 1e-12);
  EXPECT_NEAR(first.peak_drift.largest().value, -0.05, 1e-12);
}

TEST(Drift, IsMeasuredFromTheFirstOutputTime) {
  Script script = frame();
  script.block = [](const std::string&, double) { return Pose{0.05, -1e-4, 0.001}; };  // settled askew
  EXPECT_THAT(script.response().storeys[2].drift, Each(::testing::DoubleNear(0.0, 1e-12)));
}

// The level of isolators goes far and does not drift.
TEST(Drift, OfTheLevelOfIsolatorsDoesNotCount) {
  Response response;
  for (const auto& [name, is_base, drift] : {std::tuple{"raft", true, 0.4}, {"S1", false, 0.01}}) {
    StoreyResponse storey;
    storey.name = name, storey.is_base = is_base;
    storey.peak_drift.positive.value = storey.residual_drift = drift;
    response.storeys.push_back(storey);
  }
  EXPECT_EQ(storey_of_peak_drift(response)->name, "S1");
  EXPECT_EQ(storey_of_residual_drift(response)->name, "S1");
}

TEST(ResidualDrift, IsTheMeanOfTheLastSecond) {
  Script script = frame();
  script.block = [](const std::string& name, double t) {
    return Pose{
        name == "S1.slab" && t > 4.005 ? 0.0028 + 0.0007 * std::sin(20.0 * std::numbers::pi * t) : 0.0, 0, 0};
  };
  EXPECT_NEAR(script.response().storeys[0].residual_drift, 0.001, 2e-5);
}

TEST(LevelMean, IsWeightedByMass) {
  Script script = wall();
  // The half brick at the left end of the second course moves 0.1 m; it is 0.2495 of 12 x 0.5 - 11 x
  // 0.001 + ... m of bricks in that course.
  script.block = [](const std::string& name, double t) {
    return Pose{name == "C02.B01" ? 0.02 * t : 0.0, 0, 0};
  };
  const double course = 11 * 0.5 + 2 * 0.2495;
  EXPECT_NEAR(script.response().storeys[0].floor_displacement.back(), 0.1 * 0.2495 / course, 1e-12);
}

TEST(LevelMean, LeavesOutLostBlocks) {
  Script script = wall();
  script.block = [](const std::string& name, double t) {
    if (name == "C08.B01" && t > 1.0) return Pose{-2.0 * (t - 1.0), -2.0 * (t - 1.0), 0};
    return Pose{0.01, 0, 0};
  };
  const Response response = script.response();
  EXPECT_EQ(response.losses.size(), 1u);
  EXPECT_NEAR(response.storeys[3].floor_displacement.back(), 0.0, 1e-12);
  EXPECT_FALSE(response.storeys[3].lost_at);
}

TEST(RoofDisplacement, IsThatOfTheTopLevel) {
  Script script = frame();
  script.block = [](const std::string& name, double t) {
    return Pose{name == "S4.slab" ? 0.03 * t : 0.0, 0, 0};
  };
  const Response response = script.response();
  EXPECT_NEAR(response.roof_displacement.back(), 0.15, 1e-12);
  EXPECT_NEAR(response.peak_roof_displacement.positive.time, 5.0, 1e-12);
}

TEST(FloorAcceleration, IsTheAbsoluteOneOfTheLevelsBlocks) {
  Script script = frame();
  script.acceleration = [](const std::string& name, double t) {
    return name == "S2.slab" ? (t < 2.0 ? -4.0 : 3.0) : 1.0;
  };
  const StoreyResponse second = script.response().storeys[1];
  EXPECT_EQ(second.peak_acceleration.negative.value, -4.0);
  EXPECT_EQ(second.peak_acceleration.positive.value, 3.0);
  EXPECT_NEAR(second.peak_acceleration.positive.time, 2.0, 1e-12);
}

TEST(BaseShear, IsTheGroundsPushAndComparedWithTheWeight) {
  Script script = frame();
  script.shear = [](double t) { return t > 3.0 ? -2e5 : 1e5; };
  const Response response = script.response();
  const double mass = 2400.0 * 4 * (10.7 * 0.2 + 2 * 0.3 * 2.6);
  EXPECT_NEAR(response.weight, mass * 9.80665, 1e-6);
  EXPECT_EQ(response.base_shear.front(), 1e5);
  EXPECT_EQ(response.peak_base_shear.largest().value, -2e5);
  EXPECT_NEAR(response.peak_base_shear_ratio.negative.value, -2e5 / (mass * 9.80665), 1e-12);
}

// Slabs and columns at their heights, all accelerated alike, on a ground that rises.
TEST(OverturningMoment, IsTheInertiaForcesTimesTheirHeights) {
  Script script = frame();
  script.ground = [](double t) { return Vec2{0.0, 0.1 * t}; };
  script.acceleration = [](const std::string&, double t) { return t > 2.0 ? 3.0 : -1.0; };
  const Response response = script.response();
  double first = 0.0;  // kg m
  for (int storey = 0; storey < 4; ++storey)
    first += 2400.0 * (2 * 0.3 * 2.6 * (2.8 * storey + 1.3) + 10.7 * 0.2 * (2.8 * storey + 2.7));
  EXPECT_NEAR(response.overturning_moment.front(), -first, 1e-6);
  EXPECT_NEAR(response.overturning_moment.back(), 3.0 * first, 1e-6);
  EXPECT_NEAR(response.peak_overturning_moment.positive.value, 3.0 * first, 1e-6);
  EXPECT_NEAR(response.height, 11.2, 1e-12);
}

TEST(OverturningMoment, PeaksBeforeAStoreyIsLost) {
  Script script = frame();
  script.block = [](const std::string&, double t) { return Pose{0, t > 3.0 ? -2.0 * (t - 3.0) : 0.0, 0}; };
  script.acceleration = [](const std::string&, double t) { return t > 3.5 ? 100.0 : 1.0; };
  const Response response = script.response();
  EXPECT_LT(response.peak_overturning_moment.positive.value, 0.1 * response.overturning_moment.back());
}

TEST(Loss, IsNotASlenderColumnRockingAtTenDegrees) {
  Script script = frame();
  script.block = [](const std::string& name, double t) {
    if (name.find("column") == std::string::npos) return Pose{};
    // About its foot's corner, as a rigid block rocks: R = 1.3086 m at 6.58 deg from the vertical.
    const double angle = 10.0 * degree * std::sin(2.0 * t), half_width = angle < 0.0 ? 0.15 : -0.15;
    const Vec2 arm{half_width, 1.3};
    const Vec2 moved = engine::rotated(arm, angle) - arm;
    return Pose{moved.x, moved.y, angle};
  };
  const Response response = script.response();
  EXPECT_THAT(response.losses, IsEmpty());
  EXPECT_FALSE(response.first_loss_of_support);
}

TEST(Loss, IsABrickThatDroppedOneCourse) {
  Script script = wall();
  script.block = [](const std::string& name, double t) {
    return Pose{0, name == "C08.B13" ? -std::min(0.25, std::max(0.0, t - 2.0)) : 0.0, 0};
  };
  const Response response = script.response();
  ASSERT_EQ(response.losses.size(), 1u);
  EXPECT_NEAR(response.losses[0].time, 2.13, 1e-9);  // past half its height
  EXPECT_EQ(response.losses[0].reason, "fell 0.13 m (0.25 m at the end)");
  EXPECT_EQ(script.building.scene.bodies[response.losses[0].block].name, "C08.B13");
}

TEST(Loss, IsASlabThatFellWithTheStoreyBelow) {
  Script script = frame();
  // The first storey gives way: its columns turn over and everything above comes down as it stood.
  script.block = [](const std::string& name, double t) {
    const double fall = -std::min(2.3, std::max(0.0, t - 2.0));
    if (name.starts_with("S1.column")) return Pose{0, fall / 2, fall};
    return Pose{0, fall, 0};
  };
  const Response response = script.response();
  for (const StoreyResponse& storey : response.storeys) ASSERT_TRUE(storey.lost_at) << storey.name;
  EXPECT_NEAR(*response.storeys[0].lost_at, 2.105, 0.0051);  // a tenth of a metre down
  EXPECT_NEAR(*response.storeys[3].lost_at, 2.105, 0.0051);  // a tenth of a metre down
  EXPECT_EQ(response.losses.size(), 12u);
  EXPECT_NEAR(response.fallen_mass_fraction, 1.0, 1e-12);
}

TEST(Loss, IsABlockThatTurnedHalfWayOver) {
  Script script = frame();
  script.block = [](const std::string& name, double t) {
    return Pose{0, 0, name == "S4.column.left" ? -20.0 * degree * t : 0.0};
  };
  const Response response = script.response();
  ASSERT_EQ(response.losses.size(), 1u);
  EXPECT_NEAR(response.losses[0].time, 2.26, 1e-9);
  EXPECT_EQ(response.losses[0].reason, "turned -45 deg");
}

TEST(Loss, IsABrickPushedOutOfItsCourse) {
  Script script = wall();
  script.block = [](const std::string& name, double t) {
    return Pose{name == "C01.B12" ? 0.2 * t : 0.0, 0, 0};
  };
  const Response response = script.response();
  ASSERT_EQ(response.losses.size(), 1u);
  EXPECT_NEAR(response.losses[0].time, std::hypot(0.5, 0.25) / 0.2, 0.01);
  EXPECT_THAT(response.losses[0].reason, HasSubstr("past its neighbours"));
}

TEST(Loss, IsNotABuildingThatSlidesAsOne) {
  Script script = frame();
  script.block = [](const std::string&, double t) { return Pose{2.0 * t, 0, 0}; };
  EXPECT_THAT(script.response().losses, IsEmpty());
}

TEST(Loss, IsNotARollingBall) {
  Script script = frame();
  engine::Body ball;
  ball.name = "ball";
  ball.shape = engine::make_circle(0.2);
  script.building.scene.bodies.push_back(ball);
  script.block = [](const std::string& name, double t) {
    return Pose{0, 0, name == "ball" ? 10.0 * t : 0.0};
  };
  EXPECT_THAT(script.response().losses, IsEmpty());
}

TEST(Loss, IsForGood) {
  Script script = frame();
  script.block = [](const std::string& name, double t) {
    return Pose{0, 0, name == "S4.slab" && t > 1.0 && t < 2.0 ? 1.0 : 0.0};
  };
  const StoreyResponse top = script.response().storeys[3];
  EXPECT_NEAR(*top.lost_at, 1.01, 1e-9);
  EXPECT_GT(top.mass_lost.back(), 0.4);
}

TEST(LossOfSupport, BeginsWhereTheFallBegins) {
  Script script = wall();
  // Up by 20 mm, as a rocking block goes first, then down for good; below its place from t = 1.3 s.
  script.block = [](const std::string& name, double t) {
    if (name != "C08.B01") return Pose{};
    return Pose{0, t < 1.0 ? 0.02 * t : 0.02 - 0.0125 / 0.3 * (t - 1.0) - (t > 1.3 ? 2.0 * (t - 1.3) : 0.0),
                0};
  };
  const Response response = script.response();
  ASSERT_TRUE(response.first_loss_of_support);
  // A tenth of the drop of 0.125 m at which it counts as fallen.
  EXPECT_NEAR(*response.first_loss_of_support, 1.3 + (0.0125 + 0.0075) / (2.0 + 0.0125 / 0.3), 0.0101);
  EXPECT_LT(*response.first_loss_of_support, response.losses[0].time);
}

TEST(LostStorey, FreezesItsDriftAndKeepsThePeakBefore) {
  Script script = frame();
  script.block = [](const std::string& name, double t) {
    if (name != "S4.slab") return Pose{};
    return Pose{0.01 * t, t > 3.0 ? -2.0 * (t - 3.0) : 0.0, 0};
  };
  const StoreyResponse top = script.response().storeys[3];
  ASSERT_TRUE(top.lost_at);
  EXPECT_NEAR(*top.lost_at, 3.06, 1e-9);  // 0.1 m down
  const double kept = 0.01 * 3.05 / 2.8;
  EXPECT_NEAR(top.drift.back(), kept, 1e-12);
  EXPECT_NEAR(top.residual_drift, kept, 1e-12);
  EXPECT_NEAR(top.peak_drift.positive.value, kept, 1e-12);
  EXPECT_EQ(top.lost_because, "100 % of its level's mass was lost");
}

TEST(LostStorey, HasNoFloorAccelerationAfterwards) {
  Script script = frame();
  script.block = [](const std::string&, double t) { return Pose{0, t > 3.0 ? -2.0 * (t - 3.0) : 0.0, 0}; };
  script.acceleration = [](const std::string&, double t) { return t > 3.5 ? 100.0 : 1.0; };
  const StoreyResponse top = script.response().storeys[3];
  EXPECT_EQ(top.floor_acceleration.back(), 0.0);
  EXPECT_EQ(top.peak_acceleration.positive.value, 1.0);
}

TEST(LostStorey, TakesTheStoreysAboveWithIt) {
  Script script = frame();
  script.block = [](const std::string& name, double t) {
    return Pose{0, name == "S2.slab" && t > 1.0 ? -1.0 : 0.0, 0};
  };
  const Response response = script.response();
  EXPECT_FALSE(response.storeys[0].lost_at);
  EXPECT_EQ(response.storeys[1].lost_because, "100 % of its level's mass was lost");
  EXPECT_EQ(response.storeys[2].lost_because, "the level below was lost");
  EXPECT_EQ(*response.storeys[3].lost_at, *response.storeys[1].lost_at);
}

TEST(LostStorey, IsLostWithBothItsColumns) {
  Script script = frame();
  script.block = [](const std::string& name, double t) {
    if (name == "S3.column.left" && t > 1.0) return Pose{0, 0, 1.0};
    if (name == "S3.column.right" && t > 2.0) return Pose{0, 0, 1.0};
    return Pose{};
  };
  const Response response = script.response();
  EXPECT_FALSE(response.storeys[1].lost_at);
  EXPECT_NEAR(*response.storeys[2].lost_at, 2.01, 1e-9);
  EXPECT_EQ(response.storeys[2].lost_because, "everything that carried it was lost");
}

TEST(LostStorey, NeedsMoreThanHalfOfItsLevel) {
  Script script = wall();
  const auto fall_first = [&](int bricks) {
    script.block = [bricks](const std::string& name, double t) {
      const bool falls = name.starts_with("C08.B") && std::stoi(name.substr(5)) <= bricks;
      return Pose{0, falls && t > 1.0 ? -0.5 : 0.0, 0};
    };
    return script.response().storeys[3].lost_at.has_value();
  };
  EXPECT_FALSE(fall_first(6));  // five and a half bricks of twelve
  EXPECT_TRUE(fall_first(7));   // six and a half
}

TEST(TotalLoss, IsWhenTheLastStoreyWent) {
  Script script = frame();
  EXPECT_FALSE(total_loss(script.building, script.trajectory()));
  script.block = [](const std::string& name, double t) {
    const bool first = name.starts_with("S4");
    return t < (first ? 1.0 : 2.0) ? Pose{} : Pose{0.0, -5.0, 0.0};
  };
  EXPECT_NEAR(total_loss(script.building, script.trajectory()).value(), 2.0, 0.011);
  const Trajectory whole = script.trajectory(), ends = at_steps(whole, {0, whole.times.size() - 1});
  EXPECT_THAT(ends.times, ::testing::ElementsAre(0.0, script.trajectory().times.back()));
  EXPECT_EQ(total_loss(script.building, ends), ends.times.back()) << "no more is known between";
  script.block = [](const std::string& name, double) {
    return name.starts_with("S4") ? Pose{0.0, -5.0, 0.0} : Pose{};
  };
  EXPECT_FALSE(total_loss(script.building, script.trajectory())) << "three storeys stand";
}

TEST(MassLost, GrowsByTheBlocksThatFell) {
  Script script = wall();
  script.block = [](const std::string& name, double t) {
    return Pose{0, name == "C07.B03" && t > 1.0 ? -0.5 : 0.0, 0};
  };
  const Response response = script.response();
  const StoreyResponse& top = response.storeys[3];
  const double one = 0.5 * 0.25, storey = (12 * 0.5 + 11 * 0.5 + 2 * 0.2495) * 0.25;
  EXPECT_EQ(top.mass_lost.front(), 0.0);
  EXPECT_NEAR(top.mass_lost.back(), one / storey, 1e-12);
  EXPECT_NEAR(response.fallen_mass_fraction, one / (4.0 * storey), 1e-12);
  EXPECT_NEAR(top.original_mass, 1800.0 * storey, 1e-9);
}

TEST(LossCriteria, MoveTheLimits) {
  Script script = frame();
  script.block = [](const std::string& name, double t) {
    return Pose{0, 0, name == "S1.column.left" ? 6.0 * degree * t : 0.0};
  };
  EXPECT_THAT(script.response().losses, IsEmpty());
  EXPECT_EQ(script.response({.turn = 20.0 * degree}).losses.size(), 1u);
}

TEST(GreatestLean, ComparesEveryBlockWithItsOwnToppling) {
  Script script = frame();
  script.block = [](const std::string& name, double t) {
    if (name == "S2.column.left") return Pose{0, 0, -0.01 * t};  // slender: topples at 6.58 deg
    if (name == "S3.slab") return Pose{0, 0, 0.02 * t};          // lies flat: at 88.9 deg
    return Pose{};
  };
  const Lean lean = script.response().greatest_lean;
  EXPECT_EQ(lean.block, "S2.column.left");
  EXPECT_NEAR(lean.angle, -0.05, 1e-12);
  EXPECT_NEAR(lean.limit, std::atan(0.3 / 2.6), 1e-12);
  EXPECT_NEAR(lean.ratio(), 0.05 / std::atan(0.3 / 2.6), 1e-12);
}

TEST(ComputeResponse, RefusesATrajectoryOfAnotherBuilding) {
  const Trajectory trajectory = frame().trajectory();
  EXPECT_THROW(compute_response(build_layout("ten-storey"), trajectory), std::invalid_argument);
  Trajectory short_of_shear = trajectory;
  short_of_shear.ground_reaction.pop_back();
  EXPECT_THROW(compute_response(build_layout("four-storey"), short_of_shear), std::invalid_argument);
}

TEST(ComputeResponse, TakesARunThatNeverStarted) {
  Trajectory nothing;
  nothing.blocks = 12;
  const Response response = compute_response(build_layout("four-storey"), nothing);
  EXPECT_EQ(response.storeys.size(), 4u);
  EXPECT_GT(response.weight, 0.0);
  EXPECT_THAT(response.losses, IsEmpty());
}

TEST(ComputeResponse, DoesNotTakeNonFiniteNumbersForAFall) {
  Script script = frame();
  script.block = [](const std::string&, double t) {
    const double bad = t > 1.0 ? std::numeric_limits<double>::quiet_NaN() : 0.0;
    return Pose{bad, bad, bad};
  };
  EXPECT_THAT(script.response().losses, IsEmpty());
}

}  // namespace
}  // namespace dougong::structures
