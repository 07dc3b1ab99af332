// Free rocking of a rigid block of half sizes b, h about its corners, without slip or bounce.
//   theta'' = -p^2 sin(alpha - theta),  theta'^2 = 2 p^2 (cos(alpha - theta_0) - cos(alpha - theta))
// p^2 = 3 g / (4 R). An impact keeps the angular momentum about the new corner: the spin falls by the
// factor 1 - 3/2 sin^2(alpha). Housner, Bull. Seism. Soc. Am. 53 (1963) 403-417.
//
// A lintel laid freely on equal columns rocks with them: with gamma its mass over that of the columns the
// frame moves as a block of the same slenderness with
//   p^2 -> p^2 (1 + 2 gamma)/(1 + 3 gamma),   factor -> (1 - 3/2 sin^2 a + 3 gamma cos 2a)/(1 + 3 gamma)
// Makris and Vassiliou, Earthquake Engng Struct. Dyn. 42 (2013) 215-232.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "tests/oracles/quadrature.h"

namespace dougong::oracles {

struct Impact {
  double time, spin_before, amplitude_after;  // s, rad/s, rad
};

struct RockingBlock {
  double b, h, g;
  double lintel = 0.0;                               // gamma
  std::optional<double> restitution = std::nullopt;  // the ratio of the spins at an impact, if measured

  double alpha() const { return std::atan(b / h); }
  double p() const {
    return std::sqrt(0.75 * g / std::hypot(b, h) * (1.0 + 2.0 * lintel) / (1.0 + 3.0 * lintel));
  }
  double velocity_ratio() const {
    const double sine = std::sin(alpha());
    if (restitution) return *restitution;
    return (1.0 - 1.5 * sine * sine + 3.0 * lintel * std::cos(2.0 * alpha())) / (1.0 + 3.0 * lintel);
  }

  double spin_at_impact(double amplitude) const {
    return p() * std::sqrt(2.0 * (std::cos(alpha() - amplitude) - std::cos(alpha())));
  }
  double amplitude_from(double spin) const {
    return alpha() - std::acos(std::cos(alpha()) + 0.5 * spin * spin / (p() * p()));
  }
  /// From rest at the amplitude down to zero; theta = amplitude (1 - u^2).
  double fall_time(double amplitude) const {
    const auto rate = [&](double u) {
      const double fallen = amplitude * u * u, start = alpha() - amplitude;
      // cos(A) - cos(A + x) = 2 sin(A + x/2) sin(x/2), over u^2 as u goes to 0
      const double drop = u == 0.0 ? amplitude * std::sin(start)
                                   : 2.0 * std::sin(start + 0.5 * fallen) * std::sin(0.5 * fallen) / (u * u);
      return 2.0 * amplitude / (p() * std::sqrt(2.0 * drop));
    };
    return integral(rate, 0.0, 1.0);
  }
  /// From rest at eps beyond the balance on a corner to x beyond it, either way:
  ///   x'^2 = 2 p^2 (cos eps - cos x);  with x = eps cosh z the slow start is a straight line in z.
  double time_from_balance(double eps, double turned) const {
    const auto rate = [&](double z) {
      const double x = eps * std::cosh(z);
      const double fallen = 2.0 * std::sin(0.5 * (x + eps)) * std::sin(0.5 * (x - eps));
      return z == 0.0 ? std::sqrt(eps / std::sin(eps)) : eps * std::sinh(z) / std::sqrt(2.0 * fallen);
    };
    return integral(rate, 0.0, std::acosh(turned / eps)) / p();
  }

  std::vector<Impact> impacts(double amplitude, int count) const {
    std::vector<Impact> all;
    double time = fall_time(amplitude);
    for (int i = 0; i < count; ++i) {
      const double spin = spin_at_impact(amplitude);
      amplitude = amplitude_from(velocity_ratio() * spin);
      all.push_back({time, spin, amplitude});
      time += 2.0 * fall_time(amplitude);
    }
    return all;
  }
};

/// A symmetric trapezium, wider at its foot: a drum or a whole tapered column. With R the distance of the
/// centroid from a corner of the foot and I_o the moment of inertia about that corner (per mass),
///   p^2 = g R/I_o,   tan(alpha) = (w/2)/y_c,   ratio 1 - 2 R^2 sin^2(alpha)/I_o
/// as for a rectangle, whose I_o is 4/3 R^2: what keeps the angular momentum about the new corner.
struct TaperedRockingBlock {
  double foot, head, height, g;  // full widths, m

  double centroid() const { return height / 3.0 * (foot + 2.0 * head) / (foot + head); }
  /// Squared radius of gyration about the corner, by strips of the width w(y).
  double corner_inertia() const {
    const auto width = [&](double y) { return foot + (head - foot) * y / height; };
    const auto strip = [&](double y) {
      const double w = width(y);
      return w * (w * w / 12.0 + 0.25 * foot * foot + y * y);
    };
    return integral(strip, 0.0, height) / integral(width, 0.0, height);
  }
  double radius_squared() const { return 0.25 * foot * foot + centroid() * centroid(); }
  double alpha() const { return std::atan(0.5 * foot / centroid()); }
  double p() const { return std::sqrt(g * std::sqrt(radius_squared()) / corner_inertia()); }
  double velocity_ratio() const {
    const double sine = std::sin(alpha());
    return 1.0 - 2.0 * radius_squared() * sine * sine / corner_inertia();
  }
};

}  // namespace dougong::oracles
