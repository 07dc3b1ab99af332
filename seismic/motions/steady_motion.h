// A ground that moves at a constant velocity: a conveyor belt.
//
//   a = 0,   v = V,   d = V t
#pragma once

#include "engine/motion.h"

namespace dougong::seismic {

class SteadyMotion final : public engine::PrescribedMotion {
 public:
  /// m/s.
  explicit SteadyMotion(engine::Vec2 velocity) : velocity_(velocity) {}
  engine::MotionSample at(double t) const override { return {t * velocity_, velocity_, {}}; }

 private:
  engine::Vec2 velocity_;
};

}  // namespace dougong::seismic
