// Measures that are integrals or means of a response spectrum.
//
//   Housner   int from 0.1 s to 2.5 s of PSv dT   m     Housner 1952 (at 0 or 20 % damping there; 5 % is
//   usual) ASI       int from 0.1 s to 0.5 s of Sa dT    m/s   Von Thun, Roehm, Scott & Wilson 1988 VSI int
//   from 0.1 s to 2.5 s of Sv dT    m     the same predominant period   T of the greatest Sa     s     over
//   the periods asked for average Sa   exp(mean ln PSa(T_i))            m/s2  Baker & Cornell 2006; Eads,
//   Miranda & Lignos 2015 take
//                                                       T_i evenly spaced from 0.2 T1 to 3 T1
//
// Integrals by the trapezoid over steps of `step` s of the period; peaks of the responses at the samples.
// Some programs put pseudo-values in place of Sa and Sv: spectrum_integral() takes any ordinate.
#pragma once

#include <span>
#include <vector>

#include "seismic/measures/response_spectrum.h"

namespace dougong::seismic {

struct PeriodBand {
  double from, to;  // s
};

/// int of an ordinate of the spectrum dT. `step` is shortened so that it divides the band.
double spectrum_integral(std::span<const double> acceleration, double interval, PeriodBand band,
                         double SpectralPoint::*ordinate, double damping_ratio = 0.05, double step = 0.01);

double housner_intensity(std::span<const double> acceleration, double interval, double damping_ratio = 0.05,
                         double step = 0.01);
double acceleration_spectrum_intensity(std::span<const double> acceleration, double interval,
                                       double damping_ratio = 0.05, double step = 0.01);
double velocity_spectrum_intensity(std::span<const double> acceleration, double interval,
                                   double damping_ratio = 0.05, double step = 0.01);

/// Of the periods given, that of the greatest absolute Sa; 0 for a record of zeros.
double predominant_period(std::span<const double> acceleration, double interval,
                          std::span<const double> periods, double damping_ratio = 0.05);

/// 0 where one of the ordinates is.
double average_spectral_acceleration(std::span<const double> acceleration, double interval,
                                     std::span<const double> periods, double damping_ratio = 0.05);
/// `count` periods evenly spaced from 0.2 T1 to 3 T1.
std::vector<double> average_acceleration_periods(double first_period, std::size_t count = 10);

}  // namespace dougong::seismic
