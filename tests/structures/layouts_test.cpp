#include "structures/layouts/layout.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "structures/model_check.h"

namespace dougong::structures {
namespace {

using ::testing::HasSubstr;

struct Box {
  double left, right, bottom, top;
};

Box box_of(const engine::Body& body) {
  Box box{1e300, -1e300, 1e300, -1e300};
  for (const engine::Vec2 v : std::get<engine::ConvexPolygon>(body.shape).vertices()) {
    box.left = std::min(box.left, body.position.x + v.x);
    box.right = std::max(box.right, body.position.x + v.x);
    box.bottom = std::min(box.bottom, body.position.y + v.y);
    box.top = std::max(box.top, body.position.y + v.y);
  }
  return box;
}

const engine::Body& block(const Building& building, const std::string& name) {
  const auto it = std::ranges::find(building.scene.bodies, name, &engine::Body::name);
  if (it == building.scene.bodies.end()) throw std::out_of_range("no block " + name);
  return *it;
}

std::vector<const engine::Body*> course(const Building& building, const std::string& prefix) {
  std::vector<const engine::Body*> bricks;
  for (const engine::Body& body : building.scene.bodies)
    if (body.name.starts_with(prefix)) bricks.push_back(&body);
  return bricks;
}

class EveryLayout : public ::testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Table, EveryLayout, ::testing::ValuesIn([] {
                           std::vector<std::string> names;
                           for (const Layout& layout : layouts()) names.push_back(layout.name);
                           return names;
                         }()),
                         [](const auto& info) {
                           std::string name = info.param;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST_P(EveryLayout, PassesTheModelCheckWithoutAFinding) {
  for (const Finding& finding : check_model(build_layout(GetParam()))) ADD_FAILURE() << finding.message;
}

TEST_P(EveryLayout, StandsOnAGroundWhoseTopIsAtZero) {
  const Building building = build_layout(GetParam());
  ASSERT_GE(building.scene.terrains.size(), 1u);
  const engine::Terrain& ground = building.scene.terrains.front();
  EXPECT_EQ(ground.name, "ground");
  engine::Body as_body;
  as_body.shape = ground.shape;
  as_body.position = ground.position;
  EXPECT_EQ(box_of(as_body).top, 0.0);
}

TEST_P(EveryLayout, PutsEveryBlockInExactlyOneStorey) {
  const Building building = build_layout(GetParam());
  std::vector<int> times(building.scene.bodies.size(), 0);
  for (const Storey& storey : building.storeys)
    for (const std::size_t i : storey.storey_blocks) ++times.at(i);
  EXPECT_THAT(times, ::testing::Each(1));
}

TEST_P(EveryLayout, StacksItsStoreysWithoutGap) {
  const Building building = build_layout(GetParam());
  double level = 0.0, top = 0.0;
  for (std::size_t i = 0; i < building.storeys.size(); ++i) {
    const Storey& storey = building.storeys[i];
    EXPECT_EQ(storey.name, "S" + std::to_string(i + 1));
    EXPECT_NEAR(storey.base, level, 1e-12);
    EXPECT_FALSE(storey.level_blocks.empty());
    for (const std::size_t j : storey.level_blocks)
      EXPECT_THAT(storey.storey_blocks, ::testing::Contains(j)) << "level blocks are storey blocks too";
    level = storey.base + storey.height;
  }
  for (const engine::Body& body : building.scene.bodies) top = std::max(top, box_of(body).top);
  EXPECT_NEAR(level, top, 1e-9);
}

TEST_P(EveryLayout, NamesEveryBlockOnce) {
  std::set<std::string> names;
  const Building building = build_layout(GetParam());
  for (const engine::Body& body : building.scene.bodies)
    EXPECT_TRUE(names.insert(body.name).second) << body.name << " twice";
}

TEST_P(EveryLayout, PrintsItsParametersWithUnits) {
  const Building building = build_layout(GetParam());
  EXPECT_EQ(building.layout, GetParam());
  EXPECT_EQ(building.parameters.size(), find_layout(GetParam()).parameters.size());
  const double thickness = find_layout(GetParam()).parameter("thickness")->standard;
  EXPECT_EQ(building.parameters.at("thickness"), print_value(thickness, Dimension::length));
  EXPECT_EQ(building.parameters.at("isolation"), "none");
  EXPECT_THAT(building.parameters.at("young_modulus"), HasSubstr(" GPa"));
}

TEST_P(EveryLayout, HasDefaultsWithinItsRanges) {
  for (const Parameter& p : find_layout(GetParam()).parameters) {
    EXPECT_LE(p.least, p.standard) << p.name;
    EXPECT_LE(p.standard, p.most) << p.name;
    EXPECT_FALSE(p.meaning.empty()) << p.name;
  }
}

TEST_P(EveryLayout, PassesItsMaterialOn) {
  const Building building = build_layout(GetParam(), {{"young_modulus", 7e9},
                                                      {"density", 1234.0},
                                                      {"friction", 0.33},
                                                      {"damping_ratio", 0.2},
                                                      {"thickness", 0.4}});
  for (const engine::Body& body : building.scene.bodies) {
    if (body.material > 0) continue;  // parts with a material of their own
    const engine::Material& material = building.scene.materials.at(body.material);
    EXPECT_EQ(material.young_modulus, 7e9);
    EXPECT_EQ(material.density, 1234.0);
    EXPECT_EQ(material.friction_coefficient, 0.33);
    EXPECT_EQ(material.damping_ratio, 0.2);
    EXPECT_EQ(body.thickness, 0.4);
  }
}

TEST_P(EveryLayout, TakesAMaterialByItsName) {
  const Parameter& material = *find_layout(GetParam()).parameter("material");
  const Building building = build_layout(GetParam(), {{"material", value_of_word(material, "timber")}});
  EXPECT_EQ(building.scene.materials.front().name, "timber");
  EXPECT_EQ(building.scene.materials.front().density, 420.0);
  EXPECT_EQ(building.parameters.at("young_modulus"), "11 GPa");
  const Building heavy =
      build_layout(GetParam(), {{"material", value_of_word(material, "timber")}, {"density", 700.0}});
  EXPECT_EQ(heavy.scene.materials.front().density, 700.0) << "a value goes before the preset";
}

TEST(FourStorey, HasTheOriginalDimensions) {
  const Building building = build_layout("four-storey");
  ASSERT_EQ(building.scene.bodies.size(), 12u);
  ASSERT_EQ(building.storeys.size(), 4u);
  const Box left = box_of(block(building, "S1.column.left")), slab = box_of(block(building, "S1.slab"));
  EXPECT_NEAR(left.left, -5.15, 1e-12);
  EXPECT_NEAR(left.right, -4.85, 1e-12);
  EXPECT_NEAR(left.bottom, 0.0, 1e-12);
  EXPECT_NEAR(left.top, 2.6, 1e-12);
  EXPECT_NEAR(slab.right - slab.left, 10.7, 1e-12);
  EXPECT_NEAR(slab.top, 2.8, 1e-12);
  EXPECT_NEAR(box_of(block(building, "S4.slab")).top, 4 * 2.8, 1e-12);
  EXPECT_NEAR(box_of(block(building, "S3.column.right")).right, 5.15, 1e-12);
}

TEST(FourStorey, TakesTheSlabAsTheLevel) {
  const Building building = build_layout("four-storey");
  for (const Storey& storey : building.storeys) {
    ASSERT_EQ(storey.level_blocks.size(), 1u);
    EXPECT_EQ(building.scene.bodies[storey.level_blocks[0]].name, storey.name + ".slab");
    EXPECT_EQ(storey.storey_blocks.size(), 3u);
    EXPECT_NEAR(storey.height, 2.8, 1e-12);
  }
}

TEST(FourStoreyStrong, IsFourStoreyWithWiderLeftColumns) {
  const Building strong = build_layout("four-storey-strong");
  const Building same = build_layout("four-storey", {{"left_column_width", 0.6}});
  ASSERT_EQ(strong.scene.bodies.size(), same.scene.bodies.size());
  for (std::size_t i = 0; i < strong.scene.bodies.size(); ++i) {
    const Box a = box_of(strong.scene.bodies[i]), b = box_of(same.scene.bodies[i]);
    EXPECT_EQ(a.left, b.left);
    EXPECT_EQ(a.right, b.right);
    EXPECT_EQ(a.top, b.top);
  }
  const Box left = box_of(block(strong, "S2.column.left"));
  EXPECT_NEAR(left.right - left.left, 0.6, 1e-12);
}

TEST(TenStorey, HasTenStoreys) {
  EXPECT_EQ(build_layout("ten-storey").storeys.size(), 10u);
}

TEST(RunningBond, StaggersEveryOtherCourse) {
  const Building wall = build_layout("brick-wall");
  for (int number = 1; number < 8; ++number) {
    const auto below = course(wall, "C0" + std::to_string(number) + ".");
    const auto above = course(wall, "C0" + std::to_string(number + 1) + ".");
    // No head joint stands on another: every joint lies a quarter brick or more from those below.
    for (std::size_t i = 0; i + 1 < above.size(); ++i)
      for (std::size_t j = 0; j + 1 < below.size(); ++j)
        EXPECT_GT(std::abs(box_of(*above[i]).right - box_of(*below[j]).right), 0.125)
            << "course " << number + 1;
  }
}

TEST(RunningBond, ClosesEveryCourseFlushAtBothEnds) {
  const Building wall = build_layout("brick-wall");
  const auto first = course(wall, "C01."), second = course(wall, "C02.");
  EXPECT_EQ(first.size(), 12u);
  EXPECT_EQ(second.size(), 13u);
  EXPECT_NEAR(box_of(*first.front()).left, box_of(*second.front()).left, 1e-12);
  EXPECT_NEAR(box_of(*first.back()).right, box_of(*second.back()).right, 1e-12);
  EXPECT_NEAR(box_of(*second.front()).right - box_of(*second.front()).left, 0.2495, 1e-12);
}

TEST(RunningBond, LeavesTheHeadJointsOpenByTheGapAsked) {
  for (const double joint : {0.0, 0.001, 0.01}) {
    const Building wall = build_layout("brick-wall", {{"head_joint", joint}});
    for (const char* prefix : {"C01.", "C02."}) {
      const auto bricks = course(wall, prefix);
      for (std::size_t i = 0; i + 1 < bricks.size(); ++i)
        EXPECT_NEAR(box_of(*bricks[i + 1]).left - box_of(*bricks[i]).right, joint, 1e-12);
    }
  }
}

TEST(BrickWall, HasAboutAHundredBricks) {
  EXPECT_EQ(build_layout("brick-wall").scene.bodies.size(), 100u);
}

TEST(BrickWall, DealsItsCoursesOutToTheLevels) {
  const Building wall = build_layout("brick-wall", {{"courses", 7}, {"levels", 3}});
  ASSERT_EQ(wall.storeys.size(), 3u);
  EXPECT_NEAR(wall.storeys[0].height, 2 * 0.25, 1e-12);
  EXPECT_NEAR(wall.storeys[1].height, 2 * 0.25, 1e-12);
  EXPECT_NEAR(wall.storeys[2].height, 3 * 0.25, 1e-12);
  for (const std::size_t i : wall.storeys[0].level_blocks)
    EXPECT_TRUE(wall.scene.bodies[i].name.starts_with("C02.")) << wall.scene.bodies[i].name;
}

TEST(BrickWall, CountsItsBricksPerLevelOnce) {
  const Building wall = build_layout("brick-wall", {{"courses", 3}, {"levels", 3}, {"bricks_per_course", 1}});
  ASSERT_EQ(wall.scene.bodies.size(), 1u + 2u + 1u);
  EXPECT_EQ(wall.storeys[1].level_blocks.size(), 2u);
}

TEST(Column, MakesEveryDrumAStorey) {
  const Building building = build_layout("column", {{"drums", 5}, {"drum_height", 0.8}});
  ASSERT_EQ(building.storeys.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(building.storeys[i].level_blocks, std::vector<std::size_t>{i});
    EXPECT_NEAR(box_of(building.scene.bodies[i]).bottom, 0.8 * static_cast<double>(i), 1e-12);
    EXPECT_NEAR(box_of(building.scene.bodies[i]).top, 0.8 * static_cast<double>(i + 1), 1e-12);
  }
}

TEST(Column, TapersToTheWidthAsked) {
  const Building building =
      build_layout("column", {{"width", 2.0}, {"taper_ratio", 0.25}, {"ground_width", 4.0}});
  const auto& last = std::get<engine::ConvexPolygon>(building.scene.bodies.back().shape);
  double top = 0.0, head = 0.0;
  for (const engine::Vec2 v : last.vertices()) top = std::max(top, v.y);
  for (const engine::Vec2 v : last.vertices())
    if (v.y > top - 1e-9) head = std::max(head, v.x);
  EXPECT_NEAR(2.0 * head, 1.5, 1e-12);
}

// Straight-sided voussoirs: each is the triangle from the centre to its outer joints less the inner one, so
// that together they have N/2 sin(e/N) (R2^2 - R1^2) of area.
TEST(Arch, FillsItsPolygonWithVoussoirs) {
  for (const auto& [voussoirs, embrace] : {std::pair{7.0, 2.0}, std::pair{24.0, M_PI}}) {
    const Building building = build_layout(
        "arch",
        {{"voussoirs", voussoirs}, {"embrace_angle", embrace}, {"radius", 2.0}, {"ring_thickness", 0.4}});
    double area = 0.0;
    for (const engine::Body& body : building.scene.bodies) area += engine::area_properties(body.shape).area;
    EXPECT_NEAR(area, 0.5 * voussoirs * std::sin(embrace / voussoirs) * (2.2 * 2.2 - 1.8 * 1.8), 1e-12);
  }
}

TEST(Arch, StandsOnAbutmentsThatCarryItsSpringings) {
  const Building building = build_layout(
      "arch", {{"embrace_angle", 2.0}, {"abutment_height", 0.7}, {"radius", 2.0}, {"ring_thickness", 0.4}});
  ASSERT_EQ(building.scene.terrains.size(), 3u);
  engine::Body left;
  left.shape = building.scene.terrains[1].shape;
  left.position = building.scene.terrains[1].position;
  const Box abutment = box_of(left), voussoir = box_of(building.scene.bodies.front());
  EXPECT_NEAR(abutment.bottom, 0.0, 1e-12);
  EXPECT_NEAR(voussoir.bottom, 0.7, 1e-12) << "the end of the intrados";
  EXPECT_NEAR(abutment.top, 0.7 + 0.4 * std::cos(1.0), 1e-12) << "the end of the extrados";
  EXPECT_NEAR(abutment.left, -2.2 * std::sin(1.0), 1e-12);
  EXPECT_NEAR(abutment.right, -1.8 * std::sin(1.0), 1e-12);
}

TEST(Arch, TakesTheCrownAsTheLevel) {
  EXPECT_EQ(build_layout("arch", {{"voussoirs", 15}}).storeys[0].level_blocks, std::vector<std::size_t>{7});
  EXPECT_EQ(build_layout("arch", {{"voussoirs", 24}}).storeys[0].level_blocks,
            (std::vector<std::size_t>{11, 12}));
}

TEST(Arch, RefusesInclinedSpringingsWithoutAbutments) {
  EXPECT_THROW(build_layout("arch", {{"embrace_angle", 2.0}, {"abutment_height", 0.0}}), LayoutError);
  EXPECT_THROW(build_layout("arch", {{"radius", 1.0}, {"ring_thickness", 1.1}}), LayoutError);
  EXPECT_THROW(build_layout("arch", {{"radius", 6.0}}), LayoutError) << "wider than its ground";
}

TEST(BuildLayout, NamesTheNearestLayout) {
  try {
    build_layout("four-story");
    FAIL() << "accepted";
  } catch (const LayoutError& error) {
    EXPECT_EQ(error.nearest, "four-storey");
    EXPECT_EQ(error.found, "\"four-story\"");
    EXPECT_THAT(error.expected, HasSubstr("brick-wall"));
    EXPECT_THAT(error.what(), HasSubstr("did you mean \"four-storey\""));
  }
}

TEST(BuildLayout, NamesTheNearestParameter) {
  try {
    build_layout("four-storey", {{"storey", 3}});
    FAIL() << "accepted";
  } catch (const LayoutError& error) {
    EXPECT_EQ(error.nearest, "storeys");
    EXPECT_THAT(error.what(), HasSubstr("layout four-storey"));
  }
}

TEST(BuildLayout, RefusesValuesOutOfRangeWithTheRange) {
  try {
    build_layout("four-storey", {{"column_height", -2.6}});
    FAIL() << "accepted";
  } catch (const LayoutError& error) {
    EXPECT_EQ(error.subject, "column_height");
    EXPECT_EQ(error.expected, "a value from 50 mm to 50 m");
    EXPECT_EQ(error.found, "-2.6 m");
  }
}

TEST(BuildLayout, RefusesPartsOfCountsAndNonsense) {
  EXPECT_THROW(build_layout("four-storey", {{"storeys", 2.5}}), LayoutError);
  EXPECT_THROW(build_layout("four-storey", {{"storeys", 0}}), LayoutError);
  EXPECT_THROW(build_layout("column", {{"width", std::numeric_limits<double>::quiet_NaN()}}), LayoutError);
  EXPECT_THROW(build_layout("column", {{"width", std::numeric_limits<double>::infinity()}}), LayoutError);
}

TEST(BuildLayout, RefusesValuesThatDoNotFitEachOther) {
  EXPECT_THROW(build_layout("four-storey", {{"slab_length", 9.0}}), LayoutError);
  EXPECT_THROW(build_layout("four-storey", {{"column_spacing", 0.3}}), LayoutError);
  EXPECT_THROW(build_layout("four-storey", {{"ground_width", 10.0}}), LayoutError);
  EXPECT_THROW(build_layout("brick-wall", {{"courses", 3}}), LayoutError);  // has four levels
  EXPECT_THROW(build_layout("brick-wall", {{"brick_length", 0.1}, {"head_joint", 0.06}}), LayoutError);
  EXPECT_THROW(build_layout("brick-wall", {{"bricks_per_course", 40}}),
               LayoutError);  // wider than its ground
  EXPECT_THROW(build_layout("column", {{"width", 11.0}}), LayoutError);
}

}  // namespace
}  // namespace dougong::structures
