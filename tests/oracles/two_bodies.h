// Motion in a central field of inverse square, exactly: relative position and velocity at any time.
//   attracted  r'' = -mu r/r^3, an ellipse: r = a (1 - e cos E),  sqrt(mu/a^3) t = E - e sin E
//   repelled   r'' = +k r/r^3, a hyperbola: r = a (1 + e cosh F), sqrt(k/a^3) t = F + e sinh F
// Danby, Fundamentals of Celestial Mechanics, 2nd ed. (1988), ch. 6; Landau and Lifshitz, Mechanics, par. 15.
#pragma once

#include <cmath>

namespace dougong::oracles {

struct PlaneMotion {
  double x, y, vx, vy;
};

/// t after the passage of periapsis, which lies on the x axis.
inline PlaneMotion ellipse(double mu, double a, double e, double t) {
  const double n = std::sqrt(mu / (a * a * a)), mean = n * t;
  double anomaly = mean + e * std::sin(mean);
  for (int i = 0; i < 50; ++i)
    anomaly -= (anomaly - e * std::sin(anomaly) - mean) / (1.0 - e * std::cos(anomaly));
  const double b = a * std::sqrt(1.0 - e * e), rate = n / (1.0 - e * std::cos(anomaly));
  return {a * (std::cos(anomaly) - e), b * std::sin(anomaly), -a * rate * std::sin(anomaly),
          b * rate * std::cos(anomaly)};
}

class Hyperbola {
 public:
  /// From any state that approaches the centre of repulsion k (m3/s2).
  Hyperbola(double k, const PlaneMotion& start) : k_(k) {
    const double r = std::hypot(start.x, start.y), v2 = start.vx * start.vx + start.vy * start.vy;
    const double momentum = start.x * start.vy - start.y * start.vx, energy = 0.5 * v2 + k / r;
    a_ = 0.5 * k / energy;
    e_ = std::sqrt(1.0 + 2.0 * energy * momentum * momentum / (k * k));
    side_ = momentum > 0.0 ? 1.0 : -1.0;
    const double f = -std::acosh((r / a_ - 1.0) / e_);
    start_ = std::sqrt(a_ * a_ * a_ / k) * (f + e_ * std::sinh(f));
    const PlaneMotion own = in_own_axes(f);
    turn_ = std::atan2(start.y, start.x) - std::atan2(own.y, own.x);
  }
  PlaneMotion at(double t) const {
    const double mean = (start_ + t) / std::sqrt(a_ * a_ * a_ / k_);
    double f = std::asinh(mean / e_);
    for (int i = 0; i < 50; ++i) f -= (f + e_ * std::sinh(f) - mean) / (1.0 + e_ * std::cosh(f));
    const PlaneMotion m = in_own_axes(f);
    const double c = std::cos(turn_), s = std::sin(turn_);
    return {c * m.x - s * m.y, s * m.x + c * m.y, c * m.vx - s * m.vy, s * m.vx + c * m.vy};
  }
  double closest() const { return a_ * (1.0 + e_); }
  /// Angle by which the asymptotes differ (rad).
  double deflection() const { return 2.0 * std::asin(1.0 / e_); }

 private:
  PlaneMotion in_own_axes(double f) const {
    const double b = a_ * std::sqrt(e_ * e_ - 1.0) * side_;
    const double rate = std::sqrt(k_ / (a_ * a_ * a_)) / (1.0 + e_ * std::cosh(f));
    return {a_ * (std::cosh(f) + e_), b * std::sinh(f), a_ * rate * std::sinh(f), b * rate * std::cosh(f)};
  }
  double k_, a_, e_, side_, start_, turn_;
};

/// Time in which two bodies of reduced mass m that repel by k/r^2 part from rest at r0 to r.
inline double time_to_part(double m, double k, double r0, double r) {
  const double u = r / r0;
  return std::sqrt(m * r0 * r0 * r0 / (2.0 * k)) *
         (std::sqrt(u * (u - 1.0)) + std::log(std::sqrt(u) + std::sqrt(u - 1.0)));
}

}  // namespace dougong::oracles
