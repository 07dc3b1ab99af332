#include "seismic/conditioning/butterworth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

#include "seismic/constants.h"

namespace dougong::seismic {
namespace {

using Complex = std::complex<double>;

double warped(double frequency, double interval) {
  return 2.0 * std::tan(std::numbers::pi * frequency * interval);
}

Complex bilinear(Complex s) {
  return (2.0 + s) / (2.0 - s);
}

// Poles of the prototype in the upper half plane; the others are their conjugates and, of an odd order, -1.
std::vector<Complex> upper_poles(int order) {
  std::vector<Complex> poles;
  for (int k = 0; k < order / 2; ++k) {
    const double angle = std::numbers::pi * (2 * k + order + 1) / (2.0 * order);
    poles.emplace_back(std::cos(angle), std::sin(angle));
  }
  return poles;
}

// Two poles whose sum and product are real below, the given zeros above, gain 1 at the frequency of z. A
// first-order section has the second pole and the second zero at 0.
Section section(const std::array<Complex, 2>& poles, const std::array<double, 2>& zeros, Complex z) {
  Section s;
  s.b1 = -(zeros[0] + zeros[1]);
  s.b2 = zeros[0] * zeros[1];
  s.a1 = -(poles[0] + poles[1]).real();
  s.a2 = (poles[0] * poles[1]).real();
  const Complex w = 1.0 / z;
  const double size = std::abs((s.b0 + s.b1 * w + s.b2 * w * w) / (1.0 + s.a1 * w + s.a2 * w * w));
  s.b0 /= size;
  s.b1 /= size;
  s.b2 /= size;
  return s;
}

std::array<Complex, 2> with_conjugate(Complex pole) {
  return {pole, std::conj(pole)};
}

// Both roots of s^2 - B p s + w0^2 = 0: where the band pass puts a prototype pole p.
std::array<Complex, 2> band_poles(Complex pole, double low, double high) {
  const Complex middle = 0.5 * (high - low) * pole;
  const Complex root = std::sqrt(middle * middle - low * high);
  return {middle + root, middle - root};
}

void check(const Band& band, double interval) {
  const double nyquist = 0.5 / interval;
  const double low = band.high_pass.value_or(0.0), high = band.low_pass.value_or(nyquist);
  if (band.order < 1 || band.order > 12)
    throw std::invalid_argument("the order of a Butterworth filter must be from 1 to 12");
  const bool in_order = low < high && (!band.high_pass || low > 0.0) && (!band.low_pass || high < nyquist);
  if (!in_order)
    throw std::invalid_argument("filter corners must satisfy 0 < high pass < low pass < Nyquist");
}

}  // namespace

std::vector<Section> butterworth(const Band& band, double interval) {
  check(band, interval);
  std::vector<Section> sections;
  const double low = band.high_pass ? warped(*band.high_pass, interval) : 0.0;
  const double high = band.low_pass ? warped(*band.low_pass, interval) : 0.0;
  const Complex first(-1.0, 0.0);  // the real pole of an odd order
  const bool odd = band.order % 2 == 1;
  if (band.high_pass && band.low_pass) {
    const Complex centre = bilinear(Complex(0.0, std::sqrt(low * high)));
    for (const Complex pole : upper_poles(band.order))
      for (const Complex s : band_poles(pole, low, high))
        sections.push_back(section(with_conjugate(bilinear(s)), {1.0, -1.0}, centre));
    const auto [one, other] = band_poles(first, low, high);
    if (odd) sections.push_back(section({bilinear(one), bilinear(other)}, {1.0, -1.0}, centre));
  } else if (band.high_pass) {
    for (const Complex pole : upper_poles(band.order))
      sections.push_back(section(with_conjugate(bilinear(low / pole)), {1.0, 1.0}, {-1.0, 0.0}));
    if (odd) sections.push_back(section({bilinear(low / first), 0.0}, {1.0, 0.0}, {-1.0, 0.0}));
  } else if (band.low_pass) {
    for (const Complex pole : upper_poles(band.order))
      sections.push_back(section(with_conjugate(bilinear(high * pole)), {-1.0, -1.0}, {1.0, 0.0}));
    if (odd) sections.push_back(section({bilinear(high * first), 0.0}, {-1.0, 0.0}, {1.0, 0.0}));
  }
  return sections;
}

double gain(std::span<const Section> sections, double frequency, double interval) {
  const double angle = two_pi * frequency * interval;
  const Complex w(std::cos(angle), -std::sin(angle));
  double product = 1.0;
  for (const Section& s : sections) {
    product *= std::abs((s.b0 + s.b1 * w + s.b2 * w * w) / (1.0 + s.a1 * w + s.a2 * w * w));
  }
  return product;
}

void filter_forward(std::span<const Section> sections, std::vector<double>& samples) {
  for (const Section& s : sections) {
    double first = 0.0, second = 0.0;  // transposed direct form II
    for (double& x : samples) {
      const double y = s.b0 * x + first;
      first = s.b1 * x - s.a1 * y + second;
      second = s.b2 * x - s.a2 * y;
      x = y;
    }
  }
}

void filter_both_ways(std::span<const Section> sections, std::vector<double>& samples) {
  filter_forward(sections, samples);
  std::reverse(samples.begin(), samples.end());
  filter_forward(sections, samples);
  std::reverse(samples.begin(), samples.end());
}

}  // namespace dougong::seismic
