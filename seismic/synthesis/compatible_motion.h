// An artificial motion whose response spectrum follows a target.
//
// Gaussian noise under a window of Saragoni & Hart, its Fourier amplitudes multiplied, round by round, by the
// ratio of the target to the PSa of the last round at T = 1/f (Gasparini & Vanmarcke, SIMQKE, MIT 1976); the
// phases stay, and with them the course of the shaking. Below the band's lowest frequency amplitudes fall as
// f^4, above its highest they keep the ratio of its end. Every round ends at rest (baseline.h). The round
// with the least misfit, sqrt(mean ln^2(PSa/target)) over the band, is the motion: it is measured after all
// corrections.
#pragma once

#include <cstdint>
#include <vector>

#include "seismic/design/design_spectrum.h"

namespace dougong::seismic {

struct CompatibleOptions {
  double shortest_period = 0.05, longest_period = 4.0;  // s, the band that is met
  double duration = 25.0;                               // s, at which 5 % of the window is left
  double interval = 0.01;                               // s
  int rounds = 40;
  std::uint64_t seed = 1;
};

struct CompatibleMotion {
  std::vector<double> acceleration;  // m/s2
  double misfit = 0.0;
  double least_ratio = 0.0, greatest_ratio = 0.0;  // of PSa over target in the band
};

/// The target's own damping. Throws InputError for a band that it does not cover.
CompatibleMotion compatible_motion(const DesignSpectrum& target, const CompatibleOptions& options);

}  // namespace dougong::seismic
