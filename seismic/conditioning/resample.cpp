#include "seismic/conditioning/resample.h"

#include <gsl/gsl_spline.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numeric>

#include "seismic/conditioning/taper.h"
#include "seismic/numerics/fourier.h"

namespace dougong::seismic {
namespace {

constexpr std::size_t longest_reflection = 1000;  // samples; longer changes nothing at 1e-9

std::size_t new_count(std::size_t samples, double ratio) {
  const double last = static_cast<double>(samples - 1) / ratio;
  return static_cast<std::size_t>(std::floor(last * (1.0 + 1e-12) + 1e-9)) + 1;
}

std::vector<double> linear(std::span<const double> x, double ratio, std::size_t count) {
  std::vector<double> out(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double at = static_cast<double>(k) * ratio;
    const std::size_t i = std::min(static_cast<std::size_t>(at), x.size() - 2);
    const double part = std::min(at - static_cast<double>(i), 1.0);
    out[k] = x[i] + part * (x[i + 1] - x[i]);
  }
  return out;
}

std::vector<double> spline(std::span<const double> x, double ratio, std::size_t count) {
  std::vector<double> places(x.size());
  std::iota(places.begin(), places.end(), 0.0);
  const std::unique_ptr<gsl_spline, decltype(&gsl_spline_free)> curve(
      gsl_spline_alloc(gsl_interp_cspline, x.size()), gsl_spline_free);
  gsl_spline_init(curve.get(), places.data(), x.data(), x.size());
  std::vector<double> out(count);
  for (std::size_t k = 0; k < count; ++k)
    out[k] = gsl_spline_eval(curve.get(), std::min(static_cast<double>(k) * ratio, places.back()), nullptr);
  return out;
}

// The record at the front, its end reflected behind it, zeros, and the reflection of its start at the very
// end, which the period puts before the first sample.
std::vector<double> continued(std::span<const double> x) {
  const std::size_t n = x.size(), reach = std::min(longest_reflection, n - 1);
  std::vector<double> out(next_power_of_two(n + 2 * reach + 2), 0.0);
  std::copy(x.begin(), x.end(), out.begin());
  for (std::size_t k = 1; k <= reach; ++k) {
    const double fade = 1.0 - smooth_step(static_cast<double>(k) / static_cast<double>(reach + 1)).value;
    out[n - 1 + k] = fade * (2.0 * x[n - 1] - x[n - 1 - k]);
    out[out.size() - k] = fade * (2.0 * x[0] - x[k]);
  }
  return out;
}

}  // namespace

std::vector<double> resample(std::span<const double> samples, double interval, double new_interval,
                             ResampleMethod method) {
  const double ratio = new_interval / interval;
  if (samples.size() < 2 || ratio == 1.0) return {samples.begin(), samples.end()};
  const std::size_t count = new_count(samples.size(), ratio);
  // Three points are the least of a spline.
  if (method == ResampleMethod::linear || (method == ResampleMethod::spline && samples.size() < 3))
    return linear(samples, ratio, count);
  if (method == ResampleMethod::spline) return spline(samples, ratio, count);
  const double cutoff = ratio > 1.0 ? 0.5 / ratio : 0.5;
  return trigonometric_samples(continued(samples), ratio, count, cutoff);
}

}  // namespace dougong::seismic
