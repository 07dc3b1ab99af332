#include "structures/layouts/pattern_wall.h"

#include <gmock/gmock.h>

#include "tests/scenes/ferris_walls.h"
#include "tests/structures/layouts/built.h"

namespace dougong::structures {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

Building wall_of(const std::string& pattern, double repeats = 1) {
  return build_layout("pattern-wall", {{"pattern", pattern}, {"repeats", repeats}, {"levels", 1}});
}

std::string refused(const std::string& pattern) {
  return refusal("pattern-wall", {{"pattern", pattern}, {"repeats", 1}, {"levels", 1}});
}

// Comparison C01: as many blocks as Ferris and Tin-Loi's, as wide.
TEST(PatternWall, HasTheBlocksOfThePublishedWalls) {
  const struct {
    int number;
    std::size_t blocks;
    double width;  // m
  } walls[] = {{1, 33, 2.0}, {2, 55, 2.0}, {3, 46, 1.6}, {5, 61, 1.2}};
  for (const auto& wall : walls) {
    const engine::Scene scene = scenes::ferris_wall(wall.number, 1e9);
    EXPECT_EQ(scene.bodies.size(), wall.blocks) << wall.number;
    Bounds all;
    Building building;
    building.scene = scene;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const Bounds block = bounds_of(building, i);
      all.low.x = std::min(all.low.x, block.low.x), all.high.x = std::max(all.high.x, block.high.x);
    }
    EXPECT_NEAR(all.high.x - all.low.x, wall.width, 1e-12) << wall.number;
  }
}

// Letters on a pitch of 0.42 m, halves on 0.21 m.
TEST(PatternWall, PlacesLettersOnAGridOfHalfBlocks) {
  const Building wall = build_layout("pattern-wall", {{"pattern", " 11h , 1_h"},
                                                      {"repeats", 1},
                                                      {"levels", 2},
                                                      {"head_joint", 0.02},
                                                      {"block_length", 0.4},
                                                      {"block_height", 0.2}});
  ASSERT_EQ(wall.scene.bodies.size(), 5u);
  const Bounds whole = bounds_of(wall, index_of(wall, "C02.B01"));
  const Bounds half = bounds_of(wall, index_of(wall, "C02.B02"));
  EXPECT_NEAR(whole.high.x - whole.low.x, 0.4, 1e-12);
  EXPECT_NEAR(half.low.x, (4 - 2.5) * 0.21 + 0.01, 1e-12);
  EXPECT_NEAR(half.high.x - half.low.x, 0.19, 1e-12);
  EXPECT_NEAR(half.low.y, 0.2, 1e-12);
}

TEST(PatternWall, LaysItsPatternAsOftenAsAsked) {
  EXPECT_EQ(wall_of("h1h, 11", 4).scene.bodies.size(), 20u);
  EXPECT_EQ(wall_of("h1h, 11", 4).storeys.front().height, 8 * 0.175);
}

TEST(PatternWall, SaysWhereItsPatternIsWrong) {
  EXPECT_THAT(refused("11, 1x1"), AllOf(HasSubstr("expected 1 (a block), h (half a block) or _ (an opening)"),
                                        HasSubstr("place 2 of course 2, \"1x1\"")));
  EXPECT_THAT(refused("11, h1"), AllOf(HasSubstr("expected courses as long as the first, 2 blocks"),
                                       HasSubstr("found 1.5 blocks in course 2")));
  EXPECT_THAT(refused("11,, 11"), HasSubstr("expected a block in every course, found \"\" as course 2"));
  EXPECT_THAT(refused("1_1, 111"), HasSubstr("found an opening below the block from 1 to 2 of course 2"));
  EXPECT_THAT(refusal("pattern-wall", {{"pattern", 11}}), HasSubstr("expected a value that is text"));
  EXPECT_THAT(refusal("pattern-wall", {{"pattern", "1_1, 111"}, {"repeats", 400}}), HasSubstr("an opening"));
  EXPECT_THAT(refusal("pattern-wall", {{"levels", 7}}), HasSubstr("at most the number of courses, 6"));
  EXPECT_THAT(refusal("brick-wall", {{"joints", "mortar"}}), HasSubstr("found \"mortar\""));
}

TEST(PatternWall, InMortarTiesEveryBlockToItsNeighbours) {
  const Building wall =
      build_layout("pattern-wall", {{"repeats", 1}, {"joints", word("pattern-wall", "joints", "mortar")}});
  // Six blocks and five: 5 + 4 head joints, 6 on the ground, and 10 bed joints between the courses.
  EXPECT_EQ(wall.scene.bonds.size(), 25u);
  Built built(wall);
  expect_settles(built, 1e-4);
}

}  // namespace
}  // namespace dougong::structures
