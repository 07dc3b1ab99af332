#include "seismic/measures/rotated.h"

#include <array>

#include "tests/seismic/test_data.h"

namespace dougong::seismic {
namespace {

// Validation case P07: SYN(2008) and SYN(2011), printed to eight digits.
TEST(RotatedSpectrum, MeetsP07) {
  const auto a = testing::Syn(2008, 1.0).samples(0.01), b = testing::Syn(2011, 1.0).samples(0.01);
  const std::vector<double> periods = {0.1, 0.2, 0.5, 1.0, 2.0, 3.0};
  constexpr std::array<std::array<double, 4>, 6> rows = {{
      {3.9226186, 4.5922947, 5.8918431, 4.6266843},
      {4.9774413, 5.6444099, 6.2428525, 5.9099174},
      {4.6251282, 5.328317, 6.6113122, 5.0515033},
      {2.1124138, 3.0484949, 3.7373219, 3.0484949},
      {0.59213959, 1.2141537, 1.7094026, 1.1874628},
      {0.36640809, 0.56020699, 0.70550662, 0.51055606},
  }};
  constexpr double printed = 5e-8;  // half a unit of the eighth digit
  const auto spectrum = rotated_spectrum(a, b, 0.01, periods);
  for (std::size_t i = 0; i < periods.size(); ++i) {
    EXPECT_CLOSE(spectrum[i].rotd00, rows[i][0], printed) << periods[i];
    EXPECT_CLOSE(spectrum[i].rotd50, rows[i][1], printed) << periods[i];
    EXPECT_CLOSE(spectrum[i].rotd100, rows[i][2], printed) << periods[i];
    EXPECT_CLOSE(spectrum[i].geometric_mean, rows[i][3], printed) << periods[i];
  }
  const RotatedPeaks ground = rotated_peaks(a, b);
  EXPECT_CLOSE(ground.rotd50, 2.6077216, printed);
  EXPECT_CLOSE(ground.rotd100, 2.8411711, printed);
}

TEST(RotatedPeaks, DoNotDependOnHowTheSensorStood) {
  const auto a = testing::Syn(2008, 1.0).samples(0.01), b = testing::Syn(2011, 1.0).samples(0.01);
  const RotatedPeaks as_it_was = rotated_peaks(a, b);
  const RotatedPeaks turned = rotated_peaks(rotated(a, b, 37.0), rotated(a, b, 127.0));
  EXPECT_CLOSE(turned.rotd00, as_it_was.rotd00, 1e-12);
  EXPECT_CLOSE(turned.rotd50, as_it_was.rotd50, 1e-12);
  EXPECT_CLOSE(turned.rotd100, as_it_was.rotd100, 1e-12);
  EXPECT_EQ(std::fmod(turned.angle100 + 37.0, 180.0), as_it_was.angle100);
}

TEST(RotatedPeaks, OfOneComponentAloneAreItsProjections) {
  const std::vector<double> a = {0.0, 2.0, -3.0}, zeros(3, 0.0);
  const RotatedPeaks peaks = rotated_peaks(a, zeros);
  EXPECT_EQ(peaks.rotd100, 3.0);
  EXPECT_EQ(peaks.rotd00, 0.0);
  EXPECT_NEAR(peaks.rotd50, 3.0 * std::numbers::sqrt2 / 2, 1e-12);
  EXPECT_EQ(peaks.geometric_mean, 0.0);
}

}  // namespace
}  // namespace dougong::seismic
