#include "seismic/conditioning/resample.h"

#include "seismic/measures/peaks.h"
#include "tests/seismic/test_data.h"

namespace dougong::seismic {
namespace {

// Greatest error against the analytic motion within 2..38 s, over the PGA.
double error_of(double from, double to, ResampleMethod method) {
  const testing::Syn syn(2008, 1.0);
  const auto a = syn.samples(from);
  const auto b = resample(a, from, to, method);
  double worst = 0.0;
  for (std::size_t k = 0; k < b.size(); ++k) {
    const double t = to * static_cast<double>(k);
    if (t >= 2.0 && t <= 38.0) worst = std::max(worst, std::abs(b[k] - syn.at(t)));
  }
  return worst / 2.634698442;
}

// Validation case P04: 0.01 s to 0.004 s.
TEST(Resample, ByFftMeetsTheAnalyticMotionP04) {
  const double error = error_of(0.01, 0.004, ResampleMethod::fft);
  EXPECT_LT(error, 1e-11);
}

TEST(Resample, LinearHasTheErrorOfP04) {
  EXPECT_NEAR(error_of(0.01, 0.004, ResampleMethod::linear), 0.033, 0.0005);
}

TEST(Resample, BySplineHasTheErrorOfP04) {
  EXPECT_NEAR(error_of(0.01, 0.004, ResampleMethod::spline), 0.00085, 0.00002);
  const std::vector<double> two = {0.0, 1.0};
  EXPECT_EQ(resample(two, 0.01, 0.005, ResampleMethod::spline).size(), 3u);
}

TEST(Resample, TakesRatiosThatAreNotRational) {
  EXPECT_LT(error_of(0.01, 0.01 / std::numbers::pi, ResampleMethod::fft), 1e-9);
  EXPECT_LT(error_of(0.01, 0.0123456, ResampleMethod::fft), 1e-9);  // new Nyquist 40.5 Hz, motion below 20 Hz
}

TEST(Resample, ToALongerStepDropsWhatItCannotCarry) {
  std::vector<double> x;
  for (int k = 0; k < 2000; ++k) x.push_back(std::sin(2 * std::numbers::pi * 30.0 * 0.01 * k));
  const auto y = resample(x, 0.01, 0.05);  // new Nyquist 10 Hz: aliased it would stay of size 1
  double worst = 0.0;
  for (std::size_t k = 60; k + 60 < y.size(); ++k) worst = std::max(worst, std::abs(y[k]));
  EXPECT_LT(worst, 0.02);
}

TEST(Resample, KeepsEndsAndDuration) {
  const auto a = testing::Syn(2011, 1.0).samples(0.01);
  const auto b = resample(a, 0.01, 0.004);
  EXPECT_EQ(b.size(), 10001u);
  EXPECT_NEAR(b.front(), a.front(), 1e-9);
  EXPECT_NEAR(b.back(), a.back(), 1e-9);
}

TEST(Resample, KeepsTheOldSamplesWhenItSubdivides) {
  std::vector<double> x;
  for (int k = 0; k < 300; ++k) x.push_back(std::sin(0.7 * k) + (k % 2 ? 0.3 : -0.3));  // with a Nyquist term
  const auto y = resample(x, 0.02, 0.01);
  for (std::size_t k = 0; k < x.size(); ++k) EXPECT_NEAR(y[2 * k], x[k], 1e-9);
}

}  // namespace
}  // namespace dougong::seismic
