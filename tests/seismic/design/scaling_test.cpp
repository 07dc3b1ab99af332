#include "seismic/design/scaling.h"

#include <numeric>

#include "seismic/design/eurocode8.h"
#include "seismic/measures/response_spectrum.h"
#include "tests/seismic/test_data.h"

namespace dougong::seismic {
namespace {

const std::vector<double>& band() {
  static const std::vector<double> periods = log_spaced_periods(0.2, 2.0, 50);
  return periods;
}

std::vector<double> target() {
  return design_spectrum(eurocode8(1, "C", 2.5)).at(band());
}

std::vector<double> spectrum_of(std::uint32_t seed) {
  return pseudo_accelerations(testing::Syn(seed, 1.0).samples(0.01), 0.01, band());
}

// Validation case P09.
TEST(ScaleFactor, MeetsP09) {
  const auto spectrum = spectrum_of(2008), wanted = target();
  EXPECT_CLOSE(scale_factor(spectrum, wanted, ScalingRule::mean_log), 1.37837402, 5e-9);
  EXPECT_CLOSE(scale_factor(spectrum, wanted, ScalingRule::least_squares), 1.20446757, 5e-9);
  EXPECT_CLOSE(scale_factor(spectrum, wanted, ScalingRule::never_below), 2.12104237, 5e-9);
}

TEST(ScaleFactor, LeastSquaresIsTheLeast) {
  const auto spectrum = spectrum_of(5), wanted = target();
  const auto error = [&](double factor) {
    double sum = 0.0;
    for (std::size_t i = 0; i < wanted.size(); ++i) sum += std::pow(factor * spectrum[i] - wanted[i], 2);
    return sum;
  };
  const double best = scale_factor(spectrum, wanted, ScalingRule::least_squares);
  EXPECT_LT(error(best), error(1.001 * best));
  EXPECT_LT(error(best), error(0.999 * best));
}

TEST(ScaleFactor, RefusesARecordOfZeros) {
  EXPECT_THROW(
      scale_factor(std::vector<double>{0.0, 1.0}, std::vector<double>{1.0, 1.0}, ScalingRule::mean_log),
      std::invalid_argument);
}

TEST(ScaleSuite, BringsTheMeanUpToTheFloor) {
  const auto wanted = target();
  std::vector<std::vector<double>> spectra;
  for (std::uint32_t seed = 1; seed <= 7; ++seed) spectra.push_back(spectrum_of(seed));
  const SuiteScaling free = scale_suite(spectra, wanted, ScalingRule::mean_log);
  EXPECT_EQ(free.common_factor, 1.0);
  EXPECT_LT(free.least_ratio, 0.9);
  const SuiteScaling held = scale_suite(spectra, wanted, ScalingRule::mean_log, 0.9);
  EXPECT_CLOSE(held.least_ratio, 0.9, 1e-12);
  EXPECT_CLOSE(held.common_factor, 0.9 / free.least_ratio, 1e-12);
  for (std::size_t r = 0; r < spectra.size(); ++r) {
    EXPECT_CLOSE(held.factors[r], held.common_factor * free.factors[r], 1e-12);
  }
  // The mean of seven is smoother than they are.
  EXPECT_LT(free.mean_misfit, std::accumulate(free.misfits.begin(), free.misfits.end(), 0.0) / 7.0);
}

TEST(SpectrumMisfit, OfTheTargetItselfIsZeroAndOfTwiceItLogTwo) {
  const auto wanted = target();
  EXPECT_NEAR(spectrum_misfit(wanted, wanted, 1.0), 0.0, 1e-15);
  EXPECT_NEAR(spectrum_misfit(wanted, wanted, 2.0), std::log(2.0), 1e-12);
}

}  // namespace
}  // namespace dougong::seismic
