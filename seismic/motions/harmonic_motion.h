// Harmonic ground acceleration from rest:
//
//   a = A sin(w t),   v = A/w (1 - cos w t),   d = A/w (t - sin(w t)/w),   t >= 0,  w = 2 pi f
//
// The velocity has a constant part A/w: a ground that starts from rest under a sine of acceleration drifts.
#pragma once

#include "engine/motion.h"

namespace dougong::seismic {

class HarmonicMotion final : public engine::PrescribedMotion {
 public:
  /// Amplitude in m/s2, frequency in Hz, direction as given (a unit vector for the full amplitude).
  HarmonicMotion(double amplitude, double frequency, engine::Vec2 direction = {1.0, 0.0});
  engine::MotionSample at(double t) const override;

 private:
  double amplitude_, angular_frequency_;
  engine::Vec2 direction_;
};

}  // namespace dougong::seismic
