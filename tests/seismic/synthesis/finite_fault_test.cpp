#include "seismic/synthesis/finite_fault.h"

#include <numeric>

#include "seismic/measures/fourier_spectrum.h"
#include "seismic/measures/response_spectrum.h"
#include "tests/seismic/test_data.h"

namespace dougong::seismic {
namespace {

FiniteFault moderate() {
  FiniteFault f;
  f.magnitude = 6.7;
  f.stress_drop = 8e6;
  f.length = 24000.0, f.width = 16000.0;
  f.dip = 0.9, f.top_depth = 3000.0;
  f.subfault_length = f.subfault_width = 4000.0;
  return f;
}
constexpr SitePlace site{30000.0, 10000.0};

// Root of the sum of the squares: what independent parts add up to.
double amplitude_of(const FiniteFault& f, const Region& region, double frequency) {
  const auto parts = subfaults(f, region, site, 1);
  double square = 0.0;
  for (const Subfault& s : parts)
    square += std::pow(fourier_amplitude(s, parts.size(), region, frequency), 2);
  return std::sqrt(square);
}

TEST(FiniteFault, OfOneSubfaultIsThePointSource) {
  FiniteFault f = moderate();
  f.subfault_length = f.length, f.subfault_width = f.width;
  const Region region;
  const auto parts = subfaults(f, region, site, 1);
  ASSERT_EQ(parts.size(), 1u);
  const PointSource point{f.magnitude, f.stress_drop, parts[0].distance, 0.0};
  EXPECT_CLOSE(parts[0].corner_frequency, corner_frequency(point, region), 1e-12);
  EXPECT_CLOSE(parts[0].high_scale, 1.0, 1e-12);
  for (const double frequency : {0.05, 0.3, 1.0, 10.0})
    EXPECT_CLOSE(fourier_amplitude(parts[0], 1, region, frequency),
                 fourier_amplitude(point, region, frequency), 1e-12);
}

TEST(FiniteFault, KeepsTheMomentAtLowFrequency) {
  FiniteFault f = moderate(), one = moderate();
  one.subfault_length = one.length, one.subfault_width = one.width;
  // Far away, so that all parts are as far.
  const SitePlace far{300000.0, 12000.0};
  const Region region;
  const auto many = subfaults(f, region, far, 1), single = subfaults(one, region, far, 1);
  double moment = 0.0, square = 0.0;
  for (const Subfault& s : many)
    moment += s.moment, square += std::pow(fourier_amplitude(s, many.size(), region, 0.01), 2);
  EXPECT_CLOSE(moment, seismic_moment(f.magnitude), 1e-12);
  EXPECT_CLOSE(std::sqrt(square), fourier_amplitude(single[0], 1, region, 0.01), 0.03);
}

TEST(FiniteFault, KeepsTheHighFrequenciesOfTheWhole) {
  FiniteFault one = moderate();
  one.subfault_length = one.length, one.subfault_width = one.width;
  const Region region;
  for (const double frequency : {3.0, 10.0})
    EXPECT_CLOSE(amplitude_of(moderate(), region, frequency), amplitude_of(one, region, frequency), 0.25)
        << frequency;
}

TEST(FiniteFault, GrowsWithStressDropToTwoThirdsAboveTheCorners) {
  FiniteFault strong = moderate();
  strong.stress_drop *= 2.0;
  EXPECT_NEAR(amplitude_of(strong, {}, 15.0) / amplitude_of(moderate(), {}, 15.0), std::pow(2.0, 2.0 / 3.0),
              0.02);
}

TEST(FiniteFault, LowersItsCornersAsItRuptures) {
  const auto parts = subfaults(moderate(), {}, site, 1);
  const auto [least, most] = std::minmax_element(
      parts.begin(), parts.end(), [](auto& a, auto& b) { return a.corner_frequency < b.corner_frequency; });
  EXPECT_GT(most->corner_frequency, 1.5 * least->corner_frequency);
  const Region region;
  EXPECT_CLOSE(most->corner_frequency,
               corner_frequency(region, seismic_moment(6.7) / static_cast<double>(parts.size()), 8e6), 1e-12);
}

std::vector<double> mean_spectrum(const FiniteFault& f, double dt, const std::vector<double>& periods) {
  constexpr int seeds = 40;
  std::vector<double> mean(periods.size(), 0.0);
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const auto psa = pseudo_accelerations(simulate(f, {}, site, dt, 1.0, seed, 1), dt, periods);
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += std::log(psa[i]) / seeds;
  }
  for (double& value : mean) value = std::exp(value);
  return mean;
}

TEST(FiniteFault, DoesNotDependOnTheNumberOfItsSubfaultsOrTheStep) {
  const std::vector<double> periods = {0.1, 0.3, 0.5, 1.0, 2.0};
  FiniteFault fine = moderate();
  fine.subfault_length = 2000.0;
  const auto usual = mean_spectrum(moderate(), 0.01, periods), finer = mean_spectrum(fine, 0.01, periods),
             quick = mean_spectrum(moderate(), 0.005, periods);
  for (std::size_t i = 0; i < periods.size(); ++i) {
    EXPECT_NEAR(finer[i] / usual[i], 1.0, 0.15) << periods[i];
    EXPECT_NEAR(quick[i] / usual[i], 1.0, 0.15) << periods[i];  // other random numbers too
  }
}

TEST(FiniteFault, AsperitiesMoveSlipAndKeepTheMoment) {
  FiniteFault f = moderate();
  f.asperities = {{8000.0, 8000.0, 8000.0, 8000.0, 3.0}};  // 4 of 24 subfaults
  const auto parts = subfaults(f, {}, site, 1);
  double moment = 0.0;
  for (const Subfault& s : parts) moment += s.moment;
  EXPECT_CLOSE(moment, seismic_moment(f.magnitude), 1e-12);
  const std::size_t along = 6;  // subfaults in a row
  EXPECT_CLOSE(parts[along + 1].moment, 3.0 * parts[along + 3].moment, 1e-12);
  EXPECT_CLOSE(parts[along + 3].moment, moment / (20.0 + 4.0 * 3.0), 1e-12);
}

// Mean square between two times, over seeds.
double power(const std::vector<RupturePlane>& planes, double from, double to) {
  double sum = 0.0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const auto a = simulate(planes, {}, site, 0.01, 1.0, seed, 1, 8000);
    for (auto k = static_cast<std::size_t>(100 * from); k < static_cast<std::size_t>(100 * to); ++k)
      sum += a[k] * a[k];
  }
  return sum;
}

