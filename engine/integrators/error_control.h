// The size of an adaptive step: a proportional-integral controller on the estimated error.
//
//     h' = h 0.9 e^(-alpha) e_before^beta,   e = estimated error over the tolerated one, accepted when <= 1
//
// alpha and beta are sixty-fourths, so that square roots suffice and every machine takes the same steps.
// Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, 2nd ed. (1993), II.4 and IV.2.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

namespace dougong::engine {

/// What errors are measured by. A turn times its lever is a length.
struct Scales {
  double length = 1.0;            // m
  double speed = 0.0;             // m/s, least
  std::span<const double> lever;  // m/rad or -, for every degree of freedom; empty: 1
};

/// x^(k/64), 0 < k < 64.
inline double power_64th(double x, unsigned k) {
  double result = 1.0;
  for (unsigned bit = 32; bit > 0; bit >>= 1) {
    x = std::sqrt(x);
    if (k & bit) result *= x;
  }
  return result;
}

class StepController {
 public:
  StepController(unsigned alpha, unsigned beta) : alpha_(alpha), beta_(beta) {}

  double after_acceptance(double h, double error) {
    const double e = std::max(error, least_error);
    const double factor = safety / power_64th(e, alpha_) * power_64th(last_error_, beta_);
    last_error_ = e;
    return h * std::clamp(factor, least_factor, greatest_factor);
  }
  double after_rejection(double h, double error) const {
    if (!std::isfinite(error)) return h * least_factor;
    return h * std::clamp(safety / power_64th(error, alpha_), least_factor, safety);
  }
  void restart() { last_error_ = least_error; }

 private:
  static constexpr double safety = 0.9, least_factor = 0.2, greatest_factor = 10.0;
  static constexpr double least_error = 1e-4;
  unsigned alpha_, beta_;
  double last_error_ = least_error;
};

}  // namespace dougong::engine
