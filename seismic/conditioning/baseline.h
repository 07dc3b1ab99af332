// Corrections of a drifting baseline by least squares.
//
//   polynomial of acceleration:  a <- a - (c0 + c1 t + ... + cn t^n), fitted to a
//   polynomial of velocity:      v ~ d1 t + ... + dn t^n fitted to the integrated velocity, its derivative
//   taken
//                                off a; no constant term, so that the ground still starts from rest
//   end at rest:                 d <- d - D, D the quintic with D = D' = D'' = 0 at the start and D = d, D' =
//   v,
//                                D'' = 0 at the end: the ground ends where it began, without a jump of a
#pragma once

#include <vector>

namespace dougong::seismic {

inline constexpr int highest_baseline_degree = 6;  // powers of time lose their digits beyond

/// What was taken off an acceleration: the coefficients of 1, t, t^2 ... in m/s2, m/s3 ...; nothing of a
/// record with no more samples than coefficients.
using Baseline = std::vector<double>;

/// Degree 0 (the mean) to highest_baseline_degree.
Baseline remove_acceleration_polynomial(std::vector<double>& acceleration, double interval, int degree);
/// Degree of the velocity, 1 to highest_baseline_degree.
Baseline remove_velocity_polynomial(std::vector<double>& acceleration, double interval, int degree);

struct RestCorrection {
  double velocity = 0.0, displacement = 0.0;  // m/s, m, left at the end before
  double greatest_change = 0.0;               // m/s2
};
/// Exactly, for the integration of the linear interpolant.
RestCorrection end_at_rest(std::vector<double>& acceleration, double interval);

}  // namespace dougong::seismic
