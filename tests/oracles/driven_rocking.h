// Rocking of a rigid block on a ground that accelerates horizontally, without slip or bounce: integrated by
// RK4 from event to event (uplift, impact, overturning), events found by bisection within a step.
//   theta'' = p^2 (-s sin(alpha - s theta) + a(t)/g cos(alpha - s theta)),  s = +1, -1 the corner it stands
//   on
// theta is anticlockwise: a ground that accelerates to the right tips the block to the left. It uplifts when
// |a| > g tan(alpha); an impact multiplies the spin by Housner's ratio (tests/oracles/rocking.h).
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/oracles/bisection.h"
#include "tests/oracles/rocking.h"

namespace dougong::oracles {

struct RockingHistory {
  bool overturned = false;                                                  // |theta| reached 90 degrees
  double overturning_time = 0.0, uplift_time = -1.0, greatest_angle = 0.0;  // s, s, rad
  int impacts = 0;
  double angle = 0.0, spin = 0.0;  // at the end, rad, rad/s
};

/// A block is what has alpha(), p(), velocity_ratio() and g.
template <class Block, class Acceleration>
class DrivenRocking {
 public:
  /// `a` as a function of time, m/s2; `dt` should divide what is not smooth in it.
  DrivenRocking(const Block& c, Acceleration a, double dt, double angle = 0.0, double spin = 0.0)
      : c_(c), a_(a), dt_(dt), alpha_(c.alpha()), p2_(c.p() * c.p()), now_{angle, spin} {
    side_ = angle + spin == 0.0 ? 0.0 : (angle + spin > 0.0 ? 1.0 : -1.0);
  }

  RockingHistory run(double until) {
    for (long k = 0; static_cast<double>(k) * dt_ < until && !history_.overturned; ++k)
      advance(static_cast<double>(k) * dt_, dt_);
    history_.angle = now_.angle, history_.spin = now_.spin;
    return history_;
  }

 private:
  struct Motion {
    double angle, spin;
  };

  double acceleration(double t, double angle) const {
    const double lean = alpha_ - side_ * angle;
    return p2_ * (-side_ * std::sin(lean) + a_(t) / c_.g * std::cos(lean));
  }
  // RK4. A step sees the ground from its inside only, so that a jump between two steps costs no accuracy.
  Motion after(double t, double h) const {
    const Motion y = now_;
    const double edge = 1e-9 * h;
    const double a1 = acceleration(t + edge, y.angle), v2 = y.spin + 0.5 * h * a1;
    const double a2 = acceleration(t + 0.5 * h, y.angle + 0.5 * h * y.spin), v3 = y.spin + 0.5 * h * a2;
    const double a3 = acceleration(t + 0.5 * h, y.angle + 0.5 * h * v2), v4 = y.spin + h * a3;
    const double a4 = acceleration(t + h - edge, y.angle + h * v3);
    return {y.angle + h / 6.0 * (y.spin + 2.0 * (v2 + v3) + v4),
            y.spin + h / 6.0 * (a1 + 2.0 * (a2 + a3) + a4)};
  }

  void advance(double t, double h) {
    for (int events = 0; h > 1e-14 && events < 20 && !history_.overturned; ++events) {
      const double passed = side_ == 0.0 ? rest(t, h) : rock(t, h);
      t += passed, h -= passed;
    }
  }

  double rest(double t, double h) {
    const double limit = c_.g * std::tan(alpha_);
    const auto stands = [&](double x) { return std::abs(a_(t + x)) <= limit; };
    if (stands(h)) return h;
    const double until = stands(0.0) ? last_time(stands, 0.0, h).after : 0.0;
    side_ = a_(t + until) > 0.0 ? 1.0 : -1.0;
    if (history_.uplift_time < 0.0) history_.uplift_time = t + until;
    return until;
  }

  double rock(double t, double h) {
    Motion next = after(t, h);
    double passed = h;
    if (std::abs(next.angle) >= right_angle) {
      passed = last_time([&](double x) { return std::abs(after(t, x).angle) < right_angle; }, 0.0, h).after;
      history_.overturned = true, history_.overturning_time = t + passed;
    } else if (side_ * next.angle < 0.0) {
      passed = last_time([&](double x) { return side_ * after(t, x).angle > 0.0; }, 0.0, h).after;
      next = impact(after(t, passed));
    }
    now_ = next;
    history_.greatest_angle = std::max(history_.greatest_angle, std::abs(now_.angle));
    return passed;
  }

  // Too slow to leave the ground again: it stands.
  Motion impact(Motion m) {
    ++history_.impacts;
    const double spin = c_.velocity_ratio() * m.spin;
    const bool stands = std::abs(spin) < 1e-6 * c_.p() * alpha_;
    side_ = stands ? 0.0 : (spin > 0.0 ? 1.0 : -1.0);
    return {0.0, stands ? 0.0 : spin};
  }

  static constexpr double right_angle = 0.5 * std::numbers::pi;
  Block c_;
  Acceleration a_;
  double dt_, alpha_, p2_;
  Motion now_;
  double side_;  // 0 while it stands on both corners
  RockingHistory history_;
};

/// A ground pulse of one sine or one cosine, a_p sin or cos(w t), 0 <= t <= 2 pi/w.
struct OneCyclePulse {
  bool sine;
  double amplitude, w;  // m/s2, rad/s

  double duration() const { return 2.0 * std::numbers::pi / w; }
  double acceleration(double t) const {
    return t > duration() ? 0.0 : amplitude * (sine ? std::sin(w * t) : std::cos(w * t));
  }
  double velocity(double t) const {
    return t > duration() ? 0.0 : amplitude / w * (sine ? 1.0 - std::cos(w * t) : std::sin(w * t));
  }
  double displacement(double t) const {
    const double s = std::min(t, duration());
    return amplitude / w * (sine ? s - std::sin(w * s) / w : (1.0 - std::cos(w * s)) / w);
  }
};

}  // namespace dougong::oracles
