// Areas and polar second moments about the centroid of figures with a closed form, independent of Green's
// theorem: a regular n-gon of circumradius R, and any triangle, A (a^2 + b^2 + c^2) / 36.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "engine/vec2.h"

namespace dougong::oracles {

struct AreaAndMoment {
  double area, second_moment;
};

inline AreaAndMoment regular_polygon(int n, double radius) {
  const double half = std::numbers::pi / n;
  const double area = 0.5 * n * radius * radius * std::sin(2.0 * half);
  return {area, area * radius * radius * (2.0 + std::cos(2.0 * half)) / 6.0};
}

inline AreaAndMoment triangle(engine::Vec2 p, engine::Vec2 q, engine::Vec2 r) {
  const engine::Vec2 a = q - p, b = r - q, c = p - r;
  const double area = 0.5 * std::abs(cross(a, b));
  return {area, area * (dot(a, a) + dot(b, b) + dot(c, c)) / 36.0};
}

inline std::vector<engine::Vec2> regular_corners(int n, double radius, engine::Vec2 centre, double turn) {
  std::vector<engine::Vec2> corners;
  for (int i = 0; i < n; ++i)
    corners.push_back(centre + engine::rotated({radius, 0.0}, turn + 2.0 * std::numbers::pi * i / n));
  return corners;
}

}  // namespace dougong::oracles
