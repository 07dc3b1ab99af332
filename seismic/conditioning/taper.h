// Windows at the ends of a history, and zeros around it.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace dougong::seismic {

/// Half cosine from 0 (first sample) to 1 (after `count` samples), and back at the end, in place.
void cosine_taper(std::vector<double>& samples, std::size_t count);

/// `before` zeros in front and `after` behind.
std::vector<double> padded(std::span<const double> samples, std::size_t before, std::size_t after);

/// A smooth step and its first two derivatives: 0 for x <= 0, 1 for x >= 1, three derivatives zero at both
/// ends; 35 x^4 - 84 x^5 + 70 x^6 - 20 x^7 between.
struct SmoothStep {
  double value, slope, curvature;
};
SmoothStep smooth_step(double x);

}  // namespace dougong::seismic
