// A target spectrum by its points, as a hazard service or a user gives it.
#pragma once

#include <string>
#include <vector>

#include "seismic/design/design_spectrum.h"

namespace dougong::seismic {

enum class Interpolation { linear, logarithmic };

struct SpectrumTable {
  std::string name;
  std::vector<double> periods;        // s, ascending
  std::vector<double> accelerations;  // m/s2, positive
};

/// Between the first and the last period. Logarithmic: straight in the logarithms of both; linear from T = 0.
/// Throws InputError for fewer than two points, periods that do not rise or values that are not positive.
DesignSpectrum design_spectrum(SpectrumTable table, Interpolation how = Interpolation::linear,
                               double damping_ratio = 0.05);

}  // namespace dougong::seismic
