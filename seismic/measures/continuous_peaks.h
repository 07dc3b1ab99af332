// Peaks of an oscillator wherever they fall, not only at the samples of the record.
//
// Every step is divided so that w h <= 0.2. In a part the response f (displacement, velocity, absolute
// acceleration) is the cubic through f and f' at both ends, which are exact, and its extremes are the roots
// of a quadratic. The cubic is off by at most max|f''''| h^4/384 (de Boor, A Practical Guide to Splines,
// 2001, ch. IV), (w h)^4/384 = 4.2e-6 of a harmonic's amplitude: the peaks are good to 1e-5.
#pragma once

#include <span>

#include "seismic/measures/oscillator.h"
#include "seismic/measures/peak_kernels.h"

namespace dougong::seismic {

OscillatorPeaks continuous_peaks(std::span<const double> acceleration, double interval,
                                 const Oscillator& oscillator);

}  // namespace dougong::seismic
