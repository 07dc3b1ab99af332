// A scene seen in a mirror: x -> -x.
#pragma once

#include <memory>
#include <variant>
#include <vector>

#include "engine/scene.h"

namespace dougong::scenes {

class MirroredMotion final : public engine::PrescribedMotion {
 public:
  explicit MirroredMotion(std::shared_ptr<const engine::PrescribedMotion> motion)
      : motion_(std::move(motion)) {}
  engine::MotionSample at(double t) const override {
    engine::MotionSample m = motion_->at(t);
    m.displacement.x *= -1.0, m.velocity.x *= -1.0, m.acceleration.x *= -1.0;
    return m;
  }
  double knot_interval() const override { return motion_->knot_interval(); }

 private:
  std::shared_ptr<const engine::PrescribedMotion> motion_;
};

/// Of circles and polygons.
inline engine::Shape mirrored(const engine::Shape& shape) {
  const auto* polygon = std::get_if<engine::ConvexPolygon>(&shape);
  if (!polygon) return shape;
  std::vector<engine::Vec2> corners = polygon->vertices();
  for (engine::Vec2& corner : corners) corner.x *= -1.0;
  return engine::make_polygon(corners).polygon;
}

inline engine::Scene mirrored(engine::Scene s) {
  s.gravity.x *= -1.0;
  for (engine::Body& body : s.bodies) {
    body.shape = mirrored(body.shape);
    body.position.x *= -1.0, body.velocity.x *= -1.0;
    body.angle *= -1.0, body.spin *= -1.0;
  }
  for (engine::Terrain& terrain : s.terrains) {
    terrain.shape = mirrored(terrain.shape);
    terrain.position.x *= -1.0, terrain.angle *= -1.0;
    if (terrain.motion) terrain.motion = std::make_shared<MirroredMotion>(terrain.motion);
  }
  return s;
}

}  // namespace dougong::scenes
