// ASCE 7-16, 11.4: the design response spectrum, 5 % damping.
//
//   T0 = 0.2 SD1/SDS,  TS = SD1/SDS
//   Sa = SDS (0.4 + 0.6 T/T0)   T < T0;    SDS   to TS;    SD1/T   to TL;    SD1 TL/T^2   beyond
//   SMS = Fa SS, SM1 = Fv S1, SDS = 2/3 SMS, SD1 = 2/3 SM1
//
// Fa and Fv of tables 11.4-1 and 11.4-2, linear in SS and S1. Where 11.4.8 asks for a study of the site
// (class E with SS >= 1 or S1 >= 0.2) there is no value. Class D with S1 >= 0.2 needs one too, with
// exceptions: the value is given and the caller told (needs_site_study).
#pragma once

#include <string>

#include "seismic/design/design_spectrum.h"

namespace dougong::seismic {

/// In g and s.
struct Asce7 {
  double sds = 1.0, sd1 = 0.6, long_period = 8.0;
};

/// In g.
double design_acceleration(const Asce7& spectrum, double period);
DesignSpectrum design_spectrum(const Asce7& spectrum);

/// From mapped SS and S1 (g) and site class "A" to "E". Throws InputError.
Asce7 asce7_16(double ss, double s1, const std::string& site_class, double long_period);
bool needs_site_study(double s1, const std::string& site_class);

}  // namespace dougong::seismic
