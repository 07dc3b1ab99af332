// Discs, and a closed box to keep them in.
#pragma once

#include "tests/scenes/running.h"

namespace dougong::scenes {

inline engine::Body disc(double radius, engine::Vec2 position) {
  engine::Body body;
  body.name = "disc";
  body.shape = engine::make_circle(radius);
  body.position = position;
  return body;
}

/// Four thick walls around (0, 0); `width` and `height` are those of the room inside.
inline void add_box(engine::Scene& s, double width, double height) {
  const double thick = 1.0;
  const auto wall = [&](const char* name, double w, double h, engine::Vec2 position) {
    engine::Terrain terrain;
    terrain.name = name;
    terrain.shape = engine::make_rectangle(w, h);
    terrain.position = position;
    s.terrains.push_back(std::move(terrain));
  };
  const double x = 0.5 * (width + thick), y = 0.5 * (height + thick), outer = width + 2.0 * thick;
  wall("floor", outer, thick, {0.0, -y});
  wall("ceiling", outer, thick, {0.0, y});
  wall("left", thick, height, {-x, 0.0});
  wall("right", thick, height, {x, 0.0});
}

}  // namespace dougong::scenes
