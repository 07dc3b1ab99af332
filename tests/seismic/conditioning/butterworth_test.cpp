#include "seismic/conditioning/butterworth.h"

#include "seismic/conditioning/taper.h"
#include "seismic/measures/peaks.h"
#include "tests/seismic/test_data.h"

namespace dougong::seismic {
namespace {

std::vector<double> filtered_a() {
  const auto a = testing::record_a();
  auto padded_a = padded(a, 2000, 2000);
  filter_both_ways(butterworth({0.1, 15.0, 4}, 0.01), padded_a);
  return {padded_a.begin() + 2000, padded_a.end() - 2000};
}

// Validation case P03: order 4 prototype (8 poles), 20 s of zeros on both sides.
TEST(Butterworth, MeetsP03) {
  const auto y = filtered_a();
  EXPECT_CLOSE(y[500], 0.984080944, 1e-8);
  EXPECT_CLOSE(y[800], 1.07882584, 1e-8);
  EXPECT_CLOSE(y[1000], 0.041610714, 1e-7);
  EXPECT_CLOSE(y[1500], 0.0967929594, 1e-8);
  EXPECT_CLOSE(peak(y, 0.01).value, 2.64990529, 1e-8);
  EXPECT_CLOSE(root_mean_square(y), 0.385831381, 1e-8);
}

TEST(Butterworth, HasTheTwoPassGainOfP03) {
  const auto sections = butterworth({0.1, 15.0, 4}, 0.01);
  const auto two_pass = [&](double f) { return std::pow(gain(sections, f, 0.01), 2); };
  EXPECT_NEAR(two_pass(0.1), 0.5, 1e-9);
  EXPECT_NEAR(two_pass(1.0), 1.0, 1e-6);
  EXPECT_NEAR(two_pass(15.0), 0.5, 1e-9);
  EXPECT_CLOSE(two_pass(30.0), 0.000337845, 2e-6);
  EXPECT_EQ(sections.size(), 4u);
}

TEST(Butterworth, HighAndLowPassHaveTheirCornersAndFlatBands) {
  const auto high = butterworth({0.5, {}, 4}, 0.01), low = butterworth({{}, 10.0, 6}, 0.01);
  EXPECT_NEAR(gain(high, 0.5, 0.01), std::sqrt(0.5), 1e-10);
  EXPECT_NEAR(gain(high, 20.0, 0.01), 1.0, 1e-5);
  EXPECT_NEAR(gain(high, 0.0, 0.01), 0.0, 1e-12);
  EXPECT_NEAR(gain(low, 10.0, 0.01), std::sqrt(0.5), 1e-10);
  EXPECT_NEAR(gain(low, 0.0, 0.01), 1.0, 1e-12);
}

// |H|^2 = 1/(1 + x^(2n)), x = w/wc, wc/w or (w^2 - w0^2)/(B w) of the pre-warped frequencies.
TEST(Butterworth, OfAnyOrderHasTheGainOfItsClosedForm) {
  const double dt = 0.01;
  const auto warp = [&](double f) { return std::tan(std::numbers::pi * f * dt); };
  const auto closed = [](double x, int order) { return 1.0 / std::sqrt(1.0 + std::pow(x * x, order)); };
  for (int order = 1; order <= 9; ++order) {
    for (const double f : {0.05, 0.3, 2.0, 12.0, 30.0}) {
      const double w = warp(f), low = warp(0.2), high = warp(15.0);
      EXPECT_NEAR(gain(butterworth({{}, 15.0, order}, dt), f, dt), closed(w / high, order), 1e-9)
          << order << f;
      EXPECT_NEAR(gain(butterworth({0.2, {}, order}, dt), f, dt), closed(low / w, order), 1e-9) << order << f;
      EXPECT_NEAR(gain(butterworth({0.2, 15.0, order}, dt), f, dt),
                  closed((w * w - low * high) / ((high - low) * w), order), 1e-9)
          << order << f;
    }
  }
}

TEST(Butterworth, DoesNotShiftAPulse) {
  std::vector<double> x(2001, 0.0);
  x[1000] = 1.0;
  filter_both_ways(butterworth({0.5, 10.0, 4}, 0.01), x);
  EXPECT_EQ(peak(x, 0.01).index, 1000u);
  for (std::size_t k = 1; k < 400; ++k) EXPECT_NEAR(x[1000 - k], x[1000 + k], 1e-9);
}

TEST(Butterworth, RefusesCornersThatMakeNoBand) {
  EXPECT_THROW(butterworth({0.1, 60.0, 4}, 0.01), std::invalid_argument);
  EXPECT_THROW(butterworth({5.0, 1.0, 4}, 0.01), std::invalid_argument);
  EXPECT_THROW(butterworth({0.0, 1.0, 4}, 0.01), std::invalid_argument);
  EXPECT_THROW(butterworth({0.1, 10.0, 13}, 0.01), std::invalid_argument);
}

}  // namespace
}  // namespace dougong::seismic
