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

// A face of 0.4 m over an edge of 1 m, from before its start to beyond its end.
TEST(ContactLength, IsWhatBothFacesHaveInCommon) {
  const BearingLength forward{0.4, 1.0, 0.0, 1.0}, backward{-0.4, 1.0, 0.0, 1.0};
  const std::pair<double, double> at[] = {{-0.5, -0.1}, {-0.3, 0.1}, {0.3, 0.4}, {0.8, 0.2}, {1.1, -0.1}};
  for (const auto& [position, length] : at) {
    EXPECT_NEAR(contact_length(forward, position), length, 1e-15) << position;
    EXPECT_NEAR(contact_length(backward, 1.0 - position), length, 1e-15) << position;
  }
}

TEST(BearingShare, HasTheSlopeOfItsFactor) {
  constexpr double step = 1e-6;
  for (const double facing : {-0.8, 0.8}) {
    const BearingLength b{facing, 1.0, 0.5, 0.7};
    for (const double position : {-0.9, -0.78, -0.6, -0.1, 0.1, 0.52, 0.98, 1.2, 1.4, 1.78, 1.9}) {
      const double slope =
          (bearing_share(b, position + step).factor - bearing_share(b, position - step).factor) /
          (2.0 * step);
      EXPECT_NEAR(bearing_share(b, position).slope, slope, 1e-8) << facing << " " << position;
    }
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
