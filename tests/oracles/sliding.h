// A rigid block that slides on level ground under a horizontal ground acceleration. Newmark,
// Geotechnique 15 (1965) 139-160. Relative to the ground: u'' = -a - mu g sgn(u') while it slides,
// u'' = 0 while it sticks and |a| <= mu g.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

namespace dougong::oracles {

/// Ground acceleration A sin(w t): every slip is followed exactly from its start to the instant at
/// which the speeds are equal again, found by bisection.
class HarmonicSlider {
 public:
  HarmonicSlider(double amplitude, double w, double friction_acceleration)
      : amplitude_(amplitude), w_(w), limit_(friction_acceleration) {}

  double first_slip() const { return std::asin(limit_ / amplitude_) / w_; }

  /// Displacement relative to the ground at time t, and the ends of every slip up to then.
  double displacement(double t) const {
    double start = first_slip(), place = 0.0;
    double sense = -1.0;  // of the slip: against the ground's acceleration
    while (start < t) {
      const double end = end_of_slip(start, sense);
      if (end >= t) return place + travel(start, t, sense);
      place += travel(start, end, sense);
      start = next_slip(end, sense);
    }
    return place;
  }

 private:
  double ground(double t) const { return amplitude_ * std::sin(w_ * t); }
  double speed(double start, double t, double sense) const {
    return amplitude_ / w_ * (std::cos(w_ * t) - std::cos(w_ * start)) - sense * limit_ * (t - start);
  }
  double travel(double start, double t, double sense) const {
    const double d = t - start;
    return amplitude_ / w_ * ((std::sin(w_ * t) - std::sin(w_ * start)) / w_ - std::cos(w_ * start) * d) -
           0.5 * sense * limit_ * d * d;
  }
  double end_of_slip(double start, double sense) const {
    const double dt = 1e-4 / w_;
    double t = start + 100.0 * dt;
    while (sense * speed(start, t + dt, sense) > 0.0) t += dt;
    double low = t, high = t + dt;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (sense * speed(start, middle, sense) > 0.0 ? low : high) = middle;
    }
    return low;
  }
  /// The block slips at once if the ground outruns the friction, else when it next does.
  double next_slip(double end, double& sense) const {
    const double dt = 1e-4 / w_;
    double t = end;
    while (std::abs(ground(t)) <= limit_) t += dt;
    sense = ground(t) > 0.0 ? -1.0 : 1.0;
    if (t == end) return end;
    double low = t - dt, high = t;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (std::abs(ground(middle)) <= limit_ ? low : high) = middle;
    }
    return high;
  }

  double amplitude_, w_, limit_;
};

/// Ground acceleration `amplitude` for `duration`, then none.
struct PulseSlider {
  double amplitude, duration, friction_acceleration;

  double ground_speed() const { return amplitude * duration; }
  double slid() const {
    return ground_speed() * ground_speed() / (2.0 * friction_acceleration) * (1.0 - friction_acceleration / amplitude);
  }
  double stops_at() const { return ground_speed() / friction_acceleration; }
};

}  // namespace dougong::oracles
