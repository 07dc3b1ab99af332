// Small scenes that tests and benches share: a block or a few on a ground.
#pragma once

#include <memory>

#include "engine/scene.h"

namespace dougong::scenes {

inline engine::Body block(double half_width, double half_height, engine::Vec2 position, double angle = 0.0) {
  engine::Body body;
  body.name = "block";
  body.shape = engine::make_rectangle(2.0 * half_width, 2.0 * half_height);
  body.position = position;
  body.angle = angle;
  return body;
}

/// A long rectangular ground whose top passes through `top` and slopes up by `slope` (rad).
inline engine::Terrain ground(double length = 200.0, engine::Vec2 top = {}, double slope = 0.0,
                              std::shared_ptr<const engine::PrescribedMotion> motion = nullptr) {
  engine::Terrain terrain;
  terrain.name = "ground";
  terrain.shape = engine::make_rectangle(length, 2.0);
  terrain.position = top + engine::rotated({0.0, -1.0}, slope);
  terrain.angle = slope;
  terrain.motion = std::move(motion);
  return terrain;
}

/// A scene of one material with g = 9.81 m/s2, the value of the reference cases.
inline engine::Scene scene(double friction, double young_modulus = 30e9, double damping_ratio = 1.0) {
  engine::Scene s;
  s.gravity = {0.0, -9.81};
  s.materials[0].friction_coefficient = friction;
  s.materials[0].young_modulus = young_modulus;
  s.materials[0].damping_ratio = damping_ratio;
  return s;
}

/// A motion given by three functions of time.
template <class A, class V, class D>
class FunctionMotion final : public engine::PrescribedMotion {
 public:
  FunctionMotion(A a, V v, D d) : a_(a), v_(v), d_(d) {}
  engine::MotionSample at(double t) const override { return {{d_(t), 0.0}, {v_(t), 0.0}, {a_(t), 0.0}}; }

 private:
  A a_;
  V v_;
  D d_;
};
template <class A, class V, class D>
std::shared_ptr<const engine::PrescribedMotion> horizontal_motion(A a, V v, D d) {
  return std::make_shared<FunctionMotion<A, V, D>>(a, v, d);
}

}  // namespace dougong::scenes
