// Measures of a horizontal pair that do not depend on how the sensor stood.
//
//   x(t, theta) = x1(t) cos theta + x2(t) sin theta,   theta = 0, 1, ... 179 degrees
//   RotDpp = the pp-th percentile over theta of max_t |x|: 00 the least, 50 the median (the mean of the two
//            middle values), 100 the greatest
//
// x is the relative displacement of the oscillator (times w^2: pseudo-acceleration) or the ground's
// acceleration itself. Peaks at the samples. Source: Boore, BSSA 100 (2010) 1830-1835.
#pragma once

#include <span>
#include <vector>

namespace dougong::seismic {

struct RotatedPeaks {
  double rotd00 = 0.0, rotd50 = 0.0, rotd100 = 0.0;
  double angle100 = 0.0;             // degrees from the first component towards the second, of RotD100
  double first = 0.0, second = 0.0;  // peaks of the components as they are
  double geometric_mean = 0.0;       // of those two
};

/// Of two histories of the same length, in their unit.
RotatedPeaks rotated_peaks(std::span<const double> first, std::span<const double> second);

/// PSa (m/s2) at every period.
std::vector<RotatedPeaks> rotated_spectrum(std::span<const double> first, std::span<const double> second,
                                           double interval, std::span<const double> periods,
                                           double damping_ratio = 0.05);

/// The component at `angle` degrees from the first towards the second.
std::vector<double> rotated(std::span<const double> first, std::span<const double> second, double angle);

}  // namespace dougong::seismic
