// A block that tips about a sharp edge under its own weight, from rest, without slip. Its centre of
// mass is d beyond the edge and h above it. From the energy, I_e = m (b^2 + h^2)/3 + m (d^2 + h^2):
//   I_e theta'^2 / 2 = m g (d sin(theta) + h (1 - cos(theta)))
#pragma once

#include <cmath>

#include "tests/oracles/quadrature.h"

namespace dougong::oracles {

struct Ledge {
  double b, h, d, g;

  double spin(double angle) const {
    const double inertia_over_mass = (b * b + h * h) / 3.0 + d * d + h * h;
    return std::sqrt(2.0 * g * (d * std::sin(angle) + h * (1.0 - std::cos(angle))) / inertia_over_mass);
  }
  /// dt = d theta / theta', with theta = u^2 to take the singular start out.
  double time_to(double angle) const {
    const auto rate = [this](double u) {
      const double start = std::sqrt(2.0 * g * d / ((b * b + h * h) / 3.0 + d * d + h * h));
      return u == 0.0 ? 2.0 / start : 2.0 * u / spin(u * u);
    };
    return integral(rate, 0.0, std::sqrt(angle));
  }
};

}  // namespace dougong::oracles
