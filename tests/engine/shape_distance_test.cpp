#include "engine/shape_distance.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dougong::engine {
namespace {

TEST(DistanceOutside, IsToTheNearestPointAndZeroInside) {
  EXPECT_NEAR(distance_outside(make_circle(2.0), {3.0, 4.0}), 3.0, 1e-15);
  EXPECT_EQ(distance_outside(make_circle(2.0), {1.0, 1.0}), 0.0);
  EXPECT_EQ(distance_outside(HalfPlane{}, {7.0, 0.5}), 0.5);
  EXPECT_EQ(distance_outside(HalfPlane{}, {7.0, -0.5}), 0.0);
}

TEST(DistanceOutside, OfAPolygonIsToItsEdgesAndCorners) {
  const Shape box = make_rectangle(2.0, 1.0);
  EXPECT_NEAR(distance_outside(box, {0.3, 0.7}), 0.2, 1e-15);
  EXPECT_NEAR(distance_outside(box, {1.3, 0.9}), 0.5, 1e-15);
  EXPECT_EQ(distance_outside(box, {0.9, -0.4}), 0.0);
  EXPECT_EQ(distance_outside(box, {1.0, 0.5}), 0.0);
}

TEST(DistanceOutside, OfACompoundIsToItsNearestPart) {
  const Shape pair =
      Compound{{{make_circle(0.5), {-2.0, 0.0}}, {make_rectangle(2.0, 1.0), {2.0, 0.0}, 1.5707963267948966}}};
  EXPECT_NEAR(distance_outside(pair, {-2.0, 1.0}), 0.5, 1e-15);
  EXPECT_NEAR(distance_outside(pair, {2.0, 1.25}), 0.25, 1e-12);
  EXPECT_NEAR(distance_outside(pair, {1.0, 0.0}), 0.5, 1e-12);
}

}  // namespace
}  // namespace dougong::engine
