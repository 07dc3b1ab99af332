// The plots of one record, or of several against a target: for `dougong record`.
#pragma once

#include <string>
#include <vector>

#include "app/report/gnuplot.h"
#include "seismic/measures/integrate.h"

namespace dougong::app {

/// A curve of a logarithmic plot.
struct SpectrumCurve {
  std::string label;  // at its right end; empty for none
  std::vector<double> x, y;
  bool target = false;  // dashed and black
  bool faint = false;   // one of many
};

struct RecordSheet {
  std::string title, subtitle;
  seismic::GroundHistory history;  // m/s2, m/s, m; multiples of the peak when dimensionless
  bool dimensionless = false;
  double rise_start = 0.0, rise_end = 0.0;  // s, of D5-95
  std::string arias;                        // "1.80 m/s": what the Husid curve rises to
  double damping_ratio = 0.05;
  SpectrumCurve spectrum;  // s, m/s2
  SpectrumCurve fourier;   // Hz, m/s
};

/// Acceleration, velocity, displacement and Husid curve over one time axis, response and Fourier spectra
/// below.
Figure record_figure(const RecordSheet& sheet);

struct BeforeAfter {
  std::string title, subtitle;
  seismic::GroundHistory before, after;
  double lead = 0.0;  // s that the motion after starts earlier
};
/// Acceleration, velocity and displacement as read (grey) and as conditioned.
Figure conditioning_figure(const BeforeAfter& motions);

/// PSa (m/s2, drawn in g) against period.
Figure spectra_figure(const std::string& title, const std::string& subtitle,
                      const std::vector<SpectrumCurve>& curves, double band_from = 0.0, double band_to = 0.0);

}  // namespace dougong::app
