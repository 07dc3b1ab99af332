#include "engine/frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace dougong::engine {
namespace {

double worst_error(double low, double high, int samples) {
  double worst = 0.0;
  for (int i = 0; i <= samples; ++i) {
    const double angle = low + (high - low) * i / samples;
    double s = 0.0, c = 0.0;
    sine_cosine(angle, s, c);
    worst = std::max({worst, std::abs(s - std::sin(angle)), std::abs(c - std::cos(angle))});
  }
  return worst;
}

TEST(SineCosine, IsTheLibrarysToTheLastBits) {
  EXPECT_LT(worst_error(-1e-8, 1e-8, 1000), 1e-16);
  EXPECT_LT(worst_error(-10.0, 10.0, 100003), 1e-15);
  EXPECT_LT(worst_error(-1e5, 1e5, 300007), 1e-15);
}

TEST(SineCosine, HoldsAtTheQuadrants) {
  for (int k = -40; k <= 40; ++k)
    for (const double away : {-1e-9, 0.0, 1e-9}) {
      const double angle = 0.25 * std::numbers::pi * k + away;
      double s = 0.0, c = 0.0;
      sine_cosine(angle, s, c);
      EXPECT_NEAR(s, std::sin(angle), 1e-15) << angle;
      EXPECT_NEAR(c, std::cos(angle), 1e-15) << angle;
      EXPECT_NEAR(s * s + c * c, 1.0, 1e-15) << angle;
    }
}

TEST(SineCosine, IsOddAndEvenToTheBit) {
  for (double angle = 0.0; angle < 20.0; angle += 0.0137) {
    double s = 0.0, c = 0.0, minus_s = 0.0, minus_c = 0.0;
    sine_cosine(angle, s, c);
    sine_cosine(-angle, minus_s, minus_c);
    EXPECT_EQ(minus_s, -s) << angle;
    EXPECT_EQ(minus_c, c) << angle;
  }
}

TEST(Frame, GoesToTheWorldAndBack) {
  Frame f;
  f.x = 3.0, f.y = -2.0;
  sine_cosine(0.7, f.s, f.c);
  const Vec2 p{0.3, 1.1}, turned_p = rotated(p, 0.7);
  EXPECT_NEAR(norm(f.to_world(p) - (Vec2{3.0, -2.0} + turned_p)), 0.0, 1e-15);
  EXPECT_NEAR(norm(f.to_local(f.to_world(p)) - p), 0.0, 1e-15);
}

}  // namespace
}  // namespace dougong::engine
