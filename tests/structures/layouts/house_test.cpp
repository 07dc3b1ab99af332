// Masonry house and equipment.
#include <cmath>

#include "structures/collapse_multiplier.h"
#include "tests/structures/layouts/built.h"

namespace dougong::structures {
namespace {

using ::testing::HasSubstr;

const std::string house = "masonry-house";

TEST(MasonryHouse, StandsWithEveryFloorJointAndTie) {
  for (const char* floors : {"timber", "concrete"})
    for (const char* joints : {"mortar", "dry"})
      for (const char* ties : {"none", "every-floor"}) {
        Built built(house, {{"floors", word(house, "floors", floors)},
                            {"joints", word(house, "joints", joints)},
                            {"ties", word(house, "ties", ties)}});
        expect_no_findings(built.building);
        expect_settles(built, 5e-3);
      }
}

TrialResult tilted_to(const ParameterMap& values, double multiplier) {
  const Building building = build_layout(house, values);
  Built built(building);
  TrialOptions options;
  options.hold_time = 2.0;
  Trial trial;
  for (const double part : {0.6, 0.9, 1.0}) {
    trial = hold(tilted(building.scene, part * multiplier), built.state, options);
    if (trial.result != TrialResult::stands) break;
  }
  return trial.result;
}

// One storey with a slab on the full width of its walls: they rock over together at t/h.
TEST(MasonryHouse, OfOneStoreyUnderASlabRocksAtItsWallsSlenderness) {
  const ParameterMap values{{"storeys", 1},
                            {"floors", word(house, "floors", "concrete")},
                            {"joints", word(house, "joints", "dry")},
                            {"wall_thickness", 0.4}};
  const double slenderness = 0.4 / (2.8 - 0.2);
  EXPECT_EQ(tilted_to(values, 0.96 * slenderness), TrialResult::stands);
  EXPECT_EQ(tilted_to(values, 1.04 * slenderness), TrialResult::falls);
}

TEST(MasonryHouse, RefusesWhatDoesNotFit) {
  EXPECT_THAT(refusal(house, {{"bearing", 0.48}}), HasSubstr("bearing"));
  EXPECT_THAT(refusal(house, {{"wall_thickness", 2.0}}), HasSubstr("wall_thickness"));
  EXPECT_THAT(refusal(house, {{"floor_depth", 2.0}}), HasSubstr("floor_depth"));
  EXPECT_THAT(refusal(house, {{"tie_length", 3.0}}), HasSubstr("tie_length"));
  EXPECT_THAT(refusal(house, {{"width", 12.0}}), HasSubstr("ground_width"));
}

const std::string room = "equipment";

TEST(Equipment, Stands) {
  for (const char* item : {"cabinet", "rack", "statue"})
    for (const double floor : {0.0, 0.2}) {
      Built built(room, {{"item", word(room, "item", item)}, {"floor_thickness", floor}});
      expect_no_findings(built.building);
      expect_settles(built, 2e-3);
      EXPECT_EQ(built.building.storeys.size(), floor > 0.0 ? 2u : 1u);
    }
}

TEST(Equipment, HasTheMassItWasGiven) {
  const Building building = build_layout(room, {{"item", word(room, "item", "rack")}, {"item_mass", 800.0}});
  double boxes = 0.0;
  for (std::size_t i = 0; i < building.scene.bodies.size(); ++i)
    if (building.scene.bodies[i].name.starts_with("box")) boxes += mass_of(building, i);
  EXPECT_NEAR(boxes, 800.0, 1e-9);
}

// A cask of North Anna (comparison M05), 115 t, 4.9 m by 2.4 m: stands at 0.3 g by friction or slenderness.
TEST(Equipment, TopplesOrSlidesAsABlock) {
  const auto falls = [](double friction, double multiplier) {
    const Building building = build_layout(room, {{"floor_thickness", 0.0},
                                                  {"item_width", 2.4},
                                                  {"item_height", 4.9},
                                                  {"item_mass", 115e3},
                                                  {"friction", friction}});
    engine::State state = engine::initial_state(engine::compile(building.scene), building.scene);
    TrialOptions options;
    options.hold_time = 1.0;
    return hold(tilted(building.scene, multiplier), state, options).result == TrialResult::falls;
  };
  EXPECT_FALSE(falls(0.5, 0.3));
  EXPECT_FALSE(falls(0.8, 0.97 * 2.4 / 4.9));
  EXPECT_TRUE(falls(0.8, 1.03 * 2.4 / 4.9));
  EXPECT_FALSE(falls(0.3, 0.29));
  EXPECT_TRUE(falls(0.3, 0.31));
}

TEST(Equipment, RefusesWhatDoesNotFit) {
  EXPECT_THAT(refusal(room, {{"item", 2.0}, {"pedestal_width", 0.5}}), HasSubstr("pedestal_width"));
  EXPECT_THAT(refusal(room, {{"item", 1.0}, {"rack_member", 0.3}}), HasSubstr("rack_member"));
  EXPECT_THAT(
      refusal(room, {{"item", 1.0}, {"item_width", 0.2}, {"rack_member", 0.01}, {"boxes_per_shelf", 19}}),
      HasSubstr("boxes_per_shelf"));
  EXPECT_THAT(refusal(room, {{"floor_width", 0.3}}), HasSubstr("floor_width"));
}

}  // namespace
}  // namespace dougong::structures
