// A ground that moves horizontally with an acceleration linear between samples; velocity and displacement
// are its exact integrals from rest. After the last sample it goes on at constant velocity.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "engine/motion.h"

namespace dougong::scenes {

class RecordMotion final : public engine::PrescribedMotion {
 public:
  RecordMotion(std::vector<double> samples, double dt) : a_(std::move(samples)), dt_(dt) {
    v_.assign(1, 0.0), d_.assign(1, 0.0);
    for (std::size_t k = 0; k + 1 < a_.size(); ++k) {
      d_.push_back(d_[k] + dt * (v_[k] + dt * (2.0 * a_[k] + a_[k + 1]) / 6.0));
      v_.push_back(v_[k] + 0.5 * dt * (a_[k] + a_[k + 1]));
    }
  }
  engine::MotionSample at(double t) const override {
    const std::size_t last = a_.size() - 1;
    const auto k = std::min(last, static_cast<std::size_t>(std::max(0.0, t / dt_)));
    const double x = t - static_cast<double>(k) * dt_;
    if (k == last) return {{d_[k] + v_[k] * x, 0.0}, {v_[k], 0.0}, {}};
    const double slope = (a_[k + 1] - a_[k]) / dt_;
    return {{d_[k] + x * (v_[k] + x * (a_[k] / 2.0 + x * slope / 6.0)), 0.0},
            {v_[k] + x * (a_[k] + x * slope / 2.0), 0.0},
            {a_[k] + slope * x, 0.0}};
  }
  double knot_interval() const override { return dt_; }

 private:
  std::vector<double> a_, v_, d_;
  double dt_;  // s
};

inline std::shared_ptr<const engine::PrescribedMotion> record_motion(std::vector<double> samples, double dt) {
  return std::make_shared<RecordMotion>(std::move(samples), dt);
}

}  // namespace dougong::scenes
