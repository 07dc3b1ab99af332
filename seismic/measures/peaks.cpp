#include "seismic/measures/peaks.h"

#include <cmath>

namespace dougong::seismic {

Peak peak(std::span<const double> values, double interval) {
  Peak best;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::abs(values[i]) > best.value) best = {std::abs(values[i]), 0.0, i};
  }
  best.time = interval * static_cast<double>(best.index);
  return best;
}

double mean(std::span<const double> values) {
  if (values.empty()) return 0.0;
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double root_mean_square(std::span<const double> values) {
  if (values.empty()) return 0.0;
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

}  // namespace dougong::seismic
