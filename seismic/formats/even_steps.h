// Samples with times of their own, brought to equal steps.
//
// Times are rounded in print, drift against a nominal step, or belong to film that was digitised where the
// trace bends. Cases, told apart by how far the times depart from equal steps:
//
//   within a quarter of a step     the values as they are, at the mean step, or at the plain one (0.005 s)
//                                  when it is within 5e-4 of that
//   but for the first step         the same: recorders print a shorter first step (0, .005, .015 ...)
//   further, but slowly            the same, with a warning: every step is within a quarter of the usual one
//                                  (one in a thousand may be shorter) and the times stray by less than 0.2 %
//                                  of the record, as the marks on a film's margin put them
//   further                        resampled, linear between samples, to the given step or to the largest
//                                  plain one (1, 2 or 5 in its first digit) not above the shortest
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace dougong::seismic {

struct EvenSeries {
  std::vector<double> values;
  double interval = 0.0;              // s
  std::vector<std::string> steps;     // what was done to the values, with numbers
  std::vector<std::string> warnings;  // what was noticed
};

/// Index of the first time that is not above the one before it; nothing when all are.
std::optional<std::size_t> first_time_back(const std::vector<double>& times);

/// times: increasing, at least two, as many as values. Nothing when resampling would make more than twenty
/// times as many samples, and no step was given.
std::optional<EvenSeries> to_even_steps(const std::vector<double>& times, std::vector<double> values,
                                        std::optional<double> interval = std::nullopt);

/// A step of 0.00999999 is 0.01 when that is within `tolerance` (relative) of it: few decimals, or a whole
/// rate.
double plain_interval(double step, double tolerance);

}  // namespace dougong::seismic
