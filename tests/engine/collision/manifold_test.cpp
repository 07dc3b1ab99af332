#include "engine/collision/manifold.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/engine/collision/scenes.h"

namespace dougong::engine {
namespace {

struct Contact {
  Scene scene;
  Model model;
  std::vector<Frame> frames;

  explicit Contact(Scene s)
      : scene(std::move(s)), model(compile(scene)), frames(testing::frames_at_start(model, scene)) {}
  Manifold find(double margin = 0.01, const Manifold& previous = {}) const {
    return find_manifold(model, frames, 0, 1, margin, previous);
  }
  Vec2 corner(const Feature& f) const { return model.origin + frames[f.corner_body].to_world(f.corner); }
  Vec2 normal(const Feature& f) const { return frames[f.edge_body].turned_to_world(f.edge_normal); }
  double gap(const Feature& f) const {
    return dot(normal(f), corner(f) - model.origin - frames[f.edge_body].to_world(f.edge_point)) - f.radius;
  }
  void move(std::size_t body, Vec2 by, double turn = 0.0) {
    frames[body].x += by.x, frames[body].y += by.y;
    frames[body].turn_to(frames[body].angle + turn);
  }
};

Body brick(Vec2 position, double angle = 0.0, double w = 0.4, double h = 0.2) {
  return testing::body_of(make_rectangle(w, h), position, angle);
}

// Contact points from left to right.
std::vector<Vec2> places(const Contact& c, const Manifold& m) {
  std::vector<Vec2> p;
  for (Index i = 0; i < m.count; ++i) p.push_back(c.corner(m.features[i]));
  std::sort(p.begin(), p.end(), [](Vec2 a, Vec2 b) { return a.x < b.x; });
  return p;
}

TEST(Manifold, OfFlushFacesIsTheWholeFace) {
  const Contact c(testing::scene_of({brick({0, 0.1}), brick({0, 0.3})}));
  const Manifold m = c.find();
  ASSERT_EQ(m.count, 2u);
  EXPECT_NEAR(m.length, 0.4, 1e-14);
  EXPECT_NEAR(m.depth_a, 0.1, 1e-15);
  EXPECT_NEAR(m.depth_b, 0.1, 1e-15);
  EXPECT_NEAR(places(c, m)[0].x, -0.2, 1e-14);
  EXPECT_NEAR(places(c, m)[1].x, 0.2, 1e-14);
  for (Index i = 0; i < 2; ++i) EXPECT_NEAR(c.gap(m.features[i]), 0.0, 1e-14);
}

TEST(Manifold, OfOffsetFacesIsTheirCommonPart) {
  const Contact c(testing::scene_of({brick({0, 0.1}), brick({0.15, 0.3})}));
  const Manifold m = c.find();
  ASSERT_EQ(m.count, 2u);
  EXPECT_NEAR(m.length, 0.25, 1e-14);
  EXPECT_NEAR(places(c, m)[0].x, -0.05, 1e-14);
  EXPECT_NEAR(places(c, m)[1].x, 0.2, 1e-14);
  EXPECT_NE(m.features[0].corner_body, m.features[1].corner_body) << "one corner of each brick";
}

TEST(Manifold, OfACornerInAFaceHasThatCorner) {
  const double angle = 1.0 - std::atan2(0.2, 0.4);  // the lowest corner points down at 1 rad
  const double height = 0.5 * std::hypot(0.4, 0.2) * std::sin(1.0);
  const Contact c(testing::scene_of({brick({0, -0.5}, 0.0, 4.0, 1.0), brick({0.3, height - 0.001}, angle)}));
  const Manifold m = c.find();
  ASSERT_GE(m.count, 1u);
  double deepest = 1.0;
  for (Index i = 0; i < m.count; ++i) {
    EXPECT_EQ(m.features[i].corner_body, 1u);
    EXPECT_NEAR(norm(c.normal(m.features[i]) - Vec2{0.0, 1.0}), 0.0, 1e-14);
    deepest = std::min(deepest, c.gap(m.features[i]));
  }
  double lowest = 1.0;  // corner of the brick, from its pose alone
  for (const Vec2 v : std::get<ConvexPolygon>(c.scene.bodies[1].shape).vertices())
    lowest = std::min(lowest, (c.scene.bodies[1].position + rotated(v, angle)).y);
  EXPECT_NEAR(deepest, lowest, 1e-13);
}

// E06: the block overhangs and has begun to tip; the ledge's own corner carries it.
TEST(Manifold, OfALedgeCornerUnderAFaceHasThatCorner) {
  const double angle = -0.2;
  const Vec2 edge{0.0, 0.0};
  const Vec2 centre = edge + rotated({0.05, 0.1}, angle);
  Contact c(testing::scene_of({brick({-2.0, -1.0}, 0.0, 4.0, 2.0), brick(centre, angle, 1.0, 0.2)}));
  const Manifold m = c.find();
  bool found = false;
  for (Index i = 0; i < m.count; ++i) {
    if (m.features[i].corner_body != 0) continue;
    found = true;
    EXPECT_NEAR(norm(c.corner(m.features[i]) - edge), 0.0, 1e-13);
    EXPECT_NEAR(c.gap(m.features[i]), 0.0, 1e-13);
    EXPECT_NEAR(norm(c.normal(m.features[i]) - rotated({0.0, -1.0}, angle)), 0.0, 1e-13);
  }
  EXPECT_TRUE(found);
}

TEST(Manifold, IsEmptyBeyondTheMargin) {
  for (const double gap : {0.005, 0.0099, 0.0101, 0.1}) {
    const Contact c(testing::scene_of({brick({0, 0.1}), brick({0.05, 0.3 + gap})}));
    EXPECT_EQ(c.find(0.01).count > 0, gap < 0.01) << gap;
  }
}

TEST(Manifold, KeepsItsIdentitiesWhileTheBodiesMoveALittle) {
  Contact c(testing::scene_of({brick({0, 0.1}), brick({0.0, 0.2998})}));
  Manifold m = c.find();
  const auto first = m.features[0].identity, second = m.features[1].identity;
  std::mt19937 random(6);
  for (int i = 0; i < 200; ++i) {
    const Contact start = c;
    c.move(1, {testing::uniform(random, -1e-3, 1e-3), testing::uniform(random, -1e-4, 1e-4)},
           testing::uniform(random, -1e-3, 1e-3));
    m = c.find(0.01, m);
    ASSERT_EQ(m.count, 2u);
    EXPECT_EQ(m.features[0].identity, first) << i;
    EXPECT_EQ(m.features[1].identity, second) << i;
    c = start;
  }
}

TEST(Manifold, GivesTheTwoEndsDifferentIdentities) {
  std::mt19937 random(7);
  int pairs = 0;
  for (int i = 0; i < 2000; ++i) {
    const Contact c(testing::scene_of(
        {testing::body_of(testing::random_polygon(random, 1.0), {}, 0.0),
         testing::body_of(testing::random_polygon(random, 0.7),
                          {testing::uniform(random, -2, 2), testing::uniform(random, -2, 2)},
                          testing::uniform(random, -3, 3))}));
    const Manifold m = c.find();
    if (m.count < 2) continue;
    ++pairs;
    EXPECT_NE(m.features[0].identity, m.features[1].identity);
    EXPECT_GT(m.length, 0.0);
  }
  EXPECT_GT(pairs, 100);
}

// The same place, depth and length whichever body is called a.
TEST(Manifold, IsTheSameUnderSwappingTheBodies) {
  std::mt19937 random(8);
  int compared = 0;
  for (int i = 0; i < 500; ++i) {
    const Body one =
        testing::body_of(testing::random_polygon(random, 1.0), {}, testing::uniform(random, -3, 3));
    const Body two =
        testing::body_of(testing::random_polygon(random, 1.0),
                         rotated({testing::uniform(random, 1.0, 1.9), 0.0}, testing::uniform(random, -3, 3)),
                         testing::uniform(random, -3, 3));
    const Contact ab(testing::scene_of({one, two})), ba(testing::scene_of({two, one}));
    const Manifold m = ab.find(1e-9), n = ba.find(1e-9);
    ASSERT_EQ(m.count, n.count) << i;
    if (m.count == 0) continue;
    ++compared;
    EXPECT_NEAR(m.length, n.length, 1e-12);
    EXPECT_NEAR(m.depth_a, n.depth_b, 1e-12);
    const auto p = places(ab, m), q = places(ba, n);
    for (std::size_t k = 0; k < p.size(); ++k) EXPECT_NEAR(norm(p[k] - q[k]), 0.0, 1e-12);
  }
  EXPECT_GT(compared, 100);
}

Body mirrored(const Body& body) {
  std::vector<Vec2> corners;
  for (const Vec2 v : std::get<ConvexPolygon>(body.shape).vertices()) corners.push_back({-v.x, v.y});
  return testing::body_of(make_polygon(corners).polygon, {-body.position.x, body.position.y}, -body.angle);
}

TEST(Manifold, OfAMirroredPairIsMirrored) {
  std::mt19937 random(9);
  int compared = 0;
  for (int i = 0; i < 500; ++i) {
    const Body one =
        testing::body_of(testing::random_polygon(random, 1.0), {}, testing::uniform(random, -3, 3));
    const Body two =
        testing::body_of(testing::random_polygon(random, 1.0),
                         rotated({testing::uniform(random, 1.0, 1.9), 0.0}, testing::uniform(random, -3, 3)),
                         testing::uniform(random, -3, 3));
    const Contact here(testing::scene_of({one, two})),
        there(testing::scene_of({mirrored(one), mirrored(two)}));
    const Manifold m = here.find(1e-9), n = there.find(1e-9);
    ASSERT_EQ(m.count, n.count) << i;
    if (m.count == 0) continue;
    ++compared;
    auto p = places(here, m), q = places(there, n);
    std::reverse(q.begin(), q.end());
    for (std::size_t k = 0; k < p.size(); ++k) EXPECT_NEAR(norm(p[k] - Vec2{-q[k].x, q[k].y}), 0.0, 1e-12);
  }
  EXPECT_GT(compared, 100);
}

TEST(Manifold, OfACircleIsItsNearestPoint) {
  const Contact face(testing::scene_of(
      {brick({0, -0.5}, 0.0, 4.0, 1.0), testing::body_of(make_circle(0.3), {0.7, 0.29}, 2.0)}));
  const Manifold on_face = face.find();
  ASSERT_EQ(on_face.count, 1u);
  EXPECT_EQ(on_face.features[0].kind, FeatureKind::corner_edge);
  EXPECT_NEAR(face.gap(on_face.features[0]), -0.01, 1e-13);

  const Vec2 corner{2.0, 0.0}, away = rotated({1.0, 0.0}, 0.9);
  const Contact tip(testing::scene_of(
      {brick({0, -0.5}, 0.0, 4.0, 1.0), testing::body_of(make_circle(0.3), corner + 0.295 * away, 0.0)}));
  const Manifold on_corner = tip.find();
  ASSERT_EQ(on_corner.count, 1u);
  EXPECT_EQ(on_corner.features[0].kind, FeatureKind::round);
  EXPECT_NEAR(on_corner.features[0].radius, 0.3, 0.0);
  EXPECT_NEAR(norm(on_corner.features[0].edge_point - Vec2{2.0, 0.5}), 0.0, 1e-14);
}

TEST(Manifold, OfTwoCirclesIsOnTheLineOfCentres) {
  for (const double distance : {0.79, 0.805, 0.82}) {
    const Contact c(
        testing::scene_of({testing::body_of(make_circle(0.3), {}, 0.0),
                           testing::body_of(make_circle(0.5), rotated({distance, 0.0}, 2.1), 0.0)}));
    const Manifold m = c.find();
    ASSERT_EQ(m.count, distance < 0.81 ? 1u : 0u) << distance;
    if (m.count == 0) continue;
    EXPECT_EQ(m.features[0].radius, 0.8);
    EXPECT_EQ(m.features[0].other_radius, 0.5);
  }
}

}  // namespace
}  // namespace dougong::engine
