#include "engine/contact/bearing_length.h"

#include <gtest/gtest.h>

#include "engine/settle.h"
#include "tests/scenes/running.h"

namespace dougong::engine {
namespace {

using scenes::Running;

TEST(BearingLength, IsTheLengthOrHalfAWidthReachedFromZero) {
  EXPECT_EQ(bearing_length(-0.1, 0.5), 0.0);
  EXPECT_EQ(bearing_length(0.0, 0.5), 0.0);
  EXPECT_DOUBLE_EQ(bearing_length(0.02, 0.5), 0.2);
  EXPECT_DOUBLE_EQ(bearing_length(0.2, 0.5), 0.5);
  EXPECT_DOUBLE_EQ(bearing_length(0.8, 0.5), 0.8);
  EXPECT_DOUBLE_EQ(bearing_length(0.02, 0.0), 0.02) << "at a seam";
}

TEST(BearingShare, HasTheSlopeOfItsFactor) {
  constexpr double step = 1e-6;
  for (const double direction : {-1.0, 1.0}) {
    const BearingLength b{direction, 0.3, 0.5, 0.7};
    for (const double length : {-0.1, 0.02, 0.2, 0.8}) {
      const double position = 0.3 + direction * length;
      const double slope =
          (bearing_share(b, position + step).factor - bearing_share(b, position - step).factor) /
          (2.0 * step);
      EXPECT_NEAR(bearing_share(b, position).slope, slope, 1e-8) << direction << " " << length;
    }
    EXPECT_NEAR(bearing_share(b, 0.3 + direction * 0.7).factor, 1.0, 1e-12);
  }
}

// Separate stones, flush: without friction a block passes from one to the next as if they were one, though it
// is pressed in by half a micrometre and meets the side of each.
TEST(SlidingBlock, PassesOverFlushNeighboursWithoutASnag) {
  for (const double width : {0.13, 0.3}) {
    Scene s = scenes::scene(0.0, 1e9);
    s.bodies.push_back(scenes::block(0.25, 0.1, {-0.5, 0.1}));
    for (int i = -10; i < 40; ++i) {
      Terrain stone;
      stone.name = "stone " + std::to_string(i);
      stone.shape = make_rectangle(width, 1.0);
      stone.position = {width * (i + 0.5), -0.5};
      s.terrains.push_back(stone);
    }
    Running r(s);
    ASSERT_TRUE(settle(r.model, r.state).settled);
    const double height = r.position().y;
    r.state.v()[0] = 2.0;
    r.run(scenes::run_for(1.5));
    EXPECT_NEAR(r.velocity().x, 2.0, 0.06) << width;
    EXPECT_NEAR(r.position().y, height, 1e-6) << width;
  }
}

}  // namespace
}  // namespace dougong::engine
