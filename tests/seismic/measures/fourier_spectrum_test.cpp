#include "seismic/measures/fourier_spectrum.h"

#include <array>

#include "tests/seismic/test_data.h"

namespace dougong::seismic {
namespace {

// Validation case P05.
TEST(FourierAmplitude, OfARickerPulseMeetsItsClosedFormP05) {
  const double dt = 0.005, f0 = 2.0;
  std::vector<double> a;
  for (int k = 0; k <= 800; ++k) {
    const double x = std::pow(std::numbers::pi * f0 * (dt * k - 2.0), 2);
    a.push_back(3.0 * (1.0 - 2.0 * x) * std::exp(-x));
  }
  constexpr std::array<std::array<double, 2>, 5> rows = {
      {{0.5, 0.099376325}, {1, 0.32954347}, {2, 0.62266125}, {4, 0.12400191}, {6, 0.0018799162}}};
  for (const auto& [f, amplitude] : rows) EXPECT_CLOSE(fourier_amplitude(a, dt, f), amplitude, 5e-8) << f;
}

TEST(FourierAmplitude, MeetsP05) {
  const auto a = testing::record_a();
  constexpr std::array<std::array<double, 2>, 5> rows = {
      {{0.5, 0.36069114}, {1, 0.53715285}, {2, 0.22550326}, {5, 0.039404748}, {10, 0.026120475}}};
  for (const auto& [f, amplitude] : rows) EXPECT_CLOSE(fourier_amplitude(a, 0.01, f), amplitude, 5e-8) << f;
}

TEST(FourierSpectrum, IsTheSumAtItsFrequencies) {
  const auto a = testing::record_a();
  const FourierSpectrum spectrum = fourier_spectrum(a, 0.01, 0.02);
  EXPECT_LE(spectrum.frequency_step, 0.02);
  for (const std::size_t m :
       {std::size_t{0}, std::size_t{37}, std::size_t{500}, spectrum.amplitude.size() - 1})
    EXPECT_NEAR(spectrum.amplitude[m],
                fourier_amplitude(a, 0.01, spectrum.frequency_step * static_cast<double>(m)), 1e-11);
}

TEST(KonnoOhmachi, LeavesAConstantAloneAndNarrowsWithItsBandwidth) {
  FourierSpectrum flat{0.05, std::vector<double>(1000, 2.0)};
  for (const double smooth : konno_ohmachi(flat, std::vector<double>{0.5, 3.0, 20.0}))
    EXPECT_NEAR(smooth, 2.0, 1e-12);
  flat.amplitude.assign(1000, 0.0);
  flat.amplitude[200] = 1.0;  // 10 Hz
  const std::vector<double> centres = {9.0, 10.0};
  const auto wide = konno_ohmachi(flat, centres, 20.0), narrow = konno_ohmachi(flat, centres, 80.0);
  EXPECT_GT(narrow[1], wide[1]);
  EXPECT_LT(narrow[0], wide[0]);
}

// The definition at one line: bandwidth 40, a ratio of 1.1 is sin(40 lg 1.1)/(40 lg 1.1) to the fourth.
TEST(KonnoOhmachi, WeighsAsDefined) {
  FourierSpectrum two{1.0, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 5.0, 9.0}};
  const double x = 40.0 * std::log10(1.1), weight = std::pow(std::sin(x) / x, 4);
  double others = 0.0;
  for (int m = 1; m < 10; ++m) {
    const double y = 40.0 * std::log10(m / 10.0);
    others += std::pow(std::sin(y) / y, 4);
  }
  EXPECT_CLOSE(konno_ohmachi(two, std::vector<double>{10.0}).front(),
               (5.0 + 9.0 * weight) / (1.0 + weight + others), 1e-12);
}

TEST(MeanPeriod, OfASineIsItsPeriod) {
  std::vector<double> a;
  for (int k = 0; k < 8192; ++k) a.push_back(std::sin(2 * std::numbers::pi * 2.5 * 0.01 * k));
  EXPECT_NEAR(mean_period(a, 0.01), 0.4, 0.002);
  EXPECT_EQ(mean_period(std::vector<double>(100, 0.0), 0.01), 0.0);
}

}  // namespace
}  // namespace dougong::seismic
