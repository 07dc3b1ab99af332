#include "structures/compose.h"

#include <cmath>

#include "structures/response.h"
#include "tests/structures/layouts/built.h"

namespace dougong::structures {
namespace {

using ::testing::HasSubstr;

Building statue(double height = 1.2) {
  return build_layout(
      "equipment",
      {{"item", word("equipment", "item", "statue")}, {"item_height", height}, {"floor_thickness", 0.0}});
}

template <class Compose>
std::string refusal_of(Compose compose) {
  try {
    compose();
  } catch (const LayoutError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(OnAFloor, StandsOnItsLevel) {
  const Building house = build_layout("masonry-house", {{"storeys", 3}});
  const Building both = on(house, statue(), {2, 1.5});
  expect_no_findings(both);
  const Bounds pedestal = bounds_of(both, index_of(both, "on.pedestal"));
  EXPECT_NEAR(pedestal.low.y, 2 * 2.8, 1e-12);
  EXPECT_NEAR(0.5 * (pedestal.low.x + pedestal.high.x), 1.5, 1e-12);
}

TEST(OnAFloor, IsFoundWhereItRunsIntoTheNextFloor) {
  const auto findings = check_model(on(build_layout("masonry-house"), statue(1.9), {1, 0.0}));
  ASSERT_FALSE(findings.empty());
  EXPECT_THAT(findings.front().message, HasSubstr("overlaps on.statue by 200 mm"));
}

TEST(OnAFloor, CountsInTheStoreyButNotInItsLevel) {
  const Building house = build_layout("masonry-house", {{"storeys", 3}});
  const Building both = on(house, statue(), {1, -1.0});
  expect_no_findings(both);
  EXPECT_EQ(both.storeys.size(), house.storeys.size());
  EXPECT_EQ(both.storeys[0].level_blocks, house.storeys[0].level_blocks);
  EXPECT_EQ(both.storeys[0].storey_blocks.size(), house.storeys[0].storey_blocks.size() + 2);
  Built built(both);
  expect_settles(built, 5e-3);
  EXPECT_EQ(both.parameters.at("on.name"), "equipment");
}

TEST(OnAFloor, HoldsWhatItsGroundHeld) {
  const Building tower = build_layout("rocking-frame", {{"tendons", 1.0},
                                                        {"columns", 2},
                                                        {"column_spacing", 0.8},
                                                        {"column_width", 0.2},
                                                        {"column_height", 1.0},
                                                        {"beam_depth", 0.2},
                                                        {"beam_overhang", 0.0},
                                                        {"deck_mass", 0.0},
                                                        {"tendon_force", 1e3}});
  const Building both = on(build_layout("masonry-house"), tower, {1, 0.0});
  for (const engine::Joint& joint : both.scene.joints) {
    ASSERT_FALSE(joint.a.terrain);
    EXPECT_EQ(both.scene.bodies[joint.a.index].name, "S1.floor");
    const engine::Vec2 at = both.scene.bodies[joint.a.index].position + joint.anchor_a;
    EXPECT_NEAR(at.y, 2.8, 1e-12);
    EXPECT_NEAR(std::abs(at.x), 0.4, 1e-12);
  }
}

TEST(OnAFloor, RefusesWhatDoesNotFit) {
  const Building house = build_layout("masonry-house");
  EXPECT_THAT(refusal_of([&] {
                on(house, statue(), {4, 0.0});
              }),
              HasSubstr("on.level: expected a level from 1 to 3"));
  EXPECT_THAT(refusal_of([&] { on(house, statue(), {1, 2.9}); }), HasSubstr("on.place"));
  EXPECT_THAT(refusal_of([&] {
                on(house, statue(), {3, 0.0});
              }),
              HasSubstr("on.place"))
      << "the roof is pitched";
  EXPECT_THAT(refusal_of([&] { on(house, build_layout("arch"), {1, 0.0}); }), HasSubstr("abutments"));
  const double sliding = word("column", "isolation", "sliding");
  EXPECT_THAT(refusal_of([&] {
                on(house, build_layout("column", {{"isolation", sliding}}), {1, 0.0});
              }),
              HasSubstr("on.isolation"));
}

TEST(Beside, KeepsTheGapAndBothGrounds) {
  const Building left = build_layout("four-storey"), right = build_layout("masonry-house");
  const Building both = beside(left, right, 0.05);
  expect_no_findings(both);
  EXPECT_EQ(both.scene.bodies.size(), left.scene.bodies.size() + right.scene.bodies.size());
  double edge = -1e9, other = 1e9;
  for (std::size_t i = 0; i < both.scene.bodies.size(); ++i) {
    const Bounds box = bounds_of(both, i);
    if (both.scene.bodies[i].name.starts_with("A."))
      edge = std::max(edge, box.high.x);
    else
      other = std::min(other, box.low.x);
  }
  EXPECT_NEAR(other - edge, 0.05, 1e-12);
  ASSERT_EQ(both.scene.terrains.size(), 2u);
  const auto ground = [&](std::size_t i) {
    const engine::Terrain& t = both.scene.terrains[i];
    const auto& corners = std::get<engine::ConvexPolygon>(t.shape).vertices();
    double low = 1e9, high = -1e9;
    for (const engine::Vec2 v : corners)
      low = std::min(low, t.position.x + v.x), high = std::max(high, t.position.x + v.x);
    return std::pair{low, high};
  };
  EXPECT_NEAR(ground(0).second, edge + 0.025, 1e-12);
  EXPECT_NEAR(ground(1).first, edge + 0.025, 1e-12);
}

TEST(Beside, LeavesEachItsPeriod) {
  const Built left("concrete-frame", {}), right("timber-frame", {});
  const Built both(beside(build_layout("concrete-frame"), build_layout("timber-frame"), 0.1));
  const double slow = right.first_period();
  EXPECT_NEAR(both.first_period(), slow, 1e-6 * slow);
}

// The first storey of the right-hand building drifts from the ground, not from the roof beside it.
TEST(Beside, MeasuresTheNeighboursDriftFromTheGround) {
  const Building both =
      beside(build_layout("column", {{"drums", 2}}), build_layout("column", {{"drums", 2}}), 0.1);
  Trajectory trajectory;
  trajectory.times = {0.0, 1.0};
  trajectory.blocks = 4;
  for (const double sway : {0.0, 0.1})
    for (std::size_t i = 0; i < 4; ++i) {
      const engine::Vec2 at = both.scene.bodies[i].position;
      const double moved[] = {sway, 2 * sway, 0.5 * sway, sway};
      trajectory.poses.insert(trajectory.poses.end(), {at.x + moved[i], at.y, 0.0});
    }
  trajectory.ground_displacement.assign(2, {});
  trajectory.ground_reaction.assign(2, {});
  trajectory.accelerations.assign(8, 0.0);
  const Response response = compute_response(both, trajectory);
  ASSERT_EQ(response.storeys.size(), 4u);
  EXPECT_NEAR(response.storeys[2].drift.back(), 0.05, 1e-12);
  EXPECT_NEAR(response.storeys[3].drift.back(), 0.05, 1e-12);
  EXPECT_EQ(response.storeys[2].name, "B.S1");
}

TEST(Beside, RefusesWhatDoesNotFit) {
  const Building house = build_layout("masonry-house");
  EXPECT_THAT(refusal_of([&] { beside(house, house, -0.1); }), HasSubstr("beside.gap"));
  const Building other = build_layout("masonry-house", {{"resting_damping_ratio", 0.1}});
  EXPECT_THAT(refusal_of([&] { beside(house, other, 0.1); }), HasSubstr("beside.resting_damping_ratio"));
}

TEST(Beside, GoesWithIsolationAndDampers) {
  const Building isolated =
      build_layout("four-storey", {{"isolation", word("four-storey", "isolation", "linear")}});
  Built built(beside(
      isolated, build_layout("timber-frame", {{"damper", word("timber-frame", "damper", "viscous")}}), 0.3));
  expect_no_findings(built.building);
  expect_settles(built, 5e-3);
}

}  // namespace
}  // namespace dougong::structures
