// The same motion at another step.
//
// fft: the trigonometric polynomial through the samples, evaluated at the new ones; any ratio of steps,
//   also one that is not rational. The record is continued at both ends by its odd reflection, faded to
//   zero, so that the period of the transform has no jump to ring from (wrap-around). A longer step drops
//   the frequencies above its own Nyquist frequency. Exact for a motion without energy above Nyquist.
// spline: on the natural cubic spline through the samples; a longer step aliases.
// linear: on the straight line between samples, which is what the ground does in between; it damps the
//   high frequencies and, to a longer step, aliases.
#pragma once

#include <span>
#include <vector>

namespace dougong::seismic {

enum class ResampleMethod { fft, spline, linear };

/// From the first sample to the last that lies within the old duration.
std::vector<double> resample(std::span<const double> samples, double interval, double new_interval,
                             ResampleMethod method = ResampleMethod::fft);

}  // namespace dougong::seismic
