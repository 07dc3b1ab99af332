#include "seismic/measures/integrate.h"

namespace dougong::seismic {

GroundHistory integrate(std::span<const double> acceleration, double interval) {
  const std::size_t n = acceleration.size();
  GroundHistory out{
      interval, {acceleration.begin(), acceleration.end()}, std::vector<double>(n), std::vector<double>(n)};
  const double h = interval;
  for (std::size_t k = 0; k + 1 < n; ++k) {
    const double a0 = acceleration[k], a1 = acceleration[k + 1];
    out.velocity[k + 1] = out.velocity[k] + 0.5 * h * (a0 + a1);
    out.displacement[k + 1] = out.displacement[k] + h * out.velocity[k] + h * h * (2.0 * a0 + a1) / 6.0;
  }
  return out;
}

}  // namespace dougong::seismic
