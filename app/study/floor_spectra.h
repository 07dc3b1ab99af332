// What equipment on a floor feels: the response spectrum of the floor's absolute acceleration.
//
// Pseudo-acceleration, 5 % damping (seismic/measures/response_spectrum.h), of the history up to the loss of
// the floor's storey. Histories are known at the output times, so periods begin at ten output intervals:
// below, the samples no longer carry the motion.
#pragma once

#include <string>
#include <vector>

#include "app/study/run_result.h"

namespace dougong::app {

struct FloorSpectrum {
  std::string name;         // of the storey under the floor
  std::vector<double> psa;  // m/s2, at the periods
};

struct FloorSpectra {
  std::vector<double> periods;  // s
  std::vector<double> ground;   // m/s2
  std::vector<FloorSpectrum> floors;
};

/// Without floors where a run has no histories.
FloorSpectra floor_spectra(const RunResult& run);

}  // namespace dougong::app
