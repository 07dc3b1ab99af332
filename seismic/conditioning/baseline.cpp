#include "seismic/conditioning/baseline.h"

#include <cstddef>

#include "seismic/measures/integrate.h"

namespace dougong::seismic {
namespace {

// Least squares of y ~ p f + q g by the normal equations, all on times scaled to 0..1.
struct Fit {
  double ff = 0.0, fg = 0.0, gg = 0.0, fy = 0.0, gy = 0.0;

  void add(double f, double g, double y) {
    ff += f * f;
    fg += f * g;
    gg += g * g;
    fy += f * y;
    gy += g * y;
  }
  double first() const { return (fy * gg - gy * fg) / (ff * gg - fg * fg); }
  double second() const { return (gy * ff - fy * fg) / (ff * gg - fg * fg); }
};

void take_off(std::vector<double>& acceleration, double interval, const BaselineLine& line) {
  for (std::size_t k = 0; k < acceleration.size(); ++k) {
    acceleration[k] -= line.offset + line.slope * interval * static_cast<double>(k);
  }
}

}  // namespace

BaselineLine remove_acceleration_line(std::vector<double>& acceleration, double interval) {
  if (acceleration.size() < 3) return {};
  const double last = static_cast<double>(acceleration.size() - 1);
  Fit fit;
  for (std::size_t k = 0; k < acceleration.size(); ++k)
    fit.add(1.0, static_cast<double>(k) / last, acceleration[k]);
  const BaselineLine line{fit.first(), fit.second() / (last * interval)};
  take_off(acceleration, interval, line);
  return line;
}

BaselineLine remove_velocity_parabola(std::vector<double>& acceleration, double interval) {
  if (acceleration.size() < 3) return {};
  const double last = static_cast<double>(acceleration.size() - 1), duration = last * interval;
  const GroundHistory history = integrate(acceleration, interval);
  Fit fit;
  for (std::size_t k = 0; k < acceleration.size(); ++k) {
    const double s = static_cast<double>(k) / last;
    fit.add(s, s * s, history.velocity[k]);
  }
  const BaselineLine line{fit.first() / duration, 2.0 * fit.second() / (duration * duration)};
  take_off(acceleration, interval, line);
  return line;
}

}  // namespace dougong::seismic
