// A record as the ground's motion: acceleration linear between samples, velocity and displacement its exact
// integrals, one function of time.
//
//   a(t) = a[k] + j s                      s = t - k h,  j = (a[k+1] - a[k])/h
//   v(t) = v[k] + a[k] s + j s^2/2
//   d(t) = d[k] + v[k] s + a[k] s^2/2 + j s^3/6
//
//   h  interval  s      a  m/s2      v  m/s      d  m      absolute, from rest at d = 0
//
// Before t = 0 the ground rests. Behind the last sample it comes to rest (AfterEnd::close): a short smooth
// pulse of acceleration, with knots of the same interval, takes the velocity left over to zero, so that a, v
// and d stay one motion and the ground does not fly off. AfterEnd::coast leaves the acceleration zero and the
// velocity constant instead.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "engine/motion.h"
#include "seismic/measures/integrate.h"

namespace dougong::seismic {

enum class AfterEnd { close, coast };

struct EndOptions {
  AfterEnd after = AfterEnd::close;
  double closing_time =
      1.0;  // s, over which the velocity left over is taken away; long against the blocks' periods
};

class GroundMotion final : public engine::PrescribedMotion {
 public:
  /// Samples in m/s2; without a vertical component the ground does not move vertically. Components of unequal
  /// length are continued with zeros. Throws std::invalid_argument for an interval that is not positive,
  /// fewer than two samples, or a sample that is not finite.
  GroundMotion(std::span<const double> horizontal, std::optional<std::span<const double>> vertical,
               double interval, const EndOptions& end = {});

  engine::MotionSample at(double t) const override;
  double knot_interval() const override { return interval_; }

  double duration() const { return interval_ * static_cast<double>(horizontal_.acceleration.size() - 1); }
  /// At the knots, with the closing pulse.
  const GroundHistory& horizontal() const { return horizontal_; }
  const GroundHistory* vertical() const { return vertical_ ? &*vertical_ : nullptr; }
  std::vector<double> times() const;
  /// Velocity of the record's last sample (m/s), before anything is closed.
  double horizontal_velocity_left() const { return velocity_left_; }
  /// Greatest acceleration of the closing pulse (m/s2), both axes.
  double closing_acceleration() const { return closing_acceleration_; }

 private:
  GroundHistory history(std::span<const double> acceleration, std::size_t samples, const EndOptions& end);

  double interval_;
  double velocity_left_ = 0.0;
  double closing_acceleration_ = 0.0;
  GroundHistory horizontal_;
  std::optional<GroundHistory> vertical_;
};

}  // namespace dougong::seismic
