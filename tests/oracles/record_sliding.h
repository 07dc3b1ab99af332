// A rigid block that slides on a plane under a ground acceleration that is linear between samples, static =
// kinetic friction (Newmark). With s along the plane, relative to it, and per unit of mass
//     drive D(t) = d0 + d1 a(t),  limit F(t) = mu (n0 + n1 a(t)),  s'' = D - sgn(s') F  or at rest if |D| <=
//     F
// Within a sample interval s'' is linear in t: s' is followed exactly from event to event. Events are
// roots of linear or quadratic functions, found by scanning and bisection.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/oracles/bisection.h"

namespace dougong::oracles {

struct SlidingHistory {
  double last = 0.0, greatest = 0.0, path = 0.0, greatest_speed = 0.0;  // m, m, m, m/s
  double first_slip = -1.0;                                             // s
  int episodes = 0;                                                     // slips from rest to rest
};

struct RecordSlider {
  double d0, d1, n0, n1, friction;

  static RecordSlider on_level_ground(double friction, double g) { return {0.0, -1.0, g, 0.0, friction}; }
  /// Down towards +x, the ground moves horizontally; s > 0 is downhill.
  static RecordSlider on_slope(double slope, double friction, double g) {
    return {g * std::sin(slope), -std::cos(slope), g * std::cos(slope), std::sin(slope), friction};
  }

  SlidingHistory under(const std::vector<double>& samples, double dt) const {
    Follower f{*this, {}};
    const int parts = 20;
    for (std::size_t k = 0; k + 1 < samples.size(); ++k) {
      f.slope = (samples[k + 1] - samples[k]) / dt;
      for (int i = 0; i < parts; ++i)
        f.advance((static_cast<double>(k) + static_cast<double>(i) / parts) * dt,
                  samples[k] + f.slope * i / parts * dt, dt / parts);
    }
    return f.history;
  }

 private:
  struct Follower {
    const RecordSlider& c;
    SlidingHistory history;
    double slope = 0.0;  // m/s3, of the record
    double s = 0.0, v = 0.0;
    int sense = 0;  // of the slip; 0 at rest

    double drive(double a) const { return c.d0 + c.d1 * a; }
    double limit(double a) const { return c.friction * (c.n0 + c.n1 * a); }

    // From t to t + h, the acceleration starting at a: as many events as there are.
    void advance(double t, double a, double h) {
      for (int events = 0; h > 1e-15 && events < 10; ++events) {
        const double passed = sense == 0 ? rest(t, a, h) : slip(a, h);
        t += passed, a += slope * passed, h -= passed;
      }
    }
    // Returns the time at rest; starts to slip if that is less than h.
    double rest(double t, double a, double h) {
      const auto holds = [&](double x) { return std::abs(drive(a + slope * x)) <= limit(a + slope * x); };
      const double until = holds(h) ? h : last_time(holds, 0.0, h).before;
      if (until == h) return h;
      sense = drive(a + slope * until) > 0.0 ? 1 : -1;
      if (history.first_slip < 0.0) history.first_slip = t + until;
      ++history.episodes;
      return until;
    }
    double slip(double a, double h) {
      const double start = drive(a) - sense * limit(a), rate = (c.d1 - sense * c.friction * c.n1) * slope;
      const auto speed = [&](double x) { return v + start * x + 0.5 * rate * x * x; };
      const auto moves = [&](double x) { return sense * speed(x) > 0.0 || x == 0.0; };
      const double until = moves(h) ? h : last_time(moves, 0.0, h).before;
      const double way = v * until + 0.5 * start * until * until + rate * until * until * until / 6.0;
      s += way, v = speed(until);
      history.last = s, history.path += std::abs(way);
      history.greatest = std::max(history.greatest, std::abs(s));
      history.greatest_speed = std::max(history.greatest_speed, std::abs(v));
      if (until < h) v = 0.0, sense = 0;
      return until;
    }
  };
};

}  // namespace dougong::oracles
