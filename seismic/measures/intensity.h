// Measures of how strong and how long a shaking is.
//
//   Arias intensity     I = pi/(2 g) int a^2 dt                       m/s    Arias 1970
//   CAV                 int |a| dt                                    m/s    Reed & Kassawara 1988
//   significant duration  t(p2) - t(p1), p = Husid share of int a^2   s      Trifunac & Brady 1975
//   rms                sqrt(1/T int a^2 dt)                           m/s2
//   bracketed duration  last minus first sample with |a| >= threshold s      Bolt 1973
//   uniform duration    step times the samples with |a| >= threshold  s      Bolt 1973
//   standardised CAV    CAV of the one-second windows that reach 0.025 g  m/s   EPRI TR-100082, 1991;
//                                                              Campbell & Bozorgnia, Earthq. Spectra 26, 2010
//
// int a^2 dt has two definitions for samples: the trapezoid of a^2 (what most programs print; the
// default), and the exact integral of the linear interpolant's square, which is smaller:
// h (a0^2 + a0 a1 + a1^2)/3 for every step. Say which.
#pragma once

#include <span>
#include <vector>

#include "seismic/constants.h"

namespace dougong::seismic {

enum class SquareIntegral { trapezoid, linear_interpolant };

double arias_intensity(std::span<const double> acceleration, double interval,
                       double gravity = standard_gravity, SquareIntegral rule = SquareIntegral::trapezoid);

/// Trapezoid of |a|.
double cumulative_absolute_velocity(std::span<const double> acceleration, double interval);

/// Threshold in m/s2 (0.025 g in the definition), windows of `window` s from the first sample on, the last
/// one as long as the record is. A step that crosses a window's end counts to the one that holds its middle.
double standardised_cav(std::span<const double> acceleration, double interval, double threshold,
                        double window = 1.0);

/// By the trapezoid of a^2 over the whole duration.
double rms_acceleration(std::span<const double> acceleration, double interval);

struct SignificantDuration {
  double start = 0.0, end = 0.0;  // s, by linear interpolation of the Husid curve (trapezoid of a^2)
  double duration() const { return end - start; }
};

/// Between the shares `from` and `to` of int a^2 (0.05 and 0.95 for D5-95). Zero for a record of zeros.
SignificantDuration significant_duration(std::span<const double> acceleration, double interval,
                                         double from = 0.05, double to = 0.95);

/// int a^2 dt up to every sample, over its last value: 0 to 1. Zeros for a record of zeros.
std::vector<double> husid(std::span<const double> acceleration, double interval);

/// Threshold in m/s2. Zero when nothing reaches it.
double uniform_duration(std::span<const double> acceleration, double interval, double threshold);
/// Threshold in m/s2. Zero when nothing reaches it.
double bracketed_duration(std::span<const double> acceleration, double interval, double threshold);

}  // namespace dougong::seismic
