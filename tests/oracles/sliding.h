// A rigid block that slides on level ground under a horizontal ground acceleration. Newmark,
// Geotechnique 15 (1965) 139-160. Relative to the ground: u'' = -a - mu g sgn(u') while it slides,
// u'' = 0 while it sticks and |a| <= mu g.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/oracles/bisection.h"

namespace dougong::oracles {

/// One slip: its ends (s), its sense and the displacement relative to the ground at its start (m).
struct Slip {
  double start, end, sense, place;
};

/// Ground acceleration A sin(w t + phase): every slip is followed exactly from its start to the instant at
/// which the speeds are equal again, found by bisection.
class HarmonicSlider {
 public:
  HarmonicSlider(double amplitude, double w, double friction_acceleration, double until, double phase = 0.0)
      : amplitude_(amplitude), w_(w), limit_(friction_acceleration), phase_(phase) {
    double place = 0.0;
    for (Slip s = next_slip(0.0); s.start < until; s = next_slip(s.end)) {
      s.end = std::min(until, end_of_slip(s.start, s.sense));
      s.place = place;
      place += travel(s.start, s.end, s.sense);
      slips_.push_back(s);
    }
  }

  double first_slip() const { return slips_.front().start; }
  const std::vector<Slip>& slips() const { return slips_; }
  /// Greatest speed of a slip: where the ground's acceleration has fallen to what friction can give.
  double peak_speed(const Slip& s) const {
    const auto gains = [&](double t) { return -s.sense * ground(t) > limit_; };
    const double dt = 1e-3 / w_;
    double t = s.start + dt;
    while (gains(t + dt)) t += dt;
    return std::abs(speed(s.start, last_time(gains, t, t + dt).after, s.sense));
  }
  double displacement(double t) const {
    double u = 0.0;
    for (const Slip& s : slips_)
      if (s.start < t) u = s.place + travel(s.start, std::min(t, s.end), s.sense);
    return u;
  }
  /// Distance rubbed in all, and greatest less least displacement: each slip goes one way only.
  double path() const {
    double sum = 0.0;
    for (const Slip& s : slips_) sum += std::abs(travel(s.start, s.end, s.sense));
    return sum;
  }
  double range() const {
    double low = 0.0, high = 0.0;
    for (const Slip& s : slips_) {
      const double u = s.place + travel(s.start, s.end, s.sense);
      low = std::min(low, u), high = std::max(high, u);
    }
    return high - low;
  }

 private:
  double ground(double t) const { return amplitude_ * std::sin(w_ * t + phase_); }
  double cosine(double t) const { return std::cos(w_ * t + phase_); }
  double speed(double start, double t, double sense) const {
    return amplitude_ / w_ * (cosine(t) - cosine(start)) - sense * limit_ * (t - start);
  }
  double travel(double start, double t, double sense) const {
    const double d = t - start;
    return ((ground(t) - ground(start)) / w_ - amplitude_ * cosine(start) * d) / w_ -
           0.5 * sense * limit_ * d * d;
  }
  double end_of_slip(double start, double sense) const {
    const auto moves = [&](double t) { return sense * speed(start, t, sense) > 0.0; };
    const double dt = 1e-3 / w_;
    double t = start + 10.0 * dt;
    while (moves(t + dt)) t += dt;
    return last_time(moves, t, t + dt).after;
  }
  /// The block slips at once if the ground outruns the friction, else when it next does.
  Slip next_slip(double from) const {
    const auto sticks = [&](double t) { return std::abs(ground(t)) <= limit_; };
    const double dt = 1e-3 / w_;
    double t = from;
    while (sticks(t)) t += dt;
    const double sense = ground(t) > 0.0 ? -1.0 : 1.0;
    return {t == from ? from : last_time(sticks, t - dt, t).after, 0.0, sense, 0.0};
  }

  double amplitude_, w_, limit_, phase_;
  std::vector<Slip> slips_;
};

/// Ground acceleration `amplitude` for `duration`, then none.
struct PulseSlider {
  double amplitude, duration, friction_acceleration;

  double ground_speed() const { return amplitude * duration; }
  double slid() const {
    return ground_speed() * ground_speed() / (2.0 * friction_acceleration) *
           (1.0 - friction_acceleration / amplitude);
  }
  double stops_at() const { return ground_speed() / friction_acceleration; }
};

}  // namespace dougong::oracles