TEST(FiniteFault, PlanesComeOneAfterTheOtherAndAdd) {
  const RupturePlane one{moderate(), {}, 0.0}, later{moderate(), {}, 40.0};
  const auto alone = simulate(moderate(), {}, site, 0.01, 1.0, 5, 1);
  auto same = simulate({one}, {}, site, 0.01, 1.0, 5, 1, alone.size());
  EXPECT_EQ(same, alone);
  const double first = power({one, later}, 0.0, 40.0), second = power({one, later}, 40.0, 80.0);
  EXPECT_CLOSE(first, power({one}, 0.0, 40.0), 1e-12);
  EXPECT_CLOSE(second, first, 0.25);  // other noise, the same motion
  // A plane that lies 10 km to the east is as one whose site lies 10 km to the west.
  const RupturePlane aside{moderate(), {10000.0, 0.0}, 0.0};
  EXPECT_EQ(simulate({aside}, {}, {site.east + 10000.0, site.north}, 0.01, 1.0, 5, 1, 100),
            simulate({one}, {}, site, 0.01, 1.0, 5, 1, 100));
}

TEST(FiniteFault, GivesTheSameBitsForASeed) {
  EXPECT_EQ(simulate(moderate(), {}, site, 0.01, 1.0, 5, 1), simulate(moderate(), {}, site, 0.01, 1.0, 5, 1));
  EXPECT_NE(simulate(moderate(), {}, site, 0.01, 1.0, 5, 1), simulate(moderate(), {}, site, 0.01, 1.0, 5, 2));
}

TEST(FaultSize, IsThatOfWellsAndCoppersmith) {
  const FaultSize size = fault_size(7.0, FaultStyle::strike_slip, 70e5);
  EXPECT_CLOSE(size.length, 1000.0 * std::pow(10.0, -2.57 + 0.62 * 7.0), 1e-12);
  EXPECT_CLOSE(size.width, 1000.0 * std::pow(10.0, -0.76 + 0.27 * 7.0), 1e-12);
  EXPECT_CLOSE(fault_size(7.0, FaultStyle::strike_slip, 560e5).length, 0.5 * size.length, 1e-12);
}

}  // namespace
}  // namespace dougong::seismic
