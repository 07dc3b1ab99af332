// Validation cases B02 (five storeys), B04 (one that yields), B05 (base isolation) and B06 (softening by
// gravity): bonds and joints as the springs of a shear building.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/modes.h"
#include "engine/settle.h"
#include "tests/engine/reference.h"
#include "tests/oracles/synthetic_record.h"
#include "tests/scenes/record_motion.h"
#include "tests/scenes/running.h"
#include "tests/scenes/shear_building.h"

namespace dougong::engine {
namespace {

using oracles::ChainLevel;
using oracles::ChainPeaks;
using scenes::run_for;
using scenes::Running;
using testing::expect_absolute;
using testing::expect_relative;

constexpr double interval = 0.01;  // s, of the records

std::vector<double> record(std::uint32_t seed, double amplitude) {
  return oracles::SyntheticMotion(seed, amplitude).samples(interval);
}

// What the engine finds for the levels, relative to the ground.
ChainPeaks simulated(const std::vector<ChainLevel>& levels, const std::vector<double>& acceleration) {
  const auto motion = scenes::record_motion(acceleration, interval);
  Running r(scenes::shear_building_scene(levels, motion));
  const Running start = r;
  ChainPeaks peaks;
  peaks.drift.resize(levels.size()), peaks.acceleration.resize(levels.size());
  const auto larger = [](double& most, double value) { most = std::max(most, std::abs(value)); };
  const double duration = interval * static_cast<double>(acceleration.size() - 1);
  const RunOutcome end = r.run(run_for(duration, 1e-3), [&](const Sample& sample) {
    const double ground = motion->at(sample.state.time).displacement.x;
    double below = 0.0;
    for (std::size_t i = 0; i < levels.size(); ++i) {
      const double u = r.position(i).x - start.position(i).x - ground;
      larger(peaks.drift[i], u - below);
      larger(peaks.acceleration[i], sample.accelerations[i]);
      if (i == 0) peaks.last = u;
      below = u;
    }
    larger(peaks.base_shear, sample.terrain_reaction.x);
    if (std::abs(below) > peaks.roof) peaks.roof = std::abs(below), peaks.roof_time = sample.state.time;
    return Wish::go_on;
  });
  EXPECT_EQ(end.outcome, Outcome::completed) << end.detail;
  peaks.plastic_work = r.energies().fracture;
  return peaks;
}

void compare(const std::string& name, const ChainPeaks& exact, const ChainPeaks& measured, double tolerance) {
  for (std::size_t i = 0; i < exact.drift.size(); ++i) {
    const std::string storey = "storey " + std::to_string(i + 1);
    expect_relative(name, storey + ": drift (m)", exact.drift[i], measured.drift[i], tolerance);
    expect_relative(name, storey + ": acceleration (m/s2)", exact.acceleration[i], measured.acceleration[i],
                    tolerance);
  }
  expect_relative(name, "roof displacement (m)", exact.roof, measured.roof, tolerance);
  expect_absolute(name, "its time (s)", exact.roof_time, measured.roof_time, 0.002);
}

// Frequencies f_j = (1/pi) sqrt(k/m) sin((2j - 1) pi / (4 n + 2)) of n equal storeys.
double chain_frequency(double k, double m, int n, int j) {
  return std::sqrt(k / m) / std::numbers::pi * std::sin((2 * j - 1) * std::numbers::pi / (4 * n + 2));
}

// Rayleigh's C = alpha M + beta K with a ratio xi at two frequencies (Hz). Chopra, Dynamics of
// Structures, 11.4.
struct Rayleigh {
  double alpha, beta;
};
Rayleigh rayleigh(double xi, double f1, double f2) {
  const double w1 = 2.0 * std::numbers::pi * f1, w2 = 2.0 * std::numbers::pi * f2;
  return {2.0 * xi * w1 * w2 / (w1 + w2), 2.0 * xi / (w1 + w2)};
}

std::vector<ChainLevel> equal_storeys(int n, double m, double k, double xi) {
  const Rayleigh c = rayleigh(xi, chain_frequency(k, m, n, 1), chain_frequency(k, m, n, 3));
  return std::vector<ChainLevel>(static_cast<std::size_t>(n),
                                 {.mass = m, .stiffness = k, .damping = c.beta * k, .drag = c.alpha * m});
}

void check_frequencies(const std::string& name, int n, double m, double k) {
  const Running r(scenes::shear_building_scene(equal_storeys(n, m, k, 0.05), nullptr));
  const auto modes = horizontal_modes(r.model, r.state, static_cast<std::size_t>(n));
  ASSERT_GE(modes.size(), static_cast<std::size_t>(n));
  for (int j = 1; j <= n; ++j)
    expect_relative(name, "frequency " + std::to_string(j) + " (Hz)", chain_frequency(k, m, n, j),
                    1.0 / modes[static_cast<std::size_t>(j - 1)].period(), 1e-4);
}

TEST(ShearBuilding, OracleGivesThePublishedPeaks) {
  const auto peaks =
      oracles::ShearChain(equal_storeys(5, 2e4, 3e7, 0.05)).run(record(2008, 1.0), interval, 10);
  const double drifts[] = {0.014867, 0.014298, 0.012865, 0.0098213, 0.0054315};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(peaks.drift[i] / drifts[i], 1.0, 1e-4) << i;
  EXPECT_NEAR(peaks.roof / 0.0551872, 1.0, 1e-5);
  EXPECT_NEAR(peaks.roof_time, 6.403, 1e-3);
  EXPECT_NEAR(peaks.base_shear / 446004.0, 1.0, 1e-5);
}

TEST(ShearBuilding, HasTheFrequenciesOfTheChain) {
  check_frequencies("B02", 5, 2e4, 3e7);
  check_frequencies("B02 of 3", 3, 5e4, 8e7);
  check_frequencies("B02 of 8", 8, 1e4, 2e7);
}

TEST(ShearBuilding, DriftsAsTheChainDoes) {
  const auto five = equal_storeys(5, 2e4, 3e7, 0.05), three = equal_storeys(3, 5e4, 6e7, 0.02);
  const auto first = record(2008, 1.0), second = record(2011, 2.0);
  compare("B02", oracles::ShearChain(five).run(first, interval, 10), simulated(five, first), 1e-3);
  compare("B02 of 3", oracles::ShearChain(three).run(second, interval, 10), simulated(three, second), 1e-3);
}

// One mass of 1 t on a spring that yields at uy.
std::vector<ChainLevel> yielding(double period, double xi, double hardening, double uy) {
  const double m = 1e3, w = 2.0 * std::numbers::pi / period;
  return {{.mass = m, .stiffness = m * w * w, .yield = uy, .hardening = hardening, .drag = 2.0 * xi * w * m}};
}

void check_yielding(const std::string& name, const std::vector<ChainLevel>& level,
                    const std::vector<double>& acceleration) {
  const ChainPeaks exact = oracles::ShearChain(level).run(acceleration, interval),
                   measured = simulated(level, acceleration);
  expect_relative(name, "greatest drift (m)", exact.drift[0], measured.drift[0], 1e-3);
  expect_relative(name, "drift at the end (m)", exact.last, measured.last, 2e-3);
  expect_relative(name, "plastic work (J/kg)", exact.plastic_work / 1e3, measured.plastic_work / 1e3, 2e-3);
}

TEST(YieldingStorey, OracleGivesThePublishedBranches) {
  const auto peaks = oracles::ShearChain(yielding(0.8, 0.05, 0.05, 0.02)).run(record(2008, 1.5), interval);
  EXPECT_NEAR(peaks.drift[0] / 0.08817601, 1.0, 1e-5);
  EXPECT_NEAR(peaks.plastic / 0.0441067, 1.0, 1e-4);
  EXPECT_NEAR(peaks.last / 0.0419001, 1.0, 1e-4);
  EXPECT_NEAR(peaks.plastic_work / 1e3 / 0.31473, 1.0, 1e-3);
}

TEST(YieldingStorey, FlowsAndHardensAsTheBilinearOscillatorDoes) {
  check_yielding("B04", yielding(0.8, 0.05, 0.05, 0.02), record(2008, 1.5));
  check_yielding("B04 soft", yielding(1.5, 0.03, 0.1, 0.03), record(2011, 2.0));
}

// Three storeys on a slab of the same mass, on an isolator of that period and damping ratio under all of it.
std::vector<ChainLevel> isolated(double m, double k, double period, double xi) {
  const double w = 2.0 * std::numbers::pi / period, all = 4.0 * m;
  std::vector<ChainLevel> levels(4, {.mass = m, .stiffness = k, .damping = 2.0 * 0.02 * std::sqrt(k * m)});
  levels[0].stiffness = all * w * w, levels[0].damping = 2.0 * xi * w * all;
  return levels;
}

// The published periods are those of the damped motion, which the isolator lengthens by a few parts in 1e4.
void check_periods(const std::string& name, const std::vector<ChainLevel>& levels,
                   const std::vector<double>& periods) {
  const Running r(scenes::shear_building_scene(levels, nullptr));
  const auto modes = horizontal_modes(r.model, r.state, periods.size());
  ASSERT_EQ(modes.size(), periods.size());
  for (std::size_t i = 0; i < periods.size(); ++i)
    expect_relative(name, "period " + std::to_string(i + 1) + " (s)", periods[i], modes[i].period(), 1e-3);
}

TEST(BaseIsolation, KeepsTheShakingFromTheStoreys) {
  const auto motion = record(2008, 1.2);
  const auto on_isolator = isolated(3e4, 8e7, 2.5, 0.15);
  const std::vector<ChainLevel> fixed(on_isolator.begin() + 1, on_isolator.end());
  check_periods("B05 fixed", fixed, {0.2734, 0.097574, 0.067524});
  check_periods("B05 isolated", on_isolator, {2.5095, 0.15845, 0.085999, 0.065846});
  const ChainPeaks fast = oracles::ShearChain(fixed).run(motion, interval, 20),
                   slow = oracles::ShearChain(on_isolator).run(motion, interval, 20);
  EXPECT_NEAR(fast.drift[0] / 0.017274, 1.0, 1e-4);
  EXPECT_NEAR(slow.drift[0] / 0.10176, 1.0, 1e-4);
  EXPECT_NEAR(slow.acceleration[3] / fast.acceleration[2] / 0.044064, 1.0, 1e-3);
  compare("B05 fixed", fast, simulated(fixed, motion), 1e-3);
  compare("B05 isolated", slow, simulated(on_isolator, motion), 1e-3);
}

// A mass on a rigid column that has none, on a rotational spring: w2 = (k - m g h) / (m h2 + I).
Scene on_a_spring(double mass, double height, double stiffness, double gravity) {
  Scene s = scenes::scene(0.0, 1e9);
  s.gravity = {0.0, -gravity};
  s.terrains.push_back(scenes::ground(1.0));
  Body ball = scenes::block(0.1, 0.1, {0.0, height});
  ball.mass = mass, ball.inertia = 1e-3 * mass;
  s.bodies.push_back(ball);
  Joint weld;
  weld.name = "base";
  weld.kind = JointKind::weld;
  weld.a = {true, 0}, weld.b = {false, 0};
  weld.anchor_a = {0.0, 1.0}, weld.anchor_b = {0.0, -height};
  weld.stiffness = 1e11, weld.rotational_stiffness = stiffness;
  s.joints.push_back(weld);
  return s;
}

double squared_frequency(double mass, double gravity) {
  Running r(on_a_spring(mass, 3.0, 2e5, gravity));
  EXPECT_TRUE(settle(r.model, r.state, {.unbalanced_ratio = 1e-6}).settled);
  return horizontal_modes(r.model, r.state).at(0).angular_frequency_squared;
}

TEST(InvertedPendulum, IsSoftenedByItsWeight) {
  const auto hertz = [](double squared) { return std::sqrt(squared) / (2.0 * std::numbers::pi); };
  expect_relative("B06", "frequency without gravity (Hz)", 0.750264, hertz(squared_frequency(1e3, 0.0)),
                  2e-4);
  expect_relative("B06", "frequency (Hz)", 0.692868, hertz(squared_frequency(1e3, 9.81)), 2e-4);
  EXPECT_GT(squared_frequency(0.999 * 6795.79, 9.81), 0.0);
  EXPECT_LT(squared_frequency(1.001 * 6795.79, 9.81), 0.0);
}

// The same in time: let go at a small lean, it swings with that frequency, or falls.
TEST(InvertedPendulum, SwingsOrFallsAsItsStiffnessSays) {
  Scene s = on_a_spring(1e3, 3.0, 2e5, 9.81);
  s.bodies[0].velocity.x = 0.01, s.bodies[0].spin = -0.01 / 3.0;
  Running r(s);
  ASSERT_TRUE(settle(r.model, r.state).settled);
  double last = 1.0;
  std::vector<double> crossings;
  r.run(run_for(5.0, 1e-3), [&](const Sample& sample) {
    const double x = r.position().x;
    if (sample.state.time > 0.0 && (x > 0.0) != (last > 0.0))
      crossings.push_back(sample.state.time - 1e-3 * x / (x - last));
    last = x;
    return Wish::go_on;
  });
  ASSERT_GE(crossings.size(), 5u);
  const double half = (crossings[4] - crossings[0]) / 4.0;
  expect_relative("B06", "frequency in time (Hz)", 0.692868, 0.5 / half, 1e-3);
  Scene heavy = on_a_spring(1.05 * 6795.79, 3.0, 2e5, 9.81);
  heavy.bodies[0].velocity.x = 0.01, heavy.bodies[0].spin = -0.01 / 3.0;
  Running fall(heavy);
  fall.run(run_for(16.0));
  EXPECT_LT(fall.position().y, 2.5);
}

}  // namespace
}  // namespace dougong::engine
