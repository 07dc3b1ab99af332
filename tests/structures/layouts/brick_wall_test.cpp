#include <cmath>
#include <numbers>

#include "tests/engine/reference.h"
#include "tests/structures/layouts/built.h"

namespace dougong::structures {
namespace {

using ::testing::HasSubstr;

const std::string wall = "brick-wall";

ParameterMap in_mortar(ParameterMap values) {
  values["joints"] = word(wall, "joints", "mortar");
  return values;
}

ParameterMap with_bond(const std::string& pattern, ParameterMap values = {}) {
  values["bond_pattern"] = word(wall, "bond_pattern", pattern);
  return values;
}

/// Validation case B01: L 10 m, depth 1 m, as a stack of N bricks without any mortar between them.
Built cantilever(double blocks) {
  return weightless(build_layout(wall, in_mortar(with_bond("stack", {{"courses", blocks},
                                                                     {"levels", 1},
                                                                     {"bricks_per_course", 1},
                                                                     {"brick_length", 1.0},
                                                                     {"brick_height", 10.0 / blocks},
                                                                     {"mortar_thickness", 0.0},
                                                                     {"young_modulus", 25e9},
                                                                     {"density", 2400.0}}))));
}

// The table of case B01: rigid blocks with distributed face springs, E/l and kappa G/l.
TEST(BrickWallInMortar, VibratesAsACantileverOfBondedBlocks) {
  const double table[][4] = {{5, 5.082914, 29.39675, 75.67149},
                             {10, 5.151685, 30.64264, 80.25189},
                             {20, 5.169174, 30.97813, 81.57232},
                             {40, 5.173565, 31.06352, 81.9142}};
  for (const auto& row : table) {
    auto modes = cantilever(row[0]).modes();
    std::erase_if(modes, [](const engine::Mode& mode) { return mode.participation < 1e-6; });  // upright
    for (std::size_t i = 0; i < 3; ++i)
      dougong::testing::expect_relative(
          "B01", "layout, N " + dougong::testing::text(row[0]) + " f" + std::to_string(i + 1), row[i + 1],
          std::sqrt(modes.at(i).angular_frequency_squared) / (2.0 * std::numbers::pi), 1e-4);
  }
}

TEST(BrickWallInMortar, BendsUnderATipLoadAsTheTableSays) {
  for (const auto& [blocks, tip] : {std::pair{20.0, 0.01613232}, {40.0, 0.01611876}}) {
    // The table's load is at the tip, half a block above the last centre: the slope there takes it on.
    const Built built = cantilever(blocks);
    const double half = 5.0 / blocks;
    const std::size_t last = built.model.body_count - 1;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> k(
        engine::tangent_stiffness(built.model, built.state));
    Eigen::VectorXd load = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(built.model.body_count));
    const auto x = static_cast<Eigen::Index>(last), turn = static_cast<Eigen::Index>(3 * (last + 1) - 1);
    load[x] = 1e5, load[turn] = -1e5 * half;
    const Eigen::VectorXd u = k.solve(load);
    dougong::testing::expect_relative("B01", "layout, N " + dougong::testing::text(blocks) + " tip", tip,
                                      u[x] - half * u[turn], 1e-4);
  }
}

// Brick and mortar in series: the wall shortens under its weight as a bar with that modulus.
TEST(BrickWallInMortar, IsAsStiffAsBrickAndMortarInSeries) {
  Built built(wall, in_mortar(with_bond("stack", {{"young_modulus", 4e9},
                                                  {"mortar_modulus", 0.4e9},
                                                  {"mortar_thickness", 0.02},
                                                  {"brick_height", 0.2},
                                                  {"courses", 20}})));
  expect_settles(built, 1e-3);
  const double modulus = 0.2 / (0.18 / 4e9 + 0.02 / 0.4e9), height = 4.0;
  const std::size_t top = built.model.body_count - 6;  // in the middle of the top course
  const double sunk = built.building.scene.bodies[top].position.y -
                      (built.model.origin.y + built.state.q()[built.model.body_count + top]);
  const double stress = 1800.0 * engine::standard_gravity * height;
  const double expected = stress * height / (2.0 * modulus);
  dougong::testing::expect_relative("layout", "shortening of a wall in mortar", expected, sunk, 1e-3);
}

TEST(BrickWallInMortar, BondsEveryJointOfEveryPattern) {
  for (const char* pattern : {"running", "stack", "English"}) {
    Built built(wall, in_mortar(with_bond(pattern, {{"courses", 6}, {"bricks_per_course", 5}})));
    expect_no_findings(built.building);
    expect_settles(built, 1e-3);
    // Every brick holds to a neighbour in its course and to the course below or the ground.
    std::vector<int> heads(built.model.body_count), beds(built.model.body_count);
    for (const engine::Bond& bond : built.building.scene.bonds) {
      const bool head = bond.start.x == bond.end.x || std::abs(bond.start.x - bond.end.x) < 1e-9;
      ++(head ? heads : beds).at(bond.b.index);
      if (!bond.a.terrain) ++(head ? heads : beds).at(bond.a.index);
    }
    EXPECT_THAT(heads, ::testing::Each(::testing::AllOf(::testing::Ge(1), ::testing::Le(2)))) << pattern;
    EXPECT_THAT(beds, ::testing::Each(::testing::Ge(1))) << pattern;
  }
}

TEST(EnglishBond, LaysHeadersOnStretchersSoThatNoJointStandsOnAnother) {
  const Building building =
      build_layout(wall, with_bond("English", {{"courses", 2}, {"levels", 1}, {"bricks_per_course", 4}}));
  // 4 stretchers; 2 x 4 - 1 headers and two quarter bricks.
  ASSERT_EQ(building.scene.bodies.size(), 4u + 7u + 2u);
  const auto ends = [&](const std::string& course) {
    std::vector<double> x;
    for (std::size_t i = 0; i < building.scene.bodies.size(); ++i)
      if (building.scene.bodies[i].name.starts_with(course)) x.push_back(bounds_of(building, i).high.x);
    x.pop_back();  // of the wall
    return x;
  };
  for (const double above : ends("C02"))
    for (const double below : ends("C01")) EXPECT_GT(std::abs(above - below), 0.1);
  EXPECT_NEAR(bounds_of(building, index_of(building, "C02.B01")).high.x -
                  bounds_of(building, index_of(building, "C02.B01")).low.x,
              0.25 - 0.0005, 1e-9);
}

const ParameterMap house_front{{"courses", 14},          {"levels", 2},       {"openings", 2},
                               {"opening_levels", 2},    {"sill_courses", 2}, {"opening_courses", 3},
                               {"opening_spacing", 2.7}, {"gable_courses", 6}};

TEST(BrickWallOpenings, AreEmptyAndUnderALintel) {
  for (const char* pattern : {"running", "stack", "English"}) {
    Built built(wall, with_bond(pattern, house_front));
    expect_no_findings(built.building);
    for (std::size_t i = 0; i < built.model.body_count; ++i) {
      const Bounds box = bounds_of(built.building, i);
      for (const double centre : {-1.35, 1.35})
        for (const double bottom : {0.5, 0.5 + 7 * 0.25})
          EXPECT_FALSE(box.low.x < centre + 0.499 && box.high.x > centre - 0.499 &&
                       box.low.y < bottom + 0.74 && box.high.y > bottom + 0.01)
              << built.building.scene.bodies[i].name << " " << pattern;
    }
    const Bounds lintel = bounds_of(built.building, index_of(built.building, "C06.lintel1"));
    EXPECT_NEAR(lintel.low.x, -1.35 - 0.75, 1e-12);
    EXPECT_NEAR(lintel.high.x, -1.35 + 0.75, 1e-12);
    EXPECT_NEAR(lintel.low.y, 5 * 0.25, 1e-12);
  }
}

TEST(BrickWallOpenings, StandDryAndInMortar) {
  ParameterMap dry = house_front;
  for (const ParameterMap& values : {dry, in_mortar(house_front)}) {
    Built built(wall, values);
    expect_settles(built, 2e-3);
  }
}

TEST(Gable, FillsItsTriangle) {
  const Building building = build_layout(
      wall,
      {{"courses", 4}, {"levels", 1}, {"gable_courses", 7}, {"head_joint", 0.0}, {"bricks_per_course", 6}});
  ASSERT_EQ(building.storeys.size(), 2u);
  double area = 0.0;
  for (const std::size_t i : building.storeys[1].storey_blocks)
    area += engine::area_properties(building.scene.bodies[i].shape).area;
  EXPECT_NEAR(area, 0.5 * 3.0 * 7 * 0.25, 1e-9);
  EXPECT_NEAR(building.storeys[1].height, 7 * 0.25, 1e-12);
}

TEST(BrickWall, RefusesWhatDoesNotFit) {
  EXPECT_THAT(refusal(wall, {{"openings", 1}, {"opening_courses", 2}}),
              HasSubstr("the 2 courses of level 1"));
  EXPECT_THAT(refusal(wall, {{"openings", 2}, {"levels", 1}, {"opening_spacing", 1.0}}),
              HasSubstr("opening_spacing: expected room for two bearings"));
  EXPECT_THAT(refusal(wall, {{"openings", 1}, {"levels", 1}, {"opening_width", 6.0}}),
              HasSubstr("within a wall of"));
  EXPECT_THAT(refusal(wall, {{"openings", 1}, {"levels", 1}, {"lintel_bearing", 0.05}}),
              HasSubstr("at least a quarter brick"));
  EXPECT_THAT(refusal(wall, with_bond("English", {{"bricks_per_course", 1}})), HasSubstr("at least 2"));
  EXPECT_THAT(refusal(wall, in_mortar({{"brick_height", 0.05}, {"mortar_thickness", 0.04}})),
              HasSubstr("mortar_thickness"));
  EXPECT_THAT(refusal(wall, {{"bond_pattern", 7.0}}), HasSubstr("one of running, stack, English"));
}

}  // namespace
}  // namespace dougong::structures
