// Eurocode 8, EN 1998-1:2004, 3.2.2.2 and 3.2.2.3: elastic response spectra, recommended values.
//
//   eta = sqrt(10/(5 + xi)) >= 0.55,  xi damping in %
//   Se = ag S [1 + T/TB (2.5 eta - 1)]     T <= TB
//        2.5 ag S eta                      to TC
//        2.5 ag S eta TC/T                 to TD
//        2.5 ag S eta TC TD/T^2            to 4 s
//   vertical: 3.0 for 2.5, avg for ag, no S
// National annexes change S, TB, TC and TD: they are members.
#pragma once

#include <string>

#include "seismic/design/design_spectrum.h"

namespace dougong::seismic {

struct Eurocode8 {
  double ground_acceleration = 1.0;                  // m/s2, ag = gamma_I agR (avg for a vertical spectrum)
  double soil = 1.0, tb = 0.15, tc = 0.4, td = 2.0;  // S; s
  double damping_ratio = 0.05;
  double plateau = 2.5;  // over ag S; 3.0 vertical
  std::string title = "Eurocode 8";
};

/// m/s2, 0 <= T <= 4 s.
double elastic_spectrum(const Eurocode8& spectrum, double period);
DesignSpectrum design_spectrum(const Eurocode8& spectrum);

/// Type 1 or 2, ground "A" to "E", by tables 3.2 and 3.3. Throws InputError.
Eurocode8 eurocode8(int type, const std::string& ground, double ground_acceleration,
                    double damping_ratio = 0.05);
/// Table 3.4: avg = 0.90 (type 1) or 0.45 (type 2) times ag, the horizontal one. Throws InputError.
Eurocode8 eurocode8_vertical(int type, double horizontal_ground_acceleration, double damping_ratio = 0.05);

}  // namespace dougong::seismic
