#include "engine/material.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace dougong::engine {

// e = exp(-z s), z = xi / sqrt|1 - xi^2|, s the dimensionless time at which the force reaches zero.
double restitution_for_damping_ratio(double xi) {
  if (!(xi >= 0.0)) throw std::invalid_argument("damping ratio must not be negative");
  if (xi == 0.0) return 1.0;
  if (std::abs(xi - 1.0) < 1e-9) return std::exp(-2.0);
  if (xi > 1.0) {
    const double w = std::sqrt(xi * xi - 1.0);
    return std::exp(-(xi / w) * std::log((xi + w) / (xi - w)));
  }
  const double w = std::sqrt(1.0 - xi * xi);
  const double quarter = std::atan2(2.0 * xi * w, 1.0 - 2.0 * xi * xi);
  return std::exp(-(xi / w) * (std::numbers::pi - quarter));
}

// restitution_for_damping_ratio falls monotonically, so bisection on log xi cannot miss.
double damping_ratio_for_restitution(double restitution) {
  if (!(restitution > 0.0 && restitution <= 1.0))
    throw std::invalid_argument(
        "restitution must lie in (0, 1]; a plastic impact is a damping ratio of 1 or more");
  if (restitution == 1.0) return 0.0;
  double low = 1e-12, high = 1e12;
  for (int i = 0; i < 200; ++i) {
    const double middle = std::sqrt(low * high);
    (restitution_for_damping_ratio(middle) > restitution ? low : high) = middle;
  }
  return std::sqrt(low * high);
}

}  // namespace dougong::engine
