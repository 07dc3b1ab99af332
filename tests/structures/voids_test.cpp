#include "structures/voids.h"

#include <gmock/gmock.h>

#include <cmath>

namespace dougong::structures {
namespace {

using ::testing::IsEmpty;

Outline box(double left, double right, double low, double high) {
  return {{left, low}, {right, low}, {right, high}, {left, high}};
}

const Extent ten_metres{{-5.0, 0.0}, {5.0, 10.0}};

// A room of 4 m by 2.5 m: two walls and a floor on them.
TEST(Voids, OfARoomAreItsAreaAndItsHeight) {
  const auto found =
      voids({box(-2.2, -2.0, 0, 2.5), box(2.0, 2.2, 0, 2.5), box(-2.2, 2.2, 2.5, 2.7)}, ten_metres);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].area, 4.0 * 2.5, 0.05 * 2 * (4.0 + 2.5));
  EXPECT_NEAR(found[0].diameter, 2.5, 0.1);
  EXPECT_NEAR(found[0].middle.y, 1.25, 0.1);
}

// A slab that leans on a wall: the circle inscribed in a right triangle has the diameter a + b - c.
TEST(Voids, UnderALeaningSlabAreATriangle) {
  const double a = 3.0, b = 2.0;
  const Outline wall = box(-0.3, 0.0, 0.0, b);
  const Outline slab{{0.0, b}, {a, 0.0}, {a + 0.2, 0.0}, {0.0, b + 0.2}};
  const auto found = voids({wall, slab}, ten_metres);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].area, 0.5 * a * b, 0.05 * (a + b));
  EXPECT_NEAR(found[0].diameter, a + b - std::hypot(a, b), 0.1);
}

TEST(Voids, AreNotWhereNobodyFits) {
  const auto room = [](double height) {
    return std::vector<Outline>{box(-2.2, -2.0, 0, height), box(2.0, 2.2, 0, height),
                                box(-2.2, 2.2, height, height + 0.2)};
  };
  EXPECT_THAT(voids(room(0.4), ten_metres), IsEmpty());
  EXPECT_EQ(voids(room(0.65), ten_metres).size(), 1u);
}

TEST(Voids, AreNotUnderTheOpenSkyNorOutsideOfWhereOneLooks) {
  EXPECT_THAT(voids({box(-2.2, -2.0, 0, 2.5), box(2.0, 2.2, 0, 2.5)}, ten_metres), IsEmpty());
  EXPECT_THAT(voids({box(7.0, 9.0, 2.0, 2.2)}, ten_metres), IsEmpty());
  EXPECT_THAT(voids({}, {{0.0, 0.0}, {0.0, 0.0}}), IsEmpty());
}

TEST(Voids, ComeLargestFirst) {
  const auto found = voids({box(-4, 4, 3, 3.2), box(-1.1, -1, 0, 3), box(1, 1.1, 0, 3), box(3.9, 4, 0, 3),
                            box(-4, -3.9, 0, 1.5), box(-4, -1, 1.5, 1.7)},
                           ten_metres);
  ASSERT_GE(found.size(), 2u);
  for (std::size_t i = 1; i < found.size(); ++i) EXPECT_GE(found[i - 1].diameter, found[i].diameter);
}

}  // namespace
}  // namespace dougong::structures
