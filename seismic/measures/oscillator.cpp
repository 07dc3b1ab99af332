#include "seismic/measures/oscillator.h"

#include <array>
#include <cmath>
#include <cstddef>

#include "seismic/constants.h"

namespace dougong::seismic {
namespace {

using Matrix = std::array<std::array<double, 4>, 4>;

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = 0; k < 4; ++k) c[i][j] += a[i][k] * b[k][j];
    }
  }
  return c;
}

// exp(m) by its series; the caller keeps the entries below about one half.
Matrix exponential_series(const Matrix& m) {
  Matrix sum{}, term{};
  for (std::size_t i = 0; i < 4; ++i) sum[i][i] = term[i][i] = 1.0;
  for (int n = 1; n <= 18; ++n) {  // 0.5^18/18! < 1e-21
    term = product(term, m);
    for (auto& row : term) {
      for (double& entry : row) entry /= n;
    }
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) sum[i][j] += term[i][j];
    }
  }
  return sum;
}

// Over a step of s/w in the variables (u w^2, u' w, a, da/d(w t)), where every entry is of order one.
Matrix scaled_propagator(double s, double zeta) {
  Matrix m{};
  const double largest = s * std::max(1.0, 2.0 * zeta);
  const int halvings = largest > 0.5 ? static_cast<int>(std::ceil(std::log2(largest / 0.5))) : 0;
  const double h = std::ldexp(s, -halvings);
  m[0] = {0.0, h, 0.0, 0.0};
  m[1] = {-h, -2.0 * zeta * h, -h, 0.0};
  m[2] = {0.0, 0.0, 0.0, h};
  Matrix out = exponential_series(m);
  for (int i = 0; i < halvings; ++i) out = product(out, out);
  return out;
}

}  // namespace

OscillatorStep scaled_oscillator_step(const Oscillator& oscillator, double interval) {
  const double s = two_pi / oscillator.period * interval;
  const Matrix p = scaled_propagator(s, oscillator.damping_ratio);
  // The slope is (b - a)/s in scaled time: its column is shared out between a and b.
  const double ub = p[0][3] / s, vb = p[1][3] / s;
  return {p[0][0], p[0][1], p[0][2] - ub, ub, p[1][0], p[1][1], p[1][2] - vb, vb};
}

OscillatorStep oscillator_step(const Oscillator& oscillator, double interval) {
  const double w = two_pi / oscillator.period;
  const OscillatorStep s = scaled_oscillator_step(oscillator, interval);
  return {s.uu, s.uv / w, s.ua / (w * w), s.ub / (w * w), s.vu * w, s.vv, s.va / w, s.vb / w};
}

OscillatorHistory oscillator_response(std::span<const double> a, double interval,
                                      const Oscillator& oscillator) {
  const OscillatorStep c = oscillator_step(oscillator, interval);
  const double w = two_pi / oscillator.period, damping = 2.0 * oscillator.damping_ratio * w;
  const std::size_t n = a.size();
  OscillatorHistory out{std::vector<double>(n), std::vector<double>(n), std::vector<double>(n)};
  double u = 0.0, v = 0.0;
  for (std::size_t k = 1; k < n; ++k) {
    const double next = (c.uu * u + c.uv * v) + (c.ua * a[k - 1] + c.ub * a[k]);
    v = (c.vu * u + c.vv * v) + (c.va * a[k - 1] + c.vb * a[k]);
    u = next;
    out.displacement[k] = u;
    out.velocity[k] = v;
    out.absolute_acceleration[k] = -(damping * v + w * w * u);
  }
  return out;
}

}  // namespace dougong::seismic
