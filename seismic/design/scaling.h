// Factors that bring records near a target spectrum over a band of periods.
//
//   mean log        s = exp(mean ln(t_i/p_i)): the mean of the logarithms meets the target
//   least squares   s = sum(t_i p_i)/sum(p_i^2): least sum of (s p_i - t_i)^2
//   never below     s = max(t_i/p_i): nowhere under the target
//   misfit          sqrt(mean (ln(s p_i/t_i))^2) of a scaled record, and of the mean of a suite
//
//   p  PSa of the record at the periods of the band      t  that of the target
//
// A suite: every record by its own factor, then all by a common one, so that the mean of the scaled spectra
// is nowhere below `floor` times the target (0.9 in EN 1998-1, 3.2.3.1.2) or, with no floor, left as it is.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace dougong::seismic {

enum class ScalingRule { mean_log, least_squares, never_below };

/// Throws std::invalid_argument for a spectrum that is zero at one of the periods.
double scale_factor(std::span<const double> spectrum, std::span<const double> target, ScalingRule rule);

double spectrum_misfit(std::span<const double> spectrum, std::span<const double> target, double factor);

struct SuiteScaling {
  std::vector<double> factors;  // of every record, the common one in it
  std::vector<double> misfits;  // of every record
  double common_factor = 1.0;
  std::vector<double> mean;  // of the scaled spectra, arithmetic
  double mean_misfit = 0.0;
  double least_ratio = 0.0;  // of that mean over the target
};
SuiteScaling scale_suite(const std::vector<std::vector<double>>& spectra, std::span<const double> target,
                         ScalingRule rule, std::optional<double> floor = {});

}  // namespace dougong::seismic
