#include "seismic/measures/intensity.h"

#include "seismic/measures/integrate.h"
#include "seismic/measures/peaks.h"
#include "seismic/measures/response_spectrum.h"
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
