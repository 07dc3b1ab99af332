#include "structures/outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dougong::structures {
namespace {

using engine::Vec2;

Outline circle(double radius) {
  constexpr int corners = 48;
  Outline points;
  for (int i = 0; i < corners; ++i)
    points.push_back(engine::rotated({radius, 0.0}, 2.0 * std::numbers::pi * i / corners));
  return points;
}

void add(const engine::Circle& shape, std::vector<Outline>& out) {
  out.push_back(circle(shape.radius));
}
void add(const engine::ConvexPolygon& shape, std::vector<Outline>& out) {
  out.push_back(shape.vertices());
}
void add(const engine::HalfPlane&, std::vector<Outline>&) {}
void add(const engine::Compound& compound, std::vector<Outline>& out) {
  for (const engine::Part& part : compound.parts) {
    std::visit([&](const auto& shape) { add(shape, out); }, part.shape);
    for (Vec2& corner : out.back()) corner = part.position + engine::rotated(corner, part.angle);
  }
}

}  // namespace

std::vector<Outline> outlines(const engine::Shape& shape, Vec2 position, double angle) {
  std::vector<Outline> out;
  std::visit([&](const auto& s) { add(s, out); }, shape);
  for (Outline& outline : out)
    for (Vec2& corner : outline) corner = position + engine::rotated(corner, angle);
  return out;
}

Extent extent_of(const Outline& points) {
  if (points.empty()) return {};
  Extent box{points.front(), points.front()};
  for (const Vec2 p : points) box = joined(box, {p, p});
  return box;
}

Extent joined(const Extent& a, const Extent& b) {
  return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
          {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}

PlacedShape placed(const Outline& outline) {
  const Extent box = extent_of(outline);
  return {outline, 0.0, box.low, box.high};
}

}  // namespace dougong::structures
