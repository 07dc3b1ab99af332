// Filled polygons and lines to a picture, by OSMesa: no window, no display.
//
// Antialiasing by accumulation: every picture is drawn 16 times, shifted by fractions of a pixel, and
// averaged. As good as drawing at 4 x 4 times the size, without its memory.
#pragma once

#include <vector>

#include "app/report/colour.h"
#include "app/report/image.h"
#include "engine/vec2.h"

namespace dougong::app {

struct FilledPolygon {
  std::vector<engine::Vec2> outline;  // px, y up; convex
  Colour colour;
};

/// Shapes are painted in the order they were added. Coordinates in pixels, origin at the lower left.
class Drawing {
 public:
  void polygon(std::vector<engine::Vec2> convex, Colour colour);
  /// A closed line of a width (px) along a convex outline, mitred at the corners.
  void outline(const std::vector<engine::Vec2>& convex, double width, Colour colour);
  void line(engine::Vec2 from, engine::Vec2 to, double width, Colour colour);
  Image render(int width, int height, Colour background = ink::white) const;

 private:
  std::vector<FilledPolygon> shapes_;
};

}  // namespace dougong::app
