#include "seismic/measures/bilinear_oscillator.h"

#include "seismic/measures/response_spectrum.h"
#include "tests/seismic/test_data.h"

namespace dougong::seismic {
namespace {

std::vector<double> record(double amplitude) {
  return testing::Syn(2008, amplitude).samples(0.01);
}

// Validation case B04, whose peaks are read at the samples: up to (w h)^2/8 = 8e-4 below, here 4e-6.
TEST(BilinearOscillator, MeetsB04) {
  const BilinearResponse r = bilinear_response(record(1.5), 0.01, {{0.8, 0.05}, 0.02, 0.05});
  EXPECT_CLOSE(r.peak_displacement, 0.08817601, 4e-6);
  EXPECT_CLOSE(r.plastic_displacement, 0.0441067, 1e-6);
  EXPECT_CLOSE(r.last_displacement, 0.0419001, 2e-6);
  EXPECT_CLOSE(r.plastic_work, 0.31473, 1e-5);
  EXPECT_EQ(r.branch_changes, 32);
}

TEST(BilinearOscillator, ThatDoesNotYieldIsTheElasticOne) {
  const auto a = record(1.5);
  const BilinearResponse r = bilinear_response(a, 0.01, {{0.8, 0.05}});
  EXPECT_CLOSE(r.peak_displacement, 0.0935353, 4e-6);
  EXPECT_CLOSE(r.peak_displacement, spectral_point(a, 0.01, 0.8, {0.05, 1, true}).displacement, 1e-6);
  EXPECT_EQ(r.branch_changes, 0);
  EXPECT_EQ(r.plastic_displacement, 0.0);
  // With all of its stiffness left, yielding changes nothing.
  EXPECT_CLOSE(bilinear_response(a, 0.01, {{0.8, 0.05}, 0.001, 1.0}).peak_displacement, r.peak_displacement,
               1e-12);
}

// What the ground puts in is dissipated, or still moves: for a perfectly plastic oscillator, twice as fine a
// record of the same interpolant gives the same motion.
TEST(BilinearOscillator, DoesNotDependOnHowTheInterpolantIsSampled) {
  const auto a = record(3.0);
  std::vector<double> fine;
  for (std::size_t k = 0; k + 1 < a.size(); ++k) fine.insert(fine.end(), {a[k], 0.5 * (a[k] + a[k + 1])});
  fine.push_back(a.back());
  for (const double period : {0.1, 0.5, 2.0}) {
    const BilinearOscillator o{{period, 0.02}, 0.004, 0.0};
    const BilinearResponse coarse = bilinear_response(a, 0.01, o), finer = bilinear_response(fine, 0.005, o);
    EXPECT_CLOSE(coarse.peak_displacement, finer.peak_displacement, 1e-9) << period;
    EXPECT_CLOSE(coarse.plastic_displacement, finer.plastic_displacement, 1e-8) << period;
    EXPECT_EQ(coarse.branch_changes, finer.branch_changes) << period;
  }
}

// Constant acceleration a > w^2 u_y: a perfectly plastic mass without damping yields for good.
TEST(BilinearOscillator, RunsAwayUnderMoreThanItsStrength) {
  const double w = 2 * std::numbers::pi / 0.5, strength = 1.0, yield = strength / (w * w), a = 1.5;
  const BilinearResponse r = bilinear_response(std::vector<double>(201, a), 0.01, {{0.5, 0.0}, yield, 0.0});
  // Elastic: u = (a/w^2)(1 - cos wt) to u_y, then u'' = -(a - strength).
  const double t = std::acos(1.0 - strength / a) / w, v = a / w * std::sin(w * t), rest = 2.0 - t;
  EXPECT_CLOSE(r.peak_displacement, yield + v * rest + 0.5 * (a - strength) * rest * rest, 1e-10);
  EXPECT_CLOSE(r.peak_force, strength, 1e-12);
  EXPECT_EQ(r.branch_changes, 1);
}

TEST(ConstantDuctility, FindsTheStrengthThatGivesIt) {
  const auto a = record(1.5);
  for (const double period : {0.2, 0.8, 2.0}) {
    const DuctilityPoint p = constant_ductility(a, 0.01, {period, 0.05}, 4.0, 0.03);
    const BilinearResponse r = bilinear_response(a, 0.01, {{period, 0.05}, p.yield_displacement, 0.03});
    EXPECT_CLOSE(r.peak_displacement / p.yield_displacement, 4.0, 1e-6) << period;
    EXPECT_GT(p.strength_reduction, 1.0);
    EXPECT_CLOSE(p.inelastic_ratio, 4.0 / p.strength_reduction, 1e-6);
  }
  EXPECT_EQ(constant_ductility(a, 0.01, {0.8, 0.05}, 1.0).strength_reduction, 1.0);
}

TEST(ConstantDuctility, OfARecordOfZerosIsZero) {
  const DuctilityPoint p = constant_ductility(std::vector<double>(100, 0.0), 0.01, {0.8, 0.05}, 4.0);
  EXPECT_EQ(p.yield_displacement, 0.0);
  EXPECT_EQ(p.ductility, 0.0);
}

}  // namespace
}  // namespace dougong::seismic
