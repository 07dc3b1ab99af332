#include "engine/sine_cosine.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace dougong::engine {
namespace {

double worst_error(double low, double high, int samples) {
  double worst = 0.0;
  for (int i = 0; i <= samples; ++i) {
    const double angle = low + (high - low) * i / samples;
    const auto [s, c] = sine_cosine(angle);
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
      const auto [s, c] = sine_cosine(angle);
      EXPECT_NEAR(s, std::sin(angle), 1e-15) << angle;
      EXPECT_NEAR(c, std::cos(angle), 1e-15) << angle;
      EXPECT_NEAR(s * s + c * c, 1.0, 1e-15) << angle;
    }
}

TEST(SineCosine, IsOddAndEvenToTheBit) {
  for (double angle = 0.0; angle < 20.0; angle += 0.0137) {
    const auto [s, c] = sine_cosine(angle);
    const auto [minus_s, minus_c] = sine_cosine(-angle);
    EXPECT_EQ(minus_s, -s) << angle;
    EXPECT_EQ(minus_c, c) << angle;
  }
}

}  // namespace
}  // namespace dougong::engine
