#include "seismic/synthesis/pulses.h"

#include "seismic/measures/fourier_spectrum.h"
#include "seismic/measures/integrate.h"
#include "seismic/measures/peaks.h"
#include "tests/seismic/test_data.h"

namespace dougong::seismic {
namespace {

constexpr double pi = std::numbers::pi, dt = 0.001;

TEST(Pulses, OfOneSineLeaveTheDisplacementOfItsClosedForm) {
  const auto h = integrate(sine_pulse(3.0, 2.0, 1.0, dt), dt);
  EXPECT_NEAR(h.velocity.back(), 0.0, 1e-12);
  EXPECT_CLOSE(h.displacement.back(), 3.0 / (2.0 * pi * 4.0), 2e-5);
}

TEST(Pulses, OfOneCosineLeaveNothing) {
  const auto h = integrate(cosine_pulse(3.0, 2.0, 1.0, dt), dt);
  EXPECT_NEAR(h.velocity.back(), 0.0, 1e-12);
  EXPECT_NEAR(h.displacement.back(), 0.0, 1e-6);
}

TEST(Pulses, OfRickerHaveTheVelocityAndTheEndOfTheClosedForm) {
  const auto a = ricker_pulse(3.0, 2.0, dt, {1.0, 0.5});
  const auto h = integrate(a, dt);
  EXPECT_EQ(a.size(), 3001u);
  EXPECT_NEAR(peak(a, dt).value, 3.0, 1e-12);
  EXPECT_NEAR(peak(a, dt).time, 1.75, 1e-12);
  EXPECT_CLOSE(peak(h.velocity, dt).value, 3.0 / (std::sqrt(2.0 * std::exp(1.0)) * pi * 2.0), 5e-5);
  EXPECT_NEAR(h.velocity.back(), 0.0, 1e-7);
  EXPECT_NEAR(h.displacement.back(), 0.0, 1e-6);
}

// A 1 m/s, f 0.5 Hz, gamma 2.2, nu 0.7 rad: -0.03726571 m.
TEST(Pulses, OfMavroeidisLeaveTheirResidualDisplacement) {
  const NearFaultPulse pulse{1.0, 0.5, 2.2, 0.7};
  EXPECT_CLOSE(residual_displacement(pulse), -0.03726571, 1e-7);
  const auto h = integrate(near_fault_pulse(pulse, dt), dt);
  EXPECT_NEAR(h.displacement.back(), residual_displacement(pulse), 2e-5);
  EXPECT_NEAR(h.velocity.back(), 0.0, 1e-5);
  const NearFaultPulse whole{1.3, 0.8, 2.0, 0.3};
  EXPECT_NEAR(residual_displacement(whole), 0.0, 1e-15);
  EXPECT_CLOSE(peak(integrate(near_fault_pulse({1.3, 0.8, 3.0, 0.0}, dt), dt).velocity, dt).value, 1.3, 1e-4);
}

TEST(Pulses, OfAHarmonicRiseAndFall) {
  const auto a = harmonic(2.0, 1.0, 10.0, 2.0, 0.01);
  EXPECT_EQ(a.front(), 0.0);
  EXPECT_NEAR(a[500 + 25], 2.0, 1e-12);
  EXPECT_LT(std::abs(a[25]), 0.2);
}

// The turns of a sweep between t and t + 1/4 period tell its frequency: zeros of the sine are counted.
TEST(Pulses, OfASweepPassItsFrequencies) {
  const auto turns = [](SweepRate rate) {
    const auto a = sweep(1.0, 1.0, 9.0, rate, 20.0, 0.0, 0.001);
    int zeros = 0;
    for (std::size_t k = 1; k < a.size(); ++k) zeros += (a[k - 1] < 0.0) != (a[k] < 0.0);
    return zeros / 2.0;
  };
  EXPECT_NEAR(turns(SweepRate::linear), 100.0, 1.0);
  EXPECT_NEAR(turns(SweepRate::logarithmic), 8.0 * 20.0 / std::log(9.0), 1.0);
}

TEST(WhiteNoise, IsFlatAndTheSameForASeed) {
  const auto a = white_noise(0.5, 200.0, 0.0, 0.01, 7);
  EXPECT_EQ(a, white_noise(0.5, 200.0, 0.0, 0.01, 7));
  EXPECT_NE(a, white_noise(0.5, 200.0, 0.0, 0.01, 8));
  EXPECT_NEAR(root_mean_square(a), 0.5, 0.01);
  const auto spectrum = fourier_spectrum(a, 0.01);
  double low = 0.0, high = 0.0;
  const std::size_t quarter = spectrum.amplitude.size() / 4;
  for (std::size_t m = 0; m < quarter; ++m) {
    low += std::pow(spectrum.amplitude[m], 2);
    high += std::pow(spectrum.amplitude[3 * quarter + m], 2);
  }
  EXPECT_NEAR(low / high, 1.0, 0.1);
}

}  // namespace
}  // namespace dougong::seismic
