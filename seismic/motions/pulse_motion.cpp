#include "seismic/motions/pulse_motion.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace dougong::seismic {

PulseMotion::PulseMotion(std::vector<double> accelerations, double interval, engine::Vec2 direction)
    : accelerations_(std::move(accelerations)), interval_(interval), direction_(direction) {
  accelerations_.push_back(0.0);  // for ever after
  double v = 0.0, d = 0.0;
  for (const double a : accelerations_) {
    velocities_.push_back(v);
    displacements_.push_back(d);
    d += interval_ * (v + 0.5 * a * interval_);
    v += a * interval_;
  }
}

engine::MotionSample PulseMotion::at(double t) const {
  if (!(t >= 0.0)) return {};
  const std::size_t last = accelerations_.size() - 1;
  const double steps = t / interval_;
  const std::size_t k = steps >= static_cast<double>(last) ? last : static_cast<std::size_t>(steps);
  const double s = t - interval_ * static_cast<double>(k), a = accelerations_[k];
  return {(displacements_[k] + s * (velocities_[k] + 0.5 * a * s)) * direction_,
          (velocities_[k] + a * s) * direction_, a * direction_};
}

}  // namespace dougong::seismic
