#include "engine/collision/separation.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/engine/collision/scenes.h"

namespace dougong::engine {
namespace {

Frame pose(Vec2 position, double angle) {
  Frame f;
  f.x = position.x, f.y = position.y;
  f.turn_to(angle);
  return f;
}

// Everything in world coordinates, from the definition.
double by_definition(const ConvexPolygon& owner, const Frame& fo, std::size_t edge,
                     const ConvexPolygon& other, const Frame& fx) {
  const Vec2 p = fo.to_world(owner.vertex(edge)), q = fo.to_world(owner.vertex(edge + 1));
  const Vec2 n = (-1.0 / norm(q - p)) * turned(q - p);
  double lowest = std::numeric_limits<double>::infinity();
  for (const Vec2 v : other.vertices()) lowest = std::min(lowest, dot(n, fx.to_world(v) - p));
  return lowest;
}

// Whether any point of a fine raster lies in both polygons.
bool share_a_point(const ConvexPolygon& a, const Frame& fa, const ConvexPolygon& b, const Frame& fb) {
  const auto inside = [](const ConvexPolygon& p, Vec2 local) {
    for (std::size_t e = 0; e < p.size(); ++e)
      if (dot(p.normal(e), local - p.vertex(e)) > 0.0) return false;
    return true;
  };
  for (double x = -1.0; x <= 1.0; x += 0.02)
    for (double y = -1.0; y <= 1.0; y += 0.02)
      if (inside(a, {x, y}) && inside(b, fb.to_local(fa.to_world({x, y})))) return true;
  return false;
}

TEST(Separation, IsItsDefinitionOnRandomPolygons) {
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    const ConvexPolygon a = testing::random_polygon(random, 1.0);
    const ConvexPolygon b = testing::random_polygon(random, testing::uniform(random, 0.05, 2.0));
    const Frame fa = pose({testing::uniform(random, -1, 1), 5.0}, testing::uniform(random, -9, 9));
    const Frame fb = pose({testing::uniform(random, -3, 3), 4.0}, testing::uniform(random, -9, 9));
    double greatest = -std::numeric_limits<double>::infinity();
    for (Index e = 0; e < a.size(); ++e) {
      const double expected = by_definition(a, fa, e, b, fb);
      ASSERT_NEAR(separation_along(a, fa, e, b, fb), expected, 1e-13);
      greatest = std::max(greatest, expected);
    }
    const Axis axis = greatest_separation(a, fa, b, fb);
    ASSERT_NEAR(axis.separation, greatest, 1e-13);
    ASSERT_NEAR(by_definition(a, fa, axis.edge, b, fb), greatest, 1e-13);
  }
}

TEST(Separation, TellsApartFromOverlapping) {
  std::mt19937 random(2);
  int apart = 0, overlapping = 0;
  for (int i = 0; i < 200; ++i) {
    const ConvexPolygon a = testing::random_polygon(random, 1.0), b = testing::random_polygon(random, 1.0);
    const Frame fa = pose({}, testing::uniform(random, -3, 3));
    const Frame fb = pose({testing::uniform(random, -2, 2), testing::uniform(random, -2, 2)}, 1.0);
    const double separation =
        std::max(greatest_separation(a, fa, b, fb).separation, greatest_separation(b, fb, a, fa).separation);
    if (std::abs(separation) < 0.06) continue;  // finer than the raster can tell
    ASSERT_EQ(separation < 0.0, share_a_point(a, fa, b, fb)) << i;
    ++(separation < 0.0 ? overlapping : apart);
  }
  EXPECT_GT(apart, 20);
  EXPECT_GT(overlapping, 20);
}

TEST(Separation, DoesNotSeeACommonShiftOrTurn) {
  std::mt19937 random(3);
  const ConvexPolygon a = testing::random_polygon(random, 1.0), b = testing::random_polygon(random, 1.0);
  const double here = greatest_separation(a, pose({}, 0.3), b, pose({1.9, 0.4}, 1.1)).separation;
  const double there = greatest_separation(a, pose({1e3, -2e3}, 0.3 + 0.8), b,
                                           pose(Vec2{1e3, -2e3} + rotated({1.9, 0.4}, 0.8), 1.1 + 0.8))
                           .separation;
  EXPECT_NEAR(here, there, 1e-11);
}

}  // namespace
}  // namespace dougong::engine
