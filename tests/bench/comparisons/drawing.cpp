#include "tests/bench/comparisons/drawing.h"

#include <fmt/format.h>

#include <algorithm>

namespace dougong::comparisons {

std::string outlines(const engine::Scene& scene, const std::vector<structures::BlockMotion>& motions,
                     double scale) {
  std::string out;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const engine::Body& body = scene.bodies[i];
    const structures::BlockMotion motion = motions.empty() ? structures::BlockMotion{} : motions[i];
    const auto& polygon = std::get<engine::ConvexPolygon>(body.shape);
    for (std::size_t k = 0; k <= polygon.size(); ++k) {
      const engine::Vec2 corner = body.position + scale * motion.translation +
                                  engine::rotated(polygon.vertex(k), body.angle + scale * motion.turn);
      out += fmt::format("{:.6g} {:.6g}\n", corner.x, corner.y);
    }
    out += '\n';
  }
  return out;
}

double magnification(const std::vector<structures::BlockMotion>& motions, double length) {
  double largest = 0.0;
  for (const structures::BlockMotion& motion : motions)
    largest = std::max(largest, engine::norm(motion.translation));
  return largest > 0.0 ? length / largest : 1.0;
}

}  // namespace dougong::comparisons
