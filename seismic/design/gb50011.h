// GB 50011-2010 (2016), 5.1.4 and 5.1.5: the seismic influence coefficient.
//
//   gamma = 0.9 + (0.05 - z)/(0.3 + 6 z)      eta1 = 0.02 + (0.05 - z)/(4 + 32 z) >= 0
//   eta2 = 1 + (0.05 - z)/(0.08 + 1.6 z) >= 0.55                            z  damping ratio
//   alpha = alpha_max [0.45 + (eta2 - 0.45) T/0.1]          T <= 0.1 s      (0.45 at T = 0, not times eta2)
//           eta2 alpha_max                                  to Tg
//           (Tg/T)^gamma eta2 alpha_max                     to 5 Tg
//           [eta2 0.2^gamma - eta1 (T - 5 Tg)] alpha_max    to 6 s; beyond, a study of its own
//   alpha_max by intensity and level (table 5.1.4-1), Tg by site class and group (table 5.1.4-2), 0.05 s
//   longer at the rare level
#pragma once

#include <string>

#include "seismic/design/design_spectrum.h"

namespace dougong::seismic {

struct Gb50011 {
  double alpha_max = 0.16;
  double characteristic_period = 0.40;  // s, Tg
  double damping_ratio = 0.05;
};

/// In g, 0 <= T <= 6 s.
double influence_coefficient(const Gb50011& spectrum, double period);
DesignSpectrum design_spectrum(const Gb50011& spectrum);

struct GbSite {
  std::string intensity = "8";     // "6", "7", "7.5" (0.15 g), "8", "8.5" (0.30 g), "9"
  std::string level = "frequent";  // "frequent", "design", "rare"
  std::string site_class = "II";   // "I0", "I1", "II", "III", "IV"
  int group = 1;                   // 1, 2, 3
  double damping_ratio = 0.05;
};
/// By the standard's tables. Throws InputError for what they do not hold.
Gb50011 gb50011(const GbSite& site);

}  // namespace dougong::seismic
