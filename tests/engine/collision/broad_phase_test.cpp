#include "engine/collision/broad_phase.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/collision/separation.h"
#include "tests/engine/collision/scenes.h"

namespace dougong::engine {
namespace {

struct Bounds {
  Vec2 low, high;
};

Bounds bounds_of(const Shape& shape, const Frame& frame) {
  if (const auto* circle = std::get_if<Circle>(&shape)) {
    const Vec2 r{circle->radius, circle->radius};
    return {frame.position() - r, frame.position() + r};
  }
  Bounds b{{1e300, 1e300}, {-1e300, -1e300}};
  for (const Vec2 v : std::get<ConvexPolygon>(shape).vertices()) {
    const Vec2 p = frame.to_world(v);
    b.low = {std::min(b.low.x, p.x), std::min(b.low.y, p.y)};
    b.high = {std::max(b.high.x, p.x), std::max(b.high.y, p.y)};
  }
  return b;
}

// Every pair of which both the circles and the boxes are within the skin.
std::vector<BodyPair> all_close_pairs(const Model& model, std::span<const Frame> frames, double skin) {
  std::vector<BodyPair> pairs;
  for (Index i = 0; i < model.size(); ++i)
    for (Index j = i + 1; j < model.size(); ++j) {
      if (model.is_terrain(i) && model.is_terrain(j)) continue;
      if (norm(frames[i].position() - frames[j].position()) >
          model.bounding_radius[i] + model.bounding_radius[j] + skin)
        continue;
      const Bounds a = bounds_of(model.shapes[i], frames[i]), b = bounds_of(model.shapes[j], frames[j]);
      if (a.low.x - b.high.x > skin || b.low.x - a.high.x > skin) continue;
      if (a.low.y - b.high.y > skin || b.low.y - a.high.y > skin) continue;
      pairs.push_back({i, j});
    }
  return pairs;
}

Scene random_scene(std::mt19937& random, int bodies, double spread) {
  std::vector<Body> all;
  for (int i = 0; i < bodies; ++i) {
    const Vec2 place{testing::uniform(random, -spread, spread), testing::uniform(random, 0.0, spread)};
    const double size = testing::uniform(random, 0.1, 0.5);
    if (i % 3 == 0)
      all.push_back(testing::body_of(make_circle(size), place, 0.0));
    else
      all.push_back(
          testing::body_of(testing::random_polygon(random, size), place, testing::uniform(random, -3, 3)));
  }
  return testing::scene_of(std::move(all));
}

void expect_complete(const Scene& scene, double skin) {
  const Model model = compile(scene);
  const auto frames = testing::frames_at_start(model, scene);
  const auto found = find_pairs(model, frames, skin);
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
  EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
  EXPECT_EQ(found, all_close_pairs(model, frames, skin));
}

TEST(BroadPhase, FindsWhatTestingEveryPairFinds) {
  std::mt19937 random(4);
  for (const double spread : {0.5, 3.0, 20.0})
    for (const int bodies : {1, 2, 50, 300}) expect_complete(random_scene(random, bodies, spread), 0.05);
}

TEST(BroadPhase, IsCompleteWithSlabsFarDebrisAndTerrains) {
  std::mt19937 random(5);
  Scene scene = random_scene(random, 200, 8.0);
  scene.bodies.push_back(testing::body_of(make_rectangle(30.0, 0.3), {0.0, 4.0}, 0.2));
  scene.bodies.push_back(testing::body_of(make_rectangle(0.3, 25.0), {2.0, 4.0}, 0.0));
  scene.bodies.push_back(testing::body_of(make_circle(0.2), {1e5, 3.0}, 0.0));
  scene.bodies.push_back(testing::body_of(make_circle(0.2), {-40.0, 1e6}, 0.0));
  scene.terrains.push_back(scenes::ground());
  scene.terrains.push_back(scenes::ground(10.0, {0.0, 1.0}, 0.5));
  expect_complete(scene, 0.1);
}

TEST(BroadPhase, NeverPairsTwoTerrains) {
  Scene scene = testing::scene_of({testing::body_of(make_circle(0.1), {0.0, 50.0}, 0.0)});
  scene.terrains.push_back(scenes::ground());
  scene.terrains.push_back(scenes::ground());
  const Model model = compile(scene);
  EXPECT_TRUE(find_pairs(model, testing::frames_at_start(model, scene), 0.1).empty());
}

}  // namespace
}  // namespace dougong::engine
