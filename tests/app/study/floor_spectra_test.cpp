#include "app/study/floor_spectra.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

namespace dougong::app {
namespace {

/// One floor that shakes as a sine, without end, and a ground that shakes half as much.
RunResult sine(double amplitude, double period, std::size_t count) {
  RunResult run;
  run.response.storeys.resize(1);
  run.response.storeys[0].name = "S1";
  run.motion.interval = 0.01;
  for (std::size_t k = 0; k < count; ++k) {
    const double t = 0.01 * static_cast<double>(k);
    const double a = amplitude * std::sin(2.0 * std::numbers::pi * t / period);
    run.response.times.push_back(t);
    run.response.storeys[0].floor_acceleration.push_back(a);
    run.motion.times.push_back(t);
    run.motion.acceleration_x.push_back(0.5 * a);
  }
  return run;
}

double at(const FloorSpectra& spectra, const std::vector<double>& psa, double period) {
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < psa.size(); ++i)
    if (std::abs(spectra.periods[i] - period) < std::abs(spectra.periods[nearest] - period)) nearest = i;
  return psa[nearest];
}

// An oscillator of 5 % damping in resonance with a lasting sine has 1/(2 x 0.05) = 10 times its amplitude; a
// stiff one the amplitude itself.
TEST(FloorSpectra, AmplifyASineTenTimesInResonance) {
  const FloorSpectra spectra = floor_spectra(sine(2.0, 1.0, 6000));
  ASSERT_EQ(spectra.floors.size(), 1u);
  EXPECT_NEAR(at(spectra, spectra.floors[0].psa, 1.0), 20.0, 0.4);
  // At a tenth of the period: 1/(1 - 0.1^2) of it, and at most 1/(1 - 0.1) while the start still rings.
  EXPECT_GE(spectra.floors[0].psa.front(), 2.0);
  EXPECT_LE(spectra.floors[0].psa.front(), 2.0 / 0.9);
  EXPECT_NEAR(at(spectra, spectra.ground, 1.0), 10.0, 0.2);
}

TEST(FloorSpectra, EndWithTheLossOfTheStorey) {
  RunResult run = sine(2.0, 1.0, 4000);
  run.response.storeys[0].lost_at = 20.0;
  for (std::size_t k = 2000; k < 4000; ++k) run.response.storeys[0].floor_acceleration[k] = 1e3;
  EXPECT_LT(at(floor_spectra(run), floor_spectra(run).floors[0].psa, 1.0), 21.0);
}

TEST(FloorSpectra, BeginAtTenOutputIntervals) {
  EXPECT_NEAR(floor_spectra(sine(1.0, 1.0, 100)).periods.front(), 0.1, 1e-12);
}

TEST(FloorSpectra, AreNoneWithoutHistories) {
  EXPECT_TRUE(floor_spectra(RunResult{}).floors.empty());
}

}  // namespace
}  // namespace dougong::app
