#include "app/study/spread.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace dougong::app {
namespace {

TEST(Spread, TakesQuantilesBetweenTheSortedValues) {
  const Spread s = spread_of({4.0, 1.0, 3.0, 2.0, 5.0});
  EXPECT_EQ(s.count, 5u);
  EXPECT_DOUBLE_EQ(s.least, 1.0);
  EXPECT_DOUBLE_EQ(s.low, 1.0 + 0.16 * 4.0);
  EXPECT_DOUBLE_EQ(s.median, 3.0);
  EXPECT_DOUBLE_EQ(s.high, 1.0 + 0.84 * 4.0);
  EXPECT_DOUBLE_EQ(s.most, 5.0);
}

TEST(Spread, LeavesOutWhatIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(spread_of({nan, 2.0, nan}).count, 1u);
  EXPECT_DOUBLE_EQ(spread_of({nan, 2.0, nan}).low, 2.0);
  EXPECT_TRUE(std::isnan(spread_of({}).median));
}

// Intervals as tabulated by Brown, Cai and DasGupta's formulas of Wilson's score.
TEST(Share, HasWilsonsInterval) {
  EXPECT_NEAR(share_of(0, 10).high, 0.27753, 1e-5);
  EXPECT_EQ(share_of(0, 10).low, 0.0);
  EXPECT_NEAR(share_of(3, 16).low, 0.065916, 1e-5);
  EXPECT_NEAR(share_of(3, 16).high, 0.430084, 1e-4);
  EXPECT_NEAR(share_of(10, 10).low, 1.0 - 0.27753, 1e-5);
}

TEST(Share, OfNoTrialsMayBeAnything) {
  EXPECT_EQ(share_of(0, 0).low, 0.0);
  EXPECT_EQ(share_of(0, 0).high, 1.0);
}

}  // namespace
}  // namespace dougong::app
