#include "seismic/measures/response_spectrum.h"
#include "seismic/measures/spectrum_intensity.h"

#include <gmock/gmock.h>

#include <array>

#include "tests/seismic/test_data.h"

namespace dougong::seismic {
namespace {

using testing::record_a;

struct Row {
  double period, sd, sv, sa, psa, continuous;
};

// Validation case P01: reference from an independent exact recursion, printed to 8 digits.
constexpr std::array<Row, 12> p01 = {{
    {0.05, 0.00022829463, 0.016791574, 3.5524367, 3.6050843, 3.7264332},
    {0.1, 0.0010584759, 0.057218777, 4.2630492, 4.1786953, 4.2828141},
    {0.2, 0.0063245839, 0.19435078, 6.2533606, 6.2421141, 6.2432715},
    {0.3, 0.017589514, 0.33532059, 7.7746111, 7.7156242, 7.7382611},
    {0.5, 0.033304046, 0.40828278, 5.2804636, 5.2591642, 5.2636506},
    {0.75, 0.05341839, 0.48365181, 3.7679256, 3.7491085, 3.7518281},
    {1, 0.077209976, 0.50312333, 3.0670229, 3.0481277, 3.0481357},
    {1.5, 0.099788797, 0.46017127, 1.7650614, 1.7508906, 1.7509761},
    {2, 0.13957878, 0.46181705, 1.3840243, 1.3775873, 1.3776311},
    {3, 0.15935619, 0.48855494, 0.70295793, 0.69901449, 0.69901911},
    {4, 0.1878116, 0.33296182, 0.46950427, 0.46340656, 0.46342982},
    {5, 0.13902732, 0.34233304, 0.22286036, 0.21954315, 0.21954833},
}};

constexpr double printed = 5e-8;  // half a unit of the eighth digit

TEST(ResponseSpectrum, MeetsTheExactRecursionAtTheSamplesP01) {
  const auto a = record_a();
  double worst = 0.0;
  for (const Row& row : p01) {
    const SpectralPoint point = spectral_point(a, 0.01, row.period);
    EXPECT_CLOSE(point.displacement, row.sd, printed) << row.period;
    EXPECT_CLOSE(point.velocity, row.sv, printed) << row.period;
    EXPECT_CLOSE(point.acceleration, row.sa, printed) << row.period;
    EXPECT_CLOSE(point.pseudo_acceleration, row.psa, printed) << row.period;
    worst = std::max({worst, std::abs(point.displacement / row.sd - 1), std::abs(point.velocity / row.sv - 1),
                      std::abs(point.acceleration / row.sa - 1),
                      std::abs(point.pseudo_acceleration / row.psa - 1)});
  }
  RecordProperty("worst_relative_error", std::to_string(worst * 1e9) + "e-9");
}

TEST(ResponseSpectrum, MeetsTheContinuousPeaksP01) {
  const auto a = record_a();
  for (const Row& row : p01) {
    EXPECT_CLOSE(spectral_point(a, 0.01, row.period, {0.05, 20}).pseudo_acceleration, row.continuous, printed)
        << row.period;
  }
}

// Peaks wherever they fall, against the samples of a step divided by 400: those miss (w h/400)^2/8 at most.
TEST(ResponseSpectrum, FindsThePeaksWithinAStepToTheBoundItStates) {
  const auto a = record_a();
  double worst = 0.0;
  for (const double period : {0.01, 0.02, 0.03, 0.05, 0.1, 0.2, 0.5, 2.0}) {
    const SpectralPoint found = spectral_point(a, 0.01, period, {0.05, 1, true});
    const SpectralPoint fine = spectral_point(a, 0.01, period, {0.05, 400, false});
    for (const auto ordinate :
         {&SpectralPoint::displacement, &SpectralPoint::velocity, &SpectralPoint::acceleration}) {
      worst = std::max(worst, std::abs(found.*ordinate / (fine.*ordinate) - 1.0));
      EXPECT_CLOSE(found.*ordinate, fine.*ordinate, 4e-5) << period;
    }
  }
  RecordProperty("worst_relative_error", std::to_string(worst * 1e6) + "e-6");
}

TEST(ResponseSpectrum, MissesThePeaksBetweenTheSamplesByNoMoreThanItSays) {
  const auto a = record_a();
  for (const double period : {0.05, 0.1, 0.2, 0.5, 1.0}) {
    const double w = 2 * std::numbers::pi / period;
    const double missed = 1.0 - spectral_point(a, 0.01, period).pseudo_acceleration /
                                    spectral_point(a, 0.01, period, {0.05, 1, true}).pseudo_acceleration;
    EXPECT_GE(missed, -1e-5) << period;
    EXPECT_LE(missed, w * w * 1e-4 / 8.0) << period;
  }
}

// Closed form: a harmonic ground a = sin(p t) from rest, without damping, u'' + w^2 u = -a.
TEST(ResponseSpectrum, OfAnUndampedOscillatorPeaksWhereTheClosedFormDoes) {
  const double dt = 0.001, p = 2 * std::numbers::pi * 1.3, w = 2 * std::numbers::pi / 0.4;
  std::vector<double> a;
  double peak_u = 0.0;
  for (int k = 0; k <= 3000; ++k) a.push_back(std::sin(p * dt * k));
  for (int k = 0; k <= 300000; ++k) {
    const double t = 1e-5 * k;
    peak_u = std::max(peak_u, std::abs((std::sin(p * t) - p / w * std::sin(w * t)) / (p * p - w * w)));
  }
  EXPECT_CLOSE(spectral_point(a, dt, 0.4, {0.0, 1, true}).displacement, peak_u, 2e-5);
}

TEST(ResponseSpectrum, GivesPseudoAccelerationAloneWithTheSameBits) {
  const auto a = record_a();
  const auto periods = log_spaced_periods(0.01, 10.0, 60);
  const auto psa = pseudo_accelerations(a, 0.01, periods);
  const auto spectrum = response_spectrum(a, 0.01, periods);
  for (std::size_t i = 0; i < periods.size(); ++i) EXPECT_EQ(psa[i], spectrum[i].pseudo_acceleration);
}

TEST(ResponseSpectrum, OffersMoreThanAHundredPeriodsByDefault) {
  const auto periods = log_spaced_periods();
  EXPECT_GE(periods.size(), 100u);
  EXPECT_DOUBLE_EQ(periods.front(), 0.02);
  EXPECT_DOUBLE_EQ(periods.back(), 10.0);
  const auto spectrum = response_spectrum(record_a(), 0.01, periods);
  ASSERT_EQ(spectrum.size(), periods.size());
  for (std::size_t i = 0; i < periods.size(); ++i) EXPECT_EQ(spectrum[i].period, periods[i]);
}

// Validation case X07: the same motion at other steps, continuous peaks.
TEST(ResponseSpectrum, FollowsTheRecordStepAsX07Says) {
  struct Case {
    double dt, psa_0_1, psa_0_3, psa_1, psa_3;
  };
  for (const Case& c :
       {Case{0.001, 4.39637, 7.76584, 3.04931, 0.699057}, Case{0.005, 4.36856, 7.75911, 3.04902, 0.699048},
        Case{0.02, 3.95257, 7.65497, 3.04444, 0.698904}, Case{0.05, 3.67346, 7.47711, 3.06548, 0.703545},
        Case{0.1, 2.66782, 5.64911, 2.78162, 0.761305}}) {
    const auto a = record_a(c.dt);
    const SpectrumOptions continuous{0.05, 1, true};
    EXPECT_CLOSE(spectral_point(a, c.dt, 0.1, continuous).pseudo_acceleration, c.psa_0_1, 1e-4) << c.dt;
    EXPECT_CLOSE(spectral_point(a, c.dt, 0.3, continuous).pseudo_acceleration, c.psa_0_3, 1e-4) << c.dt;
    EXPECT_CLOSE(spectral_point(a, c.dt, 1.0, continuous).pseudo_acceleration, c.psa_1, 1e-4) << c.dt;
    EXPECT_CLOSE(spectral_point(a, c.dt, 3.0, continuous).pseudo_acceleration, c.psa_3, 1e-4) << c.dt;
  }
}

TEST(ResponseSpectrum, WarnsOfPeriodsBelowTenSteps) {
  using ::testing::HasSubstr;
  const std::vector<double> periods = {0.05, 1.0};
  const auto warnings = spectrum_warnings(periods, 0.01);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0], HasSubstr("below 0.1 s"));
  EXPECT_TRUE(spectrum_warnings(std::vector<double>{0.1, 1.0}, 0.01).empty());
  const auto coarse = spectrum_warnings(std::vector<double>{0.1, 0.5}, 0.1);
  ASSERT_EQ(coarse.size(), 2u);
  EXPECT_THAT(coarse[1], HasSubstr("coarser than needed"));
}

TEST(ResponseSpectrum, IsZeroForARecordOfZeros) {
  const std::vector<double> zeros(100, 0.0);
  const SpectralPoint point = spectral_point(zeros, 0.01, 0.5);
  EXPECT_EQ(point.displacement, 0.0);
  EXPECT_EQ(point.acceleration, 0.0);
  EXPECT_EQ(housner_intensity(zeros, 0.01), 0.0);
}

TEST(ResponseSpectrum, OfAStiffOscillatorIsThePga) {
  const auto a = record_a();
  EXPECT_CLOSE(spectral_point(a, 0.01, 0.001).acceleration, 2.63469844, 1e-2);
}

}  // namespace
}  // namespace dougong::seismic
