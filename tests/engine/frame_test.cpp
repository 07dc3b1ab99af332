#include "engine/frame.h"

#include <gtest/gtest.h>

namespace dougong::engine {
namespace {

TEST(Frame, GoesToTheWorldAndBack) {
  Frame f;
  f.x = 3.0, f.y = -2.0;
  f.turn_to(0.7);
  EXPECT_EQ(f.angle, 0.7);
  const Vec2 p{0.3, 1.1}, turned_p = rotated(p, 0.7);
  EXPECT_NEAR(norm(f.to_world(p) - (Vec2{3.0, -2.0} + turned_p)), 0.0, 1e-15);
  EXPECT_NEAR(norm(f.to_local(f.to_world(p)) - p), 0.0, 1e-15);
}

}  // namespace
}  // namespace dougong::engine
