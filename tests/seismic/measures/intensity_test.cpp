#include "seismic/measures/intensity.h"

#include "seismic/measures/integrate.h"
#include "seismic/measures/peaks.h"
#include "seismic/measures/response_spectrum.h"
#include "seismic/measures/spectrum_intensity.h"
#include "tests/seismic/test_data.h"

namespace dougong::seismic {
namespace {

using testing::record_a;

constexpr double g = 9.81;        // of the validation cases
constexpr double printed = 2e-9;  // nine digits

TEST(Syn, IsTheGeneratorOfTheValidationCases) {
  const testing::Syn syn(2008, 1.0);
  EXPECT_CLOSE(peak(syn.samples(0.01), 0.01).value, 2.634698442, 1e-9);
  EXPECT_CLOSE(syn.at(5.004), 0.6865403397, 1e-9);
  EXPECT_CLOSE(syn.at(10.004), 0.0681104363, 1e-8);
}

// Validation case P02.
TEST(Measures, MeetP02) {
  const auto a = record_a();
  const double dt = 0.01;
  EXPECT_CLOSE(peak(a, dt).value, 2.63469844, printed);
  const GroundHistory history = integrate(a, dt);
  EXPECT_CLOSE(peak(history.velocity, dt).value, 0.226782971, printed);
  EXPECT_CLOSE(peak(history.displacement, dt).value, 0.323637733, printed);
  EXPECT_CLOSE(history.velocity.back(), -0.00781666952, printed);
  EXPECT_CLOSE(history.displacement.back(), -0.323637733, printed);
  EXPECT_CLOSE(arias_intensity(a, dt, g), 0.992321146, printed);
  EXPECT_CLOSE(arias_intensity(a, dt, g, SquareIntegral::linear_interpolant), 0.974553365, printed);
  EXPECT_CLOSE(cumulative_absolute_velocity(a, dt), 7.19679522, printed);
  EXPECT_CLOSE(rms_acceleration(a, dt), 0.393614141, printed);
  EXPECT_NEAR(bracketed_duration(a, dt, 0.05 * g), 12.4, 1e-9);
  EXPECT_CLOSE(housner_intensity(a, dt), 0.931303034, printed);
}

TEST(Measures, MeetTheSignificantDurationsOfP02) {
  const auto a = record_a();
  const auto strong = significant_duration(a, 0.01);
  EXPECT_CLOSE(strong.start, 3.57919788, printed);
  EXPECT_CLOSE(strong.end, 11.5797502, 5e-9);
  EXPECT_CLOSE(strong.duration(), 8.00055234, printed);
  EXPECT_CLOSE(significant_duration(a, 0.01, 0.05, 0.75).duration(), 4.8829795, 2e-8);
}

TEST(Measures, CountTheSamplesAboveAThreshold) {
  const std::vector<double> a = {0.0, 1.0, 0.2, -2.0, 0.5, 1.0, 0.0};
  EXPECT_NEAR(uniform_duration(a, 0.5, 1.0), 1.5, 1e-15);
  EXPECT_NEAR(bracketed_duration(a, 0.5, 1.0), 2.0, 1e-15);
}

// Three seconds: strong, weak, strong. Only the strong windows count.
TEST(StandardisedCav, LeavesOutTheWeakSeconds) {
  std::vector<double> a(301, 0.1);
  for (std::size_t k = 0; k <= 100; ++k) a[k] = 1.0;
  for (std::size_t k = 201; k <= 300; ++k) a[k] = 2.0;
  const double all = cumulative_absolute_velocity(a, 0.01);
  EXPECT_NEAR(standardised_cav(a, 0.01, 0.05), all, 1e-12);
  a[100] = 0.1;
  const double first = 0.5 * 0.01 * (1.0 + 0.1) + 99 * 0.01, last = 0.5 * 0.01 * 2.1 + 99 * 0.01 * 2.0;
  EXPECT_NEAR(standardised_cav(a, 0.01, 0.5), first + last, 1e-12);
  EXPECT_EQ(standardised_cav(a, 0.01, 5.0), 0.0);
}

TEST(SpectrumIntensity, OfASeparateIntegralIsTheSame) {
  const auto a = record_a();
  double asi = 0.0, vsi = 0.0;
  for (int i = 0; i <= 240; ++i) {
    const SpectralPoint p = spectral_point(a, 0.01, 0.1 + 0.01 * i);
    const double ends = i == 0 || i == 240 ? 0.5 : 1.0;
    vsi += 0.01 * ends * p.velocity;
    if (i <= 40) asi += 0.01 * (i == 0 || i == 40 ? 0.5 : 1.0) * p.acceleration;
  }
  EXPECT_CLOSE(acceleration_spectrum_intensity(a, 0.01), asi, 1e-12);
  EXPECT_CLOSE(velocity_spectrum_intensity(a, 0.01), vsi, 1e-12);
}

TEST(AverageSpectralAcceleration, IsTheGeometricMean) {
  const auto a = record_a();
  const std::vector<double> two = {0.2, 1.0};
  EXPECT_CLOSE(average_spectral_acceleration(a, 0.01, two), std::sqrt(6.2421141 * 3.0481277), 5e-8);
  const auto periods = average_acceleration_periods(0.5);
  EXPECT_EQ(periods.size(), 10u);
  EXPECT_NEAR(periods.front(), 0.1, 1e-15);
  EXPECT_NEAR(periods.back(), 1.5, 1e-15);
  EXPECT_EQ(average_spectral_acceleration(std::vector<double>(50, 0.0), 0.01, two), 0.0);
}

TEST(PredominantPeriod, IsThatOfTheGreatestOrdinate) {
  const std::vector<double> periods = {0.1, 0.2, 0.3, 0.5, 1.0};
  EXPECT_EQ(predominant_period(record_a(), 0.01, periods), 0.3);
}

TEST(Measures, AreZeroForARecordOfZeros) {
  const std::vector<double> zeros(500, 0.0);
  EXPECT_EQ(peak(zeros, 0.01).value, 0.0);
  EXPECT_EQ(arias_intensity(zeros, 0.01), 0.0);
  EXPECT_EQ(significant_duration(zeros, 0.01).duration(), 0.0);
  EXPECT_EQ(bracketed_duration(zeros, 0.01, 0.5), 0.0);
}

TEST(Measures, IntegrateALinearAccelerationExactly) {
  std::vector<double> a;
  for (int k = 0; k <= 30; ++k) a.push_back(2.0 + 3.0 * 0.1 * k);
  const GroundHistory history = integrate(a, 0.1);
  EXPECT_NEAR(history.velocity.back(), 2.0 * 3 + 1.5 * 9, 1e-12);
  EXPECT_NEAR(history.displacement.back(), 9.0 + 0.5 * 27, 1e-12);
}

TEST(Measures, TellTheTimeOfThePeak) {
  const std::vector<double> a = {0.0, 1.0, -3.0, 3.0, 0.5};
  EXPECT_EQ(peak(a, 0.5).value, 3.0);
  EXPECT_EQ(peak(a, 0.5).time, 1.0);
}

}  // namespace
}  // namespace dougong::seismic
