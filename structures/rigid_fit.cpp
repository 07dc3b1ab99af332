#include "structures/rigid_fit.h"

#include <cmath>

#include "structures/outline.h"

namespace dougong::structures {
namespace {

using engine::Vec2;

struct Point {
  double weight;
  Vec2 before, after;
};

void add_corners(const engine::Shape& shape, const Trajectory& t, std::size_t block, double mass,
                 std::size_t step, std::vector<Point>& points) {
  const auto before = outlines(shape, t.position(0, block), t.angle(0, block)),
             after = outlines(shape, t.position(step, block), t.angle(step, block));
  const std::size_t first = points.size();
  for (std::size_t i = 0; i < before.size(); ++i)
    for (std::size_t j = 0; j < before[i].size(); ++j) points.push_back({0.0, before[i][j], after[i][j]});
  for (std::size_t i = first; i < points.size(); ++i)
    points[i].weight = mass / static_cast<double>(points.size() - first);
}

void centre(std::vector<Point>& points) {
  double weight = 0.0;
  Vec2 before, after;
  for (const Point& p : points)
    weight += p.weight, before += p.weight * p.before, after += p.weight * p.after;
  for (Point& p : points) p.before -= (1.0 / weight) * before, p.after -= (1.0 / weight) * after;
}

}  // namespace

RigidFit fit_rigid_motion(const Building& building, const Trajectory& trajectory,
                          const std::vector<std::size_t>& blocks, const std::vector<double>& masses,
                          std::size_t step) {
  std::vector<Point> points;
  for (const std::size_t b : blocks)
    add_corners(building.scene.bodies[b].shape, trajectory, b, masses[b], step, points);
  centre(points);
  double sine = 0.0, cosine = 0.0, moved = 0.0, left = 0.0;
  for (const Point& p : points)
    sine += p.weight * engine::cross(p.before, p.after), cosine += p.weight * engine::dot(p.before, p.after);
  const double angle = std::atan2(sine, cosine);
  for (const Point& p : points) {
    const Vec2 movement = p.after - p.before, rest = p.after - engine::rotated(p.before, angle);
    moved += p.weight * engine::dot(movement, movement), left += p.weight * engine::dot(rest, rest);
  }
  return {angle, moved > 0.0 ? 1.0 - left / moved : 0.0};
}

}  // namespace dougong::structures
