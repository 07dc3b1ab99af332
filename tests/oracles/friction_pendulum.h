// A friction pendulum (sliding isolation bearing of radius R) under a rigid deck:
//   u'' + (g/R) u + mu g sgn(u') = -a(t),   at rest while |a + (g/R) u| <= mu g
// RK4 from event to event: starts and stops of slip are found by bisection. The ground's acceleration is
// smooth within a step.
#pragma once

#include <algorithm>
#include <cmath>

#include "tests/oracles/bisection.h"
#include "tests/oracles/record_sliding.h"

namespace dougong::oracles {

template <class Acceleration>
class FrictionPendulum {
 public:
  FrictionPendulum(double radius, double friction, double g, Acceleration a)
      : stiffness_(g / radius), limit_(friction * g), a_(a) {}

  SlidingHistory run(double until, double dt) {
    for (long k = 0; static_cast<double>(k) * dt < until; ++k) {
      double t = static_cast<double>(k) * dt, h = dt;
      for (int events = 0; h > 1e-14 && events < 10; ++events) {
        const double passed = sense_ == 0 ? rest(t, h) : slip(t, h);
        t += passed, h -= passed;
      }
    }
    return history_;
  }

 private:
  struct Motion {
    double u, v;
  };

  double drive(double t, double u) const { return -a_(t) - stiffness_ * u; }
  Motion after(double t, double h) const {
    const auto rate = [&](double x, Motion m) { return Motion{m.v, drive(t + x, m.u) - sense_ * limit_}; };
    const auto moved = [&](Motion r, double x) { return Motion{now_.u + x * r.u, now_.v + x * r.v}; };
    const Motion k1 = rate(0.0, now_), k2 = rate(0.5 * h, moved(k1, 0.5 * h)),
                 k3 = rate(0.5 * h, moved(k2, 0.5 * h)), k4 = rate(h, moved(k3, h));
    return moved({(k1.u + 2 * (k2.u + k3.u) + k4.u) / 6.0, (k1.v + 2 * (k2.v + k3.v) + k4.v) / 6.0}, h);
  }

  double rest(double t, double h) {
    const auto holds = [&](double x) { return std::abs(drive(t + x, now_.u)) <= limit_; };
    if (holds(h)) return h;
    const double until = last_time(holds, 0.0, h).before;
    sense_ = drive(t + h, now_.u) > 0.0 ? 1.0 : -1.0;
    if (history_.first_slip < 0.0) history_.first_slip = t + until;
    ++history_.episodes;
    return until;
  }
  double slip(double t, double h) {
    const auto moves = [&](double x) { return x == 0.0 || sense_ * after(t, x).v > 0.0; };
    const double until = moves(h) ? h : last_time(moves, 0.0, h).before;
    const Motion next = after(t, until);
    history_.path += std::abs(next.u - now_.u);
    now_ = next;
    history_.last = now_.u, history_.greatest = std::max(history_.greatest, std::abs(now_.u));
    history_.greatest_speed = std::max(history_.greatest_speed, std::abs(now_.v));
    if (until < h) turn(t + until);
    return until;
  }
  // At the end of a slip it rests, or goes back at once.
  void turn(double t) {
    now_.v = 0.0;
    const double d = drive(t, now_.u);
    sense_ = std::abs(d) <= limit_ ? 0.0 : (d > 0.0 ? 1.0 : -1.0);
  }

  double stiffness_, limit_;
  Acceleration a_;
  Motion now_{0.0, 0.0};
  double sense_ = 0.0;
  SlidingHistory history_;
};

}  // namespace dougong::oracles
