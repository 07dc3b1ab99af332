#include "seismic/conditioning/baseline.h"

#include <gsl/gsl_multifit.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>

#include "seismic/measures/integrate.h"

namespace dougong::seismic {
namespace {

template <auto Free>
struct FreedBy {
  template <typename T>
  void operator()(T* pointer) const {
    Free(pointer);
  }
};
using Matrix = std::unique_ptr<gsl_matrix, FreedBy<gsl_matrix_free>>;
using Vector = std::unique_ptr<gsl_vector, FreedBy<gsl_vector_free>>;
using Workspace = std::unique_ptr<gsl_multifit_linear_workspace, FreedBy<gsl_multifit_linear_free>>;

// Least squares of y ~ sum c_p s^p, p = first .. last, s from 0 to 1 over the samples.
std::vector<double> fitted_powers(const std::vector<double>& y, int first, int last) {
  const std::size_t n = y.size(), m = static_cast<std::size_t>(last - first + 1);
  const Matrix powers(gsl_matrix_alloc(n, m)), covariance(gsl_matrix_alloc(m, m));
  const Vector values(gsl_vector_alloc(n)), coefficients(gsl_vector_alloc(m));
  for (std::size_t k = 0; k < n; ++k) {
    const double s = static_cast<double>(k) / static_cast<double>(n - 1);
    for (std::size_t i = 0; i < m; ++i)
      gsl_matrix_set(powers.get(), k, i, std::pow(s, first + static_cast<int>(i)));
    gsl_vector_set(values.get(), k, y[k]);
  }
  const Workspace work(gsl_multifit_linear_alloc(n, m));
  double squares = 0.0;
  gsl_multifit_linear(powers.get(), values.get(), coefficients.get(), covariance.get(), &squares, work.get());
  return {coefficients->data, coefficients->data + m};
}

// Coefficients of s^p, s = t/duration, as those of t^p.
Baseline in_time(std::vector<double> coefficients, double duration) {
  double scale = 1.0;
  for (double& c : coefficients) c /= std::exchange(scale, scale * duration);
  return coefficients;
}

void take_off(std::vector<double>& acceleration, double interval, const Baseline& baseline) {
  for (std::size_t k = 0; k < acceleration.size(); ++k) {
    const double t = interval * static_cast<double>(k);
    double value = 0.0;
    for (std::size_t i = baseline.size(); i-- > 0;) value = value * t + baseline[i];
    acceleration[k] -= value;
  }
}

bool determines(const std::vector<double>& samples, int coefficients) {
  return samples.size() > static_cast<std::size_t>(coefficients) && samples.size() > 2;
}

}  // namespace

Baseline remove_acceleration_polynomial(std::vector<double>& acceleration, double interval, int degree) {
  assert(degree >= 0 && degree <= highest_baseline_degree);
  if (!determines(acceleration, degree + 1)) return {};
  const double duration = interval * static_cast<double>(acceleration.size() - 1);
  const Baseline baseline = in_time(fitted_powers(acceleration, 0, degree), duration);
  take_off(acceleration, interval, baseline);
  return baseline;
}

Baseline remove_velocity_polynomial(std::vector<double>& acceleration, double interval, int degree) {
  assert(degree >= 1 && degree <= highest_baseline_degree);
  if (!determines(acceleration, degree)) return {};
  const double duration = interval * static_cast<double>(acceleration.size() - 1);
  std::vector<double> slope = fitted_powers(integrate(acceleration, interval).velocity, 1, degree);
  for (std::size_t i = 0; i < slope.size(); ++i) slope[i] *= static_cast<double>(i + 1) / duration;
  const Baseline baseline = in_time(std::move(slope), duration);
  take_off(acceleration, interval, baseline);
  return baseline;
}

RestCorrection end_at_rest(std::vector<double>& a, double interval) {
  if (a.size() < 4) return {};
  // D'' of the quintics that end with D = 1 and with D' = 1, up to factors: s (1 - s)(1 - 2 s), s (1 - s)(3 s
  // - 1).
  std::vector<double> move(a.size()), run(a.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    const double s = static_cast<double>(k) / static_cast<double>(a.size() - 1), bell = s * (1.0 - s);
    move[k] = bell * (1.0 - 2.0 * s), run[k] = bell * (3.0 * s - 1.0);
  }
  const GroundHistory left = integrate(a, interval), of_move = integrate(move, interval),
                      of_run = integrate(run, interval);
  const double v = left.velocity.back(), d = left.displacement.back();
  const double v1 = of_move.velocity.back(), d1 = of_move.displacement.back();
  const double v2 = of_run.velocity.back(), d2 = of_run.displacement.back();
  const double determinant = v1 * d2 - v2 * d1;
  const double first = (v * d2 - v2 * d) / determinant, second = (v1 * d - v * d1) / determinant;
  RestCorrection correction{v, d, 0.0};
  for (std::size_t k = 0; k < a.size(); ++k) {
    const double change = first * move[k] + second * run[k];
    a[k] -= change;
    correction.greatest_change = std::max(correction.greatest_change, std::abs(change));
  }
  return correction;
}

}  // namespace dougong::seismic
