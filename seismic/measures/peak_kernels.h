// The recursion of a response spectrum, many oscillators at once: compiled for several instruction sets, of
// which the machine's best is taken. All give the same bits, since a lane does what a double alone would do
// (no contraction, no reassociation).
//
//   U[k+1] = (uu U + uv V) + (ua a[k] + ub a[k+1]),  V likewise,   U = w^2 u, V = w u', absolute = -(U + 2
//   zeta V)
//
// Every oscillator waits for its own last step, so several vectors of them go side by side.
#pragma once

#include <cstddef>
#include <span>

#include "seismic/measures/oscillator.h"

namespace dougong::seismic {

struct PeakOscillator {
  OscillatorStep step;         // scaled_oscillator_step()
  double twice_damping = 0.0;  // 2 zeta
};

/// Greatest magnitudes at the samples behind the first, from rest; all in m/s2.
struct OscillatorPeaks {
  double displacement = 0.0;  // w^2 |u|: the pseudo-acceleration
  double velocity = 0.0;      // w |u'|
  double acceleration = 0.0;  // absolute
};

struct PeakCall {
  const double* acceleration;
  std::size_t samples;
  const PeakOscillator* oscillators;
  std::size_t count;
  OscillatorPeaks* peaks;  // one for every oscillator
};

struct PeakKernel {
  const char* name;
  void (*all)(const PeakCall& call);
  void (*displacement)(const PeakCall& call);  // leaves the other two zero, and is quicker
};

/// All that this machine can run, the plainest first.
std::span<const PeakKernel> supported_peak_kernels();
const PeakKernel& best_peak_kernel();

// For machines that have these instructions.
PeakKernel avx2_peak_kernel();
PeakKernel avx512_peak_kernel();

}  // namespace dougong::seismic
