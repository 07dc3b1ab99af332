// Ground acceleration that is constant on equal intervals: a rectangular pulse is one of them.
//
//   k h <= t < (k+1) h:   a = a[k],   v = v[k] + a[k] s,   d = d[k] + v[k] s + a[k] s^2/2,   s = t - k h
//
// From rest; behind the last interval the acceleration is zero and the ground keeps its velocity.
#pragma once

#include <vector>

#include "engine/motion.h"

namespace dougong::seismic {

class PulseMotion final : public engine::PrescribedMotion {
 public:
  /// Accelerations in m/s2, interval in s, direction as given.
  PulseMotion(std::vector<double> accelerations, double interval, engine::Vec2 direction = {1.0, 0.0});
  engine::MotionSample at(double t) const override;
  double knot_interval() const override { return interval_; }

 private:
  std::vector<double> accelerations_, velocities_, displacements_;
  double interval_;
  engine::Vec2 direction_;
};

}  // namespace dougong::seismic
