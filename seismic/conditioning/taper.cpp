#include "seismic/conditioning/taper.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dougong::seismic {

void cosine_taper(std::vector<double>& samples, std::size_t count) {
  count = std::min(count, samples.size() / 2);
  for (std::size_t k = 0; k < count; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(count);
    const double weight = 0.5 * (1.0 - std::cos(std::numbers::pi * share));
    samples[k] *= weight;
    samples[samples.size() - 1 - k] *= weight;
  }
}

std::vector<double> padded(std::span<const double> samples, std::size_t before, std::size_t after) {
  std::vector<double> out(before + samples.size() + after, 0.0);
  std::copy(samples.begin(), samples.end(), out.begin() + static_cast<std::ptrdiff_t>(before));
  return out;
}

SmoothStep smooth_step(double x) {
  if (x <= 0.0) return {0.0, 0.0, 0.0};
  if (x >= 1.0) return {1.0, 0.0, 0.0};
  const double x2 = x * x, x3 = x2 * x, y = 1.0 - x;
  return {x2 * x2 * (35.0 - 84.0 * x + 70.0 * x2 - 20.0 * x3), 140.0 * x3 * y * y * y,
          420.0 * x2 * y * y * (1.0 - 2.0 * x)};
}

}  // namespace dougong::seismic
