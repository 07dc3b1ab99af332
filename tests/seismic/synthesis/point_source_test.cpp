#include "seismic/synthesis/point_source.h"

#include <complex>

#include "seismic/numerics/fourier.h"
#include "seismic/synthesis/random.h"
#include "tests/seismic/test_data.h"

namespace dougong::seismic {
namespace {

TEST(PointSource, HasThePublishedCornerFrequencies) {
  Region region;
  region.shear_velocity = 3600.0;
  for (const auto& [magnitude, f0] : {std::pair{6.0, 0.2903}, {7.0, 0.0918}, {7.9, 0.0326}, {9.0, 0.0092}}) {
    EXPECT_NEAR(corner_frequency({magnitude, 5e6, 30000.0, 0.0}, region), f0, 5.1e-5) << magnitude;
  }
}

TEST(PointSource, EnvelopePeaksAtAFifthAndLeavesFivePercent) {
  EXPECT_NEAR(envelope(0.2 * 30.0, 30.0), 1.0, 1e-12);
  EXPECT_NEAR(envelope(30.0, 30.0), 0.05, 1e-12);
  EXPECT_LT(envelope(5.9, 30.0), 1.0);
  EXPECT_EQ(envelope(0.0, 30.0), 0.0);
}

// Boore 2003: the mean over seeds of |A|^2 is the target squared.
TEST(PointSource, MeanSquareSpectrumIsTheTarget) {
  const Region region;
  const PointSource source{6.0, 1e7, 20000.0, 0.0};
  constexpr std::size_t n = 16384;
  constexpr int seeds = 60;
  const double dt = 0.01;
  std::vector<double> sum(n / 2, 0.0);
  for (int seed = 0; seed < seeds; ++seed) {
    const auto a = simulate(source, region, dt, n, static_cast<std::uint64_t>(seed), 0);
    std::vector<std::complex<double>> x(a.begin(), a.end());
    fourier_transform(x);
    for (std::size_t m = 0; m < n / 2; ++m) sum[m] += std::norm(x[m] * dt) / seeds;
  }
  for (const double f : {0.5, 1.0, 2.0, 5.0, 10.0}) {
    const auto middle = static_cast<std::size_t>(f * n * dt);
    double ratio = 0.0;
    for (std::size_t m = middle - 6; m <= middle + 6; ++m) {
      ratio +=
          sum[m] / std::pow(fourier_amplitude(source, region, static_cast<double>(m) / (n * dt)), 2) / 13;
    }
    EXPECT_NEAR(ratio, 1.0, 0.15) << f;
  }
}

TEST(PointSource, HighFrequenciesGrowWithStressDropToTwoThirds) {
  const Region region;
  const double low = fourier_amplitude({6.5, 5e6, 20000.0, 0.0}, region, 10.0);
  const double high = fourier_amplitude({6.5, 10e6, 20000.0, 0.0}, region, 10.0);
  EXPECT_NEAR(high / low, std::pow(2.0, 2.0 / 3.0), 0.01);
}

TEST(PointSource, StartsAtItsOnset) {
  const auto a = simulate({6.0, 1e7, 20000.0, 5.0}, Region{}, 0.01, 3000, 1, 0);
  for (std::size_t k = 0; k < 500; ++k) ASSERT_EQ(a[k], 0.0);
  double later = 0.0;
  for (std::size_t k = 500; k < 3000; ++k) later = std::max(later, std::abs(a[k]));
  EXPECT_GT(later, 0.01);
}

TEST(PointSource, SameSeedSameBitsAndOtherSeedsOtherwise) {
  const PointSource source{6.0, 1e7, 20000.0, 0.0};
  EXPECT_EQ(simulate(source, {}, 0.01, 1000, 3, 7), simulate(source, {}, 0.01, 1000, 3, 7));
  EXPECT_NE(simulate(source, {}, 0.01, 1000, 3, 7), simulate(source, {}, 0.01, 1000, 3, 8));
}

TEST(Random, GaussiansHaveMeanZeroAndVarianceOne) {
  const auto x = gaussian_noise(1, 2, 100000);
  double sum = 0.0, square = 0.0, fourth = 0.0;
  for (const double value : x) sum += value, square += value * value, fourth += std::pow(value, 4);
  EXPECT_NEAR(sum / 1e5, 0.0, 0.012);
  EXPECT_NEAR(square / 1e5, 1.0, 0.015);
  EXPECT_NEAR(fourth / 1e5, 3.0, 0.12);
}

}  // namespace
}  // namespace dougong::seismic
