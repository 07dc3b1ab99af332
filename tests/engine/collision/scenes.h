// Poses for the collision tests: shapes anywhere, at any angle.
#pragma once

#include <cmath>
#include <numbers>
#include <random>

#include "engine/collision/manifold.h"
#include "tests/scenes/blocks.h"

namespace dougong::engine::testing {

inline double uniform(std::mt19937& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
}

/// Corners on a circle at random angles: always convex.
inline ConvexPolygon random_polygon(std::mt19937& random, double radius) {
  std::vector<Vec2> corners;
  const int n = 3 + static_cast<int>(random() % 6);
  for (int i = 0; i < n; ++i)
    corners.push_back(rotated({radius, 0.0}, 2.0 * std::numbers::pi * (i + uniform(random, 0.1, 0.9)) / n));
  return make_polygon(corners).polygon;
}

inline Body body_of(const Shape& shape, Vec2 position, double angle) {
  Body body;
  body.name = "body";
  body.shape = shape;
  body.position = position;
  body.angle = angle;
  return body;
}

inline Scene scene_of(std::vector<Body> bodies) {
  Scene scene;
  scene.bodies = std::move(bodies);
  return scene;
}

inline std::vector<Frame> frames_at_start(const Model& model, const Scene& scene) {
  std::vector<Frame> frames(model.size());
  for (std::size_t i = 0; i < model.body_count; ++i) {
    const Vec2 p = scene.bodies[i].position - model.origin;
    frames[i].x = p.x, frames[i].y = p.y;
    frames[i].turn_to(scene.bodies[i].angle);
  }
  place_terrains(model, 0.0, false, frames);
  return frames;
}

}  // namespace dougong::engine::testing
