// Japanese spectra, 5 % damping.
//
// Building Standard Law, Notification 1461 (2000), outcropping engineering bedrock, level 1 (rare):
//     Sa = 0.64 + 6 T (T < 0.16 s); 1.6 (to 0.64 s); 1.024/T m/s2;   level 2 (extremely rare) five times that
//   times the simple ground factor Gs of Notification 1457:
//     type 1: 1.5 to 0.576 s, 0.864/T to 0.64 s, then 1.35
//     types 2, 3: 1.5 to 0.64 s, 1.5 T/0.64 to Tu = 0.64 gv/1.5, then gv = 2.025 (2), 2.7 (3)
// Specifications for Highway Bridges (JRA 2017), level 2, ground types I to III:
//     rising c1 T^p to the plateau, c2, c3/T^q behind it;  type 1 (subduction) p 1/3, q 1; type 2 (inland) p
//     2/3, q 5/3. The branches meet the plateau where they cross it.
// The building law's numbers are widely published, and not seen here in the notification itself.
#pragma once

#include "seismic/design/design_spectrum.h"

namespace dougong::seismic {

struct JapaneseBuilding {
  int level = 2;             // 1 rare, 2 extremely rare
  int ground = 0;            // 1, 2, 3; 0: on the bedrock itself
  double zone_factor = 1.0;  // Z, 0.7 to 1
};
double surface_acceleration(const JapaneseBuilding& spectrum, double period);  // m/s2
/// Throws InputError for a level or ground that there is none of.
DesignSpectrum design_spectrum(const JapaneseBuilding& spectrum);

struct JapaneseBridge {
  int type = 1;    // 1 subduction, 2 inland
  int ground = 1;  // I, II, III as 1, 2, 3
};
double bridge_acceleration(const JapaneseBridge& spectrum, double period);  // m/s2
/// Throws InputError for a type or ground that there is none of.
DesignSpectrum design_spectrum(const JapaneseBridge& spectrum);

}  // namespace dougong::seismic
