#include "structures/collapse.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "structures/compose.h"
#include "structures/layouts/layout.h"
#include "tests/structures/scripted_run.h"

namespace dougong::structures {
namespace {

using engine::Vec2;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double degree = std::numbers::pi / 180.0;

/// Every block of a storey or above it: "S2.slab" stands over storey 1.
int storey_of(const std::string& name) {
  return name[1] - '0';
}
bool is_column(const std::string& name) {
  return name.find("column") != std::string::npos;
}

Script frame() {
  return {.building = build_layout("four-storey")};
}

/// Columns of 2.6 m that lean by `angle` from t = 1 s on, at 20 degrees a second, to 80 degrees.
double lean(double t) {
  return std::clamp(20.0 * (t - 1.0), 0.0, 80.0) * degree;
}
/// Where the top of a column that leans has gone.
Vec2 top_of(double angle) {
  return Vec2{2.6 * std::sin(angle), 2.6 * (std::cos(angle) - 1.0)};
}

/// These storeys lean, the others ride on them.
Script leaning(const std::function<bool(int)>& leans) {
  Script script = frame();
  script.block = [leans](const std::string& name, double t) {
    const Vec2 top = top_of(lean(t));
    Pose pose{0.0, 0.0, 0.0};
    for (int below = 1; below < storey_of(name); ++below)
      if (leans(below)) pose.x += top.x, pose.y += top.y;
    if (!leans(storey_of(name))) return pose;
    const double share = is_column(name) ? 0.5 : 1.0;
    return Pose{pose.x + share * top.x, pose.y + share * top.y, is_column(name) ? -lean(t) : 0.0};
  };
  return script;
}

Collapse described(const Script& script) {
  return describe_collapse(script.building, script.trajectory());
}

/// Turns about the right corner of its foot.
Script toppling_column(double drums, const std::function<double(double)>& angle) {
  Script script{.building = build_layout("column", {{"drums", drums}})};
  script.block = [angle, building = script.building](const std::string& name, double t) {
    for (const engine::Body& body : building.scene.bodies) {
      if (body.name != name) continue;
      const Vec2 arm = body.position - Vec2{0.5, 0.0}, moved = engine::rotated(arm, -angle(t)) - arm;
      return Pose{moved.x, moved.y, -angle(t)};
    }
    return Pose{};
  };
  return script;
}

// --- the mode --------------------------------------------------------------------------------------

TEST(CollapseMode, IsASoftStoreyWhereOneStoreyLeans) {
  const Collapse collapse = described(leaning([](int storey) { return storey == 1; }));
  EXPECT_EQ(collapse.mode, CollapseMode::soft_storey);
  EXPECT_THAT(collapse.reasons, Contains(HasSubstr("S1 had 100 % of the displacement")));
}

TEST(CollapseMode, IsSwayWhereAllStoreysLean) {
  EXPECT_EQ(described(leaning([](int) { return true; })).mode, CollapseMode::sway);
}

TEST(CollapseMode, IsSwayInABuildingOfOneStorey) {
  Script script = leaning([](int storey) { return storey == 1; });
  script.building = build_layout("four-storey", {{"storeys", 1}});
  EXPECT_EQ(described(script).mode, CollapseMode::sway);
}

TEST(CollapseMode, IsOverturningOfABlockAndOfAColumnOfDrums) {
  for (const double drums : {1.0, 5.0}) {
    const Collapse collapse =
        described(toppling_column(drums, [](double t) { return std::min(30.0 * t, 90.0) * degree; }));
    EXPECT_EQ(collapse.mode, CollapseMode::overturning) << drums;
    EXPECT_THAT(collapse.reasons, Contains(HasSubstr("explains 100 %"))) << drums;
  }
}

// A tower whose drums shear on each other leans as far, and none of them turns.
TEST(CollapseMode, IsNotOverturningWhereTheBlocksDoNotTurn) {
  Script script{.building = build_layout("column", {{"drums", 5}})};
  script.block = [](const std::string& name, double t) {
    const double over = std::max(0.0, 0.2 * (t - 1.0)) * static_cast<double>(storey_of(name));
    return Pose{over, storey_of(name) == 5 && t > 3.0 ? -3.0 * (t - 3.0) : 0.0, 0.0};
  };
  const Collapse collapse = described(script);
  EXPECT_TRUE(collapse.happened());
  EXPECT_NE(collapse.mode, CollapseMode::overturning);
}

TEST(CollapseMode, IsSlidingWhereACourseLeavesTheWall) {
  for (const double levels : {2.0, 4.0}) {  // a quarter, a half of the storey's courses
    Script script{.building = build_layout("brick-wall", {{"levels", levels}})};
    script.block = [](const std::string& name, double t) {
      return Pose{name.starts_with("C08") && t > 1.0 ? 0.5 * (t - 1.0) : 0.0, 0.0, 0.0};
    };
    EXPECT_EQ(described(script).mode, CollapseMode::sliding) << levels;
  }
}

TEST(CollapseMode, IsPartialWallWhereBricksFallFromAWallThatStands) {
  Script script{.building = build_layout("brick-wall")};
  script.block = [](const std::string& name, double t) {
    return Pose{0.0, name.starts_with("C08") && t > 1.0 ? -0.5 * (t - 1.0) : 0.0, 0.0};
  };
  EXPECT_EQ(described(script).mode, CollapseMode::partial_wall);
}

TEST(CollapseMode, IsPartialWhereNoStoreyIsLost) {
  Script script{.building = build_layout("brick-wall")};
  script.block = [](const std::string& name, double t) {
    return Pose{0.0, name == "C08.B01" && t > 1.0 ? -(t - 1.0) : 0.0, 0.0};
  };
  const Collapse collapse = described(script);
  EXPECT_EQ(collapse.mode, CollapseMode::partial);
  EXPECT_FALSE(collapse.complete);
}

/// The columns of the first storey are kicked out, and all floors come straight down on each other.
Script pancake() {
  Script script = frame();
  script.block = [](const std::string& name, double t) {
    const double fall = std::max(0.0, 2.0 * (t - 1.0));
    if (is_column(name) && storey_of(name) == 1)
      return Pose{name.ends_with("left") ? -fall : fall, -std::min(fall, 1.15), std::min(fall, 1.5)};
    return Pose{0.0, -std::min(fall, 2.6), 0.0};
  };
  return script;
}

TEST(CollapseMode, IsAPancakeWhereFloorsComeStraightDown) {
  const Collapse collapse = described(pancake());
  EXPECT_EQ(collapse.mode, CollapseMode::pancake);
}

TEST(CollapseMode, IsOutOfSupportWhereASlabSlidesOffColumnsThatStand) {
  Script script = frame();
  script.block = [](const std::string& name, double t) {
    if (name != "S4.slab" || t < 1.0) return Pose{};
    return Pose{0.3 * (t - 1.0), t > 2.0 ? -3.0 * (t - 2.0) : 0.0, 0.0};
  };
  EXPECT_EQ(described(script).mode, CollapseMode::out_of_support);
}

/// Two buildings 0.1 m apart; the right one leans to the left until it touches, and comes down after.
Script neighbours(double reach, double falls_at) {
  Script script{.building = beside(build_layout("four-storey", {{"storeys", 1}}),
                                   build_layout("four-storey", {{"storeys", 1}}), 0.1)};
  script.block = [=](const std::string& name, double t) {
    if (!name.starts_with("B.")) return Pose{};
    const double over = -reach * std::clamp(t - 1.0, 0.0, 1.0);
    return Pose{over, t > falls_at ? -2.0 * (t - falls_at) : 0.0, t > falls_at ? t - falls_at : 0.0};
  };
  return script;
}

TEST(CollapseMode, IsPoundingWhereNeighboursTouchedJustBefore) {
  const Collapse collapse = described(neighbours(0.1, 2.5));
  EXPECT_EQ(collapse.mode, CollapseMode::pounding);
  ASSERT_TRUE(collapse.first_touch);
  EXPECT_NEAR(*collapse.first_touch, 2.0, 0.0101);
}

TEST(CollapseMode, IsNotPoundingWhereTheyStayedApart) {
  const Collapse collapse = described(neighbours(0.09, 2.5));
  EXPECT_NE(collapse.mode, CollapseMode::pounding);
  EXPECT_FALSE(collapse.first_touch);
}

TEST(CollapseMode, IsNoneOfABuildingThatStands) {
  const Collapse collapse = described(frame());
  EXPECT_FALSE(collapse.happened());
  EXPECT_THAT(collapse.falls, IsEmpty());
  EXPECT_FALSE(collapse.initiation);
}

// --- when ------------------------------------------------------------------------------------------

// A block of 1 m by 1 m has its centroid highest when it stands on its corner, at 45 degrees.
TEST(NoReturn, IsWhereABlockStandsOverItsCorner) {
  const Script script = toppling_column(1, [](double t) {
    return (t < 3.0 ? 10.0 * (1.0 - std::cos(std::numbers::pi * t)) : 20.0 + 40.0 * (t - 3.0)) * degree;
  });
  const double height = 2.0 * script.building.scene.bodies[0].position.y;
  const double over_corner = std::atan2(1.0, height) / degree;
  const Collapse collapse = described(script);
  ASSERT_TRUE(collapse.no_return);
  EXPECT_NEAR(*collapse.no_return, 3.0 + (over_corner - 20.0) / 40.0, 0.0051);
}

TEST(NoReturn, IsWhereTheFallBeginsWhenNothingIsLifted) {
  const Collapse collapse = described(pancake());
  EXPECT_NEAR(*collapse.no_return, 1.0, 0.0101);
}

// Of two bricks the second falls at 1 s; the first, heavier, is thrown up from 2 s on and falls at 3 s.
TEST(NoReturn, IsThatOfTheFirstBlockWhereNoStoreyWasLost) {
  Script script = frame();
  for (const char* name : {"heavy", "light"}) {
    engine::Body brick;
    brick.name = name, brick.shape = engine::make_rectangle(0.2, 0.1), brick.position = {0.0, 0.05};
    brick.mass = name[0] == 'h' ? 40.0 : 4.0;
    script.building.scene.bodies.push_back(brick);
  }
  script.block = [](const std::string& name, double t) {
    if (name == "light") return Pose{0.0, -std::clamp(t - 1.0, 0.0, 1.0), 0.0};
    if (name == "heavy") return Pose{0.0, t < 3.0 ? std::max(0.0, t - 2.0) : 4.0 - t, 0.0};
    return Pose{};
  };
  const Collapse collapse = described(script);
  EXPECT_EQ(collapse.mode, CollapseMode::partial);
  EXPECT_NEAR(*collapse.no_return, 1.0, 0.0101);
}

TEST(Initiation, IsThatOfTheStoreysThatWereLostNotOfABrickBefore) {
  Script script = pancake();
  const auto fall = script.block;
  engine::Body brick;
  brick.name = "brick", brick.shape = engine::make_rectangle(0.2, 0.1), brick.position = {0.0, 0.05};
  script.building.scene.bodies.push_back(brick);
  script.block = [fall](const std::string& name, double t) {
    if (name == "brick") return Pose{0.0, -t, 0.0};
    return fall(name, t);
  };
  EXPECT_NEAR(*described(script).initiation, 1.01, 0.0101);
  EXPECT_GT(*described(script).complete, 1.0);
}

// --- debris ----------------------------------------------------------------------------------------

TEST(Footprint, ReachesAsFarAsTheOutermostCornerOfTheDebris) {
  Script script = frame();
  script.ground = [](double t) { return Vec2{0.2 * t, 0.0}; };
  // A quarter turn: the column lies, 2.6 m long, with its middle 2 m outside the slabs' ends at 5.35 m.
  script.block = [](const std::string& name, double t) {
    if (name != "S4.column.right") return Pose{};
    return t > 1.0 ? Pose{2.35, -8.4, std::numbers::pi / 2.0} : Pose{};
  };
  const Collapse collapse = described(script);
  const double mass = 2400.0 * 0.3 * 2.6;
  EXPECT_NEAR(collapse.footprint.face_right, 5.35, 1e-12);
  EXPECT_NEAR(collapse.footprint.height, 11.2, 1e-12);
  EXPECT_NEAR(collapse.footprint.right.reach, 5.0 + 2.35 + 1.3 - 5.35, 1e-9);
  EXPECT_NEAR(collapse.footprint.right.mass, mass, 1e-9);
  EXPECT_EQ(collapse.footprint.left.reach, 0.0);
  EXPECT_EQ(collapse.footprint.left.mass, 0.0);
}

TEST(Footprint, LeavesOutWhatFellOffTheGround) {
  Script script = frame();
  script.block = [](const std::string& name, double t) {
    return Pose{name == "S4.slab" ? t : 0.0, name == "S4.slab" ? -10.0 * t : 0.0, 0.0};
  };
  const Collapse collapse = described(script);
  EXPECT_EQ(collapse.footprint.over_the_edge, 1u);
  EXPECT_EQ(collapse.footprint.right.reach, 0.0);
}

// Dropped by h it hits with m g h, less what half an interval of the fall is worth.
TEST(Impact, OfADroppedSlabHasTheEnergyOfItsHeight) {
  constexpr double g = 9.80665, h = 2.6;
  Script script = frame();
  script.block = [=](const std::string& name, double t) {
    const double since = std::max(0.0, t - 1.0);
    return Pose{0.0, name == "S4.slab" ? -std::min(h, 0.5 * g * since * since) : 0.0, 0.0};
  };
  const Collapse collapse = described(script);
  ASSERT_EQ(collapse.falls.size(), 1u);
  const Fall& fall = collapse.falls.front();
  const double mass = 2400.0 * 10.7 * 0.2, v = std::sqrt(2.0 * g * h), whole = mass * g * h;
  EXPECT_LE(fall.energy, whole);
  EXPECT_GT(fall.energy, whole * (1.0 - 3.0 * g * script.interval / v));
  EXPECT_NEAR(fall.hit, 1.0 + v / g, 0.0201);
  EXPECT_NEAR(fall.speed, v, 2.0 * g * script.interval);
  EXPECT_NEAR(fall.support_lost, 1.05, 0.011);  // down by a hundredth of a metre: sqrt(2 x 0.01/g)
  EXPECT_EQ(collapse.impact_energy, fall.energy);
}

TEST(Impact, OfASpinningBlockCountsItsSpin) {
  Script script = frame();
  script.block = [](const std::string& name, double t) {
    return Pose{0.0, 0.0, name == "S4.slab" && t > 1.0 ? 2.0 * (t - 1.0) : 0.0};
  };
  const double mass = 2400.0 * 10.7 * 0.2, inertia = mass * (10.7 * 10.7 + 0.2 * 0.2) / 12.0;
  const Collapse collapse = described(script);
  ASSERT_EQ(collapse.falls.size(), 1u);
  EXPECT_NEAR(collapse.falls.front().energy, 0.5 * inertia * 4.0, 1e-6 * inertia);
}

}  // namespace
}  // namespace dougong::structures
