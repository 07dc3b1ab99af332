// Sums and peaks of a sampled history.
#pragma once

#include <cstddef>
#include <span>

namespace dougong::seismic {

struct Peak {
  double value = 0.0;  // greatest |x|
  double time = 0.0;   // s, of the sample that reaches it first
  std::size_t index = 0;
};

Peak peak(std::span<const double> values, double interval);
double mean(std::span<const double> values);
/// sqrt(mean of x^2 over the samples).
double root_mean_square(std::span<const double> values);

}  // namespace dougong::seismic
