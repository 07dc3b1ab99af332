// Elastic response spectrum: the peaks of oscillators of every period on the same ground.
//
//   Sd  peak |u| (m)       Sv  peak |u'| (m/s)       Sa  peak |u'' + a| (m/s2)
//   PSv = w Sd             PSa = w^2 Sd              (Sa and PSa differ by the damping)
//
// Responses are exact for the linear interpolant of the record (oscillator.h). Peaks are taken at the
// samples, as most programs do; at a finer division of every step; or wherever they fall
// (continuous_peaks.h). Between samples a response of period T can rise above its greatest sample by (w
// h)^2/8 of it, 1.2 % at T = 20 h and 5 % at T = 10 h: short periods need the finer search.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "seismic/measures/oscillator.h"

namespace dougong::seismic {

struct SpectralPoint {
  double period = 0.0;               // s
  double displacement = 0.0;         // Sd
  double velocity = 0.0;             // Sv
  double acceleration = 0.0;         // Sa
  double pseudo_velocity = 0.0;      // PSv
  double pseudo_acceleration = 0.0;  // PSa
};

struct SpectrumOptions {
  double damping_ratio = 0.05;  // the usual reference
  int subdivisions = 1;         // of every step when looking for peaks at the ends of its parts
  bool within_steps = false;    // peaks wherever they fall, instead of subdivisions
};

SpectralPoint spectral_point(std::span<const double> acceleration, double interval, double period,
                             const SpectrumOptions& options = {});

std::vector<SpectralPoint> response_spectrum(std::span<const double> acceleration, double interval,
                                             std::span<const double> periods,
                                             const SpectrumOptions& options = {});

/// PSa (m/s2) alone, at the samples: the same bits, in less time.
std::vector<double> pseudo_accelerations(std::span<const double> acceleration, double interval,
                                         std::span<const double> periods, double damping_ratio = 0.05);

/// `count` periods from `from` to `to`, equally spaced in the logarithm. 121 from 0.02 s to 10 s by
/// default: about 45 a decade.
std::vector<double> log_spaced_periods(double from = 0.02, double to = 10.0, std::size_t count = 121);

/// What a reader of the spectrum must know: periods shorter than 10 steps of the record, where the linear
/// interpolant no longer carries the motion, and a record too coarse for the periods asked for.
std::vector<std::string> spectrum_warnings(std::span<const double> periods, double interval);

}  // namespace dougong::seismic
