// A burst of shaking that leaves the ground where it was: a sine under one hump,
//   d = D sin2(pi t/T) sin(w t) = D/2 [sin(w t) - 1/2 sin((w + W) t) - 1/2 sin((w - W) t)],   W = 2 pi/T,
// so its derivatives are those of three sines.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "engine/motion.h"

namespace dougong::scenes {

class Burst final : public engine::PrescribedMotion {
 public:
  /// Amplitude of the acceleration (m/s2), Hz, s.
  Burst(double amplitude, double frequency, double duration) : duration_(duration) {
    const double w = 2.0 * std::numbers::pi * frequency, hump = 2.0 * std::numbers::pi / duration;
    const double d = amplitude / (w * w);
    sines_ = {Sine{0.5 * d, w}, Sine{-0.25 * d, w + hump}, Sine{-0.25 * d, w - hump}};
  }
  engine::MotionSample at(double t) const override {
    engine::MotionSample m;
    if (t <= 0.0 || t >= duration_) return m;
    for (const auto& [d, w] : sines_) {
      m.displacement.x += d * std::sin(w * t);
      m.velocity.x += d * w * std::cos(w * t);
      m.acceleration.x -= d * w * w * std::sin(w * t);
    }
    return m;
  }

 private:
  struct Sine {
    double amplitude, frequency;  // m, rad/s
  };
  double duration_;
  std::array<Sine, 3> sines_;
};

}  // namespace dougong::scenes
