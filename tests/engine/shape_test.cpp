#include "engine/shape.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "tests/engine/reference.h"
#include "tests/oracles/polygons.h"
#include "tests/scenes/running.h"

namespace dougong::engine {
namespace {

using testing::expect_relative;
using ::testing::HasSubstr;

std::vector<Vec2> shifted(std::vector<Vec2> points, Vec2 by) {
  for (Vec2& p : points) p += by;
  return points;
}

const std::vector<Vec2> pentagon{{0, 0}, {2, 0.3}, {2.6, 1.7}, {1.1, 2.8}, {-0.4, 1.2}};

// Every corner twice, every edge in three.
std::vector<Vec2> with_spare_corners(const std::vector<Vec2>& outline) {
  std::vector<Vec2> spare;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 p = outline[i], q = outline[(i + 1) % outline.size()];
    spare.insert(spare.end(), {p, p, p + 0.25 * (q - p), 0.5 * (p + q)});
  }
  return spare;
}

std::string refusal(const std::vector<Vec2>& points) {
  try {
    make_polygon(points);
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "accepted";
}

TEST(PolygonMass, IsTheReferencePentagons) {
  const PlacedPolygon placed = make_polygon(pentagon);
  const MassProperties m = mass_properties(placed.polygon, 2400.0, 1.0);
  expect_relative("E13", "pentagon area", 5.235, area_properties(placed.polygon).area, 1e-13);
  expect_relative("E13", "pentagon centroid x", 1.0753581661891, placed.centroid.x, 1e-13);
  expect_relative("E13", "pentagon centroid y", 1.2526265520535, placed.centroid.y, 1e-13);
  expect_relative("E13", "pentagon mass", 12564.0, m.mass, 1e-13);
  expect_relative("E13", "pentagon inertia", 11049.414212034, m.inertia, 1e-13);
}

TEST(PolygonMass, IsTheReferenceHexagons) {
  const PlacedPolygon placed = make_polygon(oracles::regular_corners(6, 0.8, {}, 0.0));
  expect_relative("E13", "hexagon area", 1.6627687752661, area_properties(placed.polygon).area, 1e-13);
  expect_relative("E13", "hexagon inertia", 1064.1720161703,
                  mass_properties(placed.polygon, 2400.0, 1.0).inertia, 1e-13);
}

// A coordinate of 1e6 m is rounded to 1.2e-10 m, which the corners themselves then carry.
TEST(PolygonMass, SurvivesAShiftOfAThousandKilometres) {
  const Vec2 far{1e6, -1e6};
  const PlacedPolygon placed = make_polygon(shifted(pentagon, far));
  expect_relative("E13", "pentagon area at 1e6 m", 5.235, area_properties(placed.polygon).area, 1e-9);
  expect_relative("E13", "pentagon inertia at 1e6 m", 11049.414212034,
                  mass_properties(placed.polygon, 2400.0, 1.0).inertia, 1e-9);
  EXPECT_NEAR((placed.centroid - far).x, 1.0753581661891, 1e-9);
  EXPECT_NEAR((placed.centroid - far).y, 1.2526265520535, 1e-9);
}

TEST(PolygonMass, MatchesRegularPolygonsAndTriangles) {
  for (int n = 3; n <= 12; ++n) {
    const auto exact = oracles::regular_polygon(n, 0.7);
    const auto area =
        area_properties(make_polygon(oracles::regular_corners(n, 0.7, {3.0, -2.0}, 0.1 * n)).polygon);
    EXPECT_NEAR(area.area / exact.area, 1.0, 1e-13) << n;
    EXPECT_NEAR(area.second_moment / exact.second_moment, 1.0, 1e-13) << n;
  }
  const std::vector<Vec2> corners{{0.2, 0.1}, {3.1, 0.4}, {-0.5, 1.9}};
  const auto exact = oracles::triangle(corners[0], corners[1], corners[2]);
  const auto area = area_properties(make_polygon(corners).polygon);
  EXPECT_NEAR(area.area / exact.area, 1.0, 1e-14);
  EXPECT_NEAR(area.second_moment / exact.second_moment, 1.0, 1e-14);
}

TEST(PolygonMass, DoesNotDependOnTheSenseOfRotation) {
  std::vector<Vec2> clockwise(pentagon.rbegin(), pentagon.rend());
  const PlacedPolygon placed = make_polygon(clockwise);
  EXPECT_NEAR(area_properties(placed.polygon).area, 5.235, 1e-13);
  for (std::size_t i = 0; i < placed.polygon.size(); ++i) {
    EXPECT_NEAR(dot(placed.polygon.normal(i), placed.polygon.normal(i)), 1.0, 1e-14);
    EXPECT_GT(dot(placed.polygon.normal(i), placed.polygon.vertex(i)), 0.0) << "normals point outwards";
  }
}

TEST(PolygonMass, IgnoresRepeatedAndCollinearCorners) {
  const PlacedPolygon placed = make_polygon(with_spare_corners(pentagon)), clean = make_polygon(pentagon);
  EXPECT_EQ(placed.polygon.size(), 5u);
  EXPECT_NEAR(
      mass_properties(placed.polygon, 2400, 1).inertia / mass_properties(clean.polygon, 2400, 1).inertia, 1.0,
      1e-13);
  EXPECT_NEAR(norm(placed.centroid - clean.centroid), 0.0, 1e-13);
}

// X09. A tumble on its corners shows any difference of outline, mass or centroid.
TEST(Polygon, TumblesWithSpareCornersAsWithout) {
  const auto tumbled = [](const std::vector<Vec2>& outline) {
    Scene s = scenes::scene(0.4, 1e8, 0.3);
    Body body;
    body.name = "pentagon";
    const PlacedPolygon placed = make_polygon(outline);
    body.shape = placed.polygon;
    body.position = placed.centroid + Vec2{0.0, 0.5};
    body.velocity.x = 5.0, body.spin = -4.0;
    s.bodies.push_back(body);
    s.terrains.push_back(scenes::ground());
    scenes::Running r(s);
    r.run(scenes::run_for(2.0));
    return r;
  };
  const scenes::Running clean = tumbled(pentagon);
  for (const auto& outline :
       {with_spare_corners(pentagon), std::vector<Vec2>(pentagon.rbegin(), pentagon.rend())}) {
    const scenes::Running r = tumbled(outline);
    EXPECT_GT(std::abs(r.angle()), 0.5) << "it has not tumbled";
    testing::expect_absolute("X09", "outline of " + std::to_string(outline.size()) + " corners: place (m)",
                             0.0, norm(r.position() - clean.position()), 1e-9);
    testing::expect_absolute("X09", "outline of " + std::to_string(outline.size()) + " corners: angle (rad)",
                             0.0, r.angle() - clean.angle(), 1e-9);
  }
}

TEST(Polygon, RefusesWhatIsNotOneConvexOutline) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal({{0, 0}, {1, 0}}), HasSubstr("three corners"));
  EXPECT_THAT(refusal({{0, 0}, {1, 1}, {2, 2}, {3, 3}}), HasSubstr("no area"));
  EXPECT_THAT(refusal({{1, 1}, {1, 1}, {1, 1}}), HasSubstr("no area"));
  EXPECT_THAT(refusal({{0, 0}, {2, 0}, {2, 2}, {1, 0.5}, {0, 2}}), HasSubstr("convex"));
  EXPECT_THAT(refusal({{0, 0}, {2, 2}, {2, 0}, {0, 3}}), HasSubstr("crosses itself"));
  EXPECT_THAT(refusal({{0, 0}, {1, nan}, {0, 1}}), HasSubstr("non-finite"));
  std::vector<Vec2> star;
  for (const int i : {0, 2, 4, 1, 3}) star.push_back(rotated({1.0, 0.0}, 0.4 * std::numbers::pi * i));
  EXPECT_THAT(refusal(star), HasSubstr("crosses itself"));
}

