// SYN(seed, A): an analytic accelerogram, 48 cosines of random phase under an envelope. Any step samples
// the same motion; between samples a record is linear.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace dougong::oracles {

class SyntheticMotion {
 public:
  SyntheticMotion(std::uint32_t seed, double amplitude) : amplitude_(amplitude) {
    std::uint32_t x = seed;
    double sum = 0.0;
    for (int i = 0; i < 48; ++i) {
      x = 1664525u * x + 1013904223u;
      const double f = 0.1 * std::pow(200.0, i / 47.0), r2 = std::pow(f / 2.5, 2), low = std::pow(f / 0.3, 2);
      const double c =
          std::sqrt(f * (1.0 + 1.44 * r2) / (std::pow(1.0 - r2, 2) + 1.44 * r2)) * low / (1.0 + low);
      waves_.push_back({2.0 * std::numbers::pi * f, c, 2.0 * std::numbers::pi * (x / 4294967296.0)});
      sum += c * c;
    }
    for (Wave& wave : waves_) wave.weight /= std::sqrt(0.5 * sum);
  }

  double at(double t) const {
    double sum = 0.0;
    for (const Wave& w : waves_) sum += w.weight * std::cos(w.frequency * t + w.phase);
    return amplitude_ * std::pow(t / 6.0 * std::exp(1.0 - t / 6.0), 3) * sum;
  }
  std::vector<double> samples(double dt, double duration = 40.0) const {
    std::vector<double> all;
    const auto last = static_cast<std::size_t>(std::llround(duration / dt));
    for (std::size_t k = 0; k <= last; ++k) all.push_back(at(static_cast<double>(k) * dt));
    return all;
  }

 private:
  struct Wave {
    double frequency, weight, phase;
  };
  double amplitude_;
  std::vector<Wave> waves_;
};

/// Linear between samples, zero outside of them.
inline double interpolated(const std::vector<double>& samples, double dt, double t) {
  const double place = t / dt;
  const auto k = static_cast<std::size_t>(std::max(0.0, place));
  if (place < 0.0 || k + 1 >= samples.size()) return 0.0;
  return samples[k] + (place - static_cast<double>(k)) * (samples[k + 1] - samples[k]);
}

}  // namespace dougong::oracles
