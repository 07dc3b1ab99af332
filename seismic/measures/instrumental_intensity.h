// Intensity scales that are computed from a recording.
//
// JMA (Japan Meteorological Agency, notice of 1996): the three components, mean removed, in gal, filtered by
//     sqrt(1/f) (1 + .694 x^2 + .241 x^4 + .0557 x^6 + .009664 x^8 + .00134 x^10 + .000155 x^12)^(-1/2)
//     (1 - exp(-(f/.5)^3))^(1/2),  x = f/10
//   a0 the level that their vector sum reaches for 0.3 s in all;  I = 2 lg a0 + 0.94, rounded to two
//   decimals, then cut to one. Classes 0 to 4, 5-, 5+, 6-, 6+, 7.
// GB/T 17742-2020 (China): I_A = 3.17 lg PGA + 6.59, I_V = 3.00 lg PGV + 9.77 (m/s2, m/s); I_V where both
// reach
//   6, else their mean; 1 to 12. PGA and PGV of the vector sum of three components, 0.1-10 Hz.
// MMI (Worden, Gerstenberger, Rhoades & Wald, BSSA 102, 2012; California): 1.78 + 1.55 lg PGA below lg 1.57,
//   -1.60 + 3.70 lg PGA above (gal); 3.78 + 1.47 lg PGV to lg 0.53, 2.89 + 3.16 lg PGV above (cm/s).
#pragma once

#include <span>
#include <string>
#include <vector>

namespace dougong::seismic {

/// Components of one length, m/s2. A missing one may be left out: the level is then lower.
using Components = std::vector<std::vector<double>>;

double jma_filter_gain(double frequency);  // Hz

struct JmaIntensity {
  double level = 0.0;     // a0, m/s2 (filtered)
  double value = 0.0;     // before rounding; -infinity for a record of zeros
  double reported = 0.0;  // one decimal
  std::string scale;      // "5-"
};
JmaIntensity jma_intensity(const Components& components, double interval);
std::string jma_class(double intensity);

struct ChinaIntensity {
  double pga = 0.0, pgv = 0.0;                                   // of the vector sum, band-passed; m/s2, m/s
  double by_acceleration = 0.0, by_velocity = 0.0, value = 0.0;  // value within 1 to 12
};
/// By the two peaks, m/s2 and m/s.
ChinaIntensity china_intensity(double pga, double pgv);
/// Of a recording: mean removed, Butterworth of order 4, 0.1-10 Hz (10 Hz left out where it is above 0.9 of
/// the Nyquist frequency), forward and backward over zeros.
ChinaIntensity china_intensity(const Components& components, double interval);

double mmi_by_acceleration(double pga);  // m/s2
double mmi_by_velocity(double pgv);      // m/s

}  // namespace dougong::seismic