TEST(Rectangle, HasItsClosedForm) {
  for (const auto& [w, h] : {std::pair{0.4, 0.2}, std::pair{2.0, 0.02}}) {
    const ConvexPolygon r = make_rectangle(w, h);
    EXPECT_NEAR(mass_properties(r, 2400.0, 0.5).mass, 1200.0 * w * h, 1e-12 * 1200.0 * w * h);
    EXPECT_NEAR(area_properties(r).second_moment, w * h * (w * w + h * h) / 12.0, 1e-15);
    EXPECT_NEAR(bounding_radius(r), 0.5 * std::hypot(w, h), 1e-15);
    EXPECT_NEAR(minimum_width(r), std::min(w, h), 1e-15);
  }
  EXPECT_THROW(make_rectangle(0.0, 1.0), std::invalid_argument);
  EXPECT_THROW(make_rectangle(1.0, -1.0), std::invalid_argument);
}

TEST(Circle, HasItsClosedForm) {
  for (const double r : {0.3, 2.0}) {
    const MassProperties m = mass_properties(make_circle(r), 2400.0, 1.0);
    EXPECT_NEAR(m.mass / (2400.0 * std::numbers::pi * r * r), 1.0, 1e-15);
    EXPECT_NEAR(m.inertia / (0.5 * m.mass * r * r), 1.0, 1e-15);
    EXPECT_EQ(minimum_width(make_circle(r)), 2.0 * r);
  }
  EXPECT_THROW(make_circle(0.0), std::invalid_argument);
}

}  // namespace
}  // namespace dougong::engine
