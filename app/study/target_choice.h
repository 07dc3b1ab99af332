// A target spectrum in words: "ec8: type=1, ground=C, ag=0.25 g".
//
//   gb50011        intensity, level, site, group, damping; or alpha-max, tg, damping
//   ec8            type, ground, ag, damping
//   ec8-vertical   type, ag, damping (ag the horizontal one)
//   asce7          sds, sd1, tl (in g, g, s); or ss, s1, site, tl
//   japan          level, ground, zone
//   jra            type, ground
//   table          file, unit, interpolation, damping: two columns, period (s) and acceleration
#pragma once

#include <string>

#include "seismic/design/design_spectrum.h"

namespace dougong::app {

/// `where`: the option or key that the text is of, for errors. Throws ScenarioError or seismic::InputError.
seismic::DesignSpectrum target_spectrum(const std::string& text, const std::string& where = "--target");
/// One line for every kind, for the help.
std::string target_help();

}  // namespace dougong::app
