// Corrections of a drifting baseline by least squares.
//
//   line of acceleration:      a <- a - (c0 + c1 t)
//   parabola of velocity:      v ~ c t + d t^2 fitted to the integrated velocity, a <- a - (c + 2 d t);
//                              no constant term, so that the ground still starts from rest
#pragma once

#include <vector>

namespace dougong::seismic {

/// The line taken off an acceleration, m/s2 and m/s3.
struct BaselineLine {
  double offset = 0.0;
  double slope = 0.0;
};

BaselineLine remove_acceleration_line(std::vector<double>& acceleration, double interval);
BaselineLine remove_velocity_parabola(std::vector<double>& acceleration, double interval);

}  // namespace dougong::seismic
