#include "seismic/synthesis/compatible_motion.h"

#include <gmock/gmock.h>

#include "seismic/design/eurocode8.h"
#include "seismic/design/gb50011.h"
#include "seismic/measures/integrate.h"
#include "seismic/measures/response_spectrum.h"
#include "tests/seismic/test_data.h"

namespace dougong::seismic {
namespace {

TEST(CompatibleMotion, FollowsItsTarget) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    CompatibleOptions options;
    options.seed = seed;
    const CompatibleMotion m = compatible_motion(design_spectrum(eurocode8(1, "C", 2.5)), options);
    EXPECT_LT(m.misfit, 0.05) << seed;
    EXPECT_GT(m.least_ratio, 0.8) << seed;
    EXPECT_LT(m.greatest_ratio, 1.25) << seed;
    const auto h = integrate(m.acceleration, options.interval);
    EXPECT_NEAR(h.velocity.back(), 0.0, 1e-10);
    EXPECT_NEAR(h.displacement.back(), 0.0, 1e-9);
  }
}

TEST(CompatibleMotion, TakesTheDampingOfTheTarget) {
  const DesignSpectrum target = design_spectrum(Gb50011{0.9, 0.45, 0.02});
  const CompatibleMotion m = compatible_motion(target, {});
  const double psa = spectral_point(m.acceleration, 0.01, 0.5, {0.02, 1}).pseudo_acceleration;
  EXPECT_NEAR(psa / target.at(0.5), 1.0, 0.15);
}

TEST(CompatibleMotion, RefusesABandBeyondItsTarget) {
  CompatibleOptions options;
  options.longest_period = 5.0;
  EXPECT_THAT(
      testing::input_error([&] { compatible_motion(design_spectrum(eurocode8(1, "C", 2.5)), options); }),
      ::testing::HasSubstr("0 s to 4 s"));
}

}  // namespace
}  // namespace dougong::seismic
