// Validation cases R02s and R02c: overturning by one-cycle pulses.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/reference.h"
#include "tests/scenes/rocking.h"

namespace dougong::engine {
namespace {

using oracles::OneCyclePulse;
using oracles::RockingBlock;
using oracles::RockingHistory;
using testing::expect_relative;
using testing::text;

struct PulseCase {
  RockingBlock block;
  bool sine;
  double frequency_ratio;  // w_p/p

  OneCyclePulse pulse(double strength) const {
    return {sine, strength * block.g * block.b / block.h, frequency_ratio * block.p()};
  }
  double end_time() const { return pulse(1.0).duration() + 12.0 / block.p(); }
  std::string name() const { return sine ? "R02s" : "R02c"; }
  std::string label() const {
    return "b=" + text(block.b) + " h=" + text(block.h) + " w/p=" + text(frequency_ratio);
  }
};

RockingHistory exact(const PulseCase& c, double strength) {
  const OneCyclePulse pulse = c.pulse(strength);
  return oracles::DrivenRocking(
             c.block, [&](double t) { return pulse.acceleration(t); }, pulse.duration() / 1000.0)
      .run(c.end_time());
}

struct Settings {
  double young_modulus = 30e9, damping_ratio = 2.0, step_fraction = 0.5;
};

RockingHistory measured_with(const Settings& settings, const PulseCase& c, double strength) {
  const OneCyclePulse pulse = c.pulse(strength);
  const auto motion = scenes::horizontal_motion([=](double t) { return pulse.acceleration(t); },
                                                [=](double t) { return pulse.velocity(t); },
                                                [=](double t) { return pulse.displacement(t); });
  auto run = scenes::rocking_run(c.block, settings.young_modulus, settings.damping_ratio, motion,
                                 pulse.duration(), c.end_time());
  run.output_interval = pulse.duration() / 400.0;
  run.step_fraction = settings.step_fraction;
  return scenes::measured_rocking(run);
}
RockingHistory measured(const PulseCase& c, double strength) {
  return measured_with({}, c, strength);
}

/// "S", or "M" and the number of impacts before it overturns.
std::string mode(const RockingHistory& h) {
  return h.overturned ? "M" + std::to_string(h.impacts) : "S";
}

// Where the mode of `model` stops being `low`, between two strengths.
template <class Model>
double boundary(const PulseCase& c, Model model, const std::string& low, double from, double to,
                double tolerance) {
  while (to - from > tolerance * from) {
    const double middle = 0.5 * (from + to);
    (mode(model(c, middle)) == low ? from : to) = middle;
  }
  return 0.5 * (from + to);
}

struct Boundary {
  double strength;
  std::string below, above;
};

// The engine's boundary near the oracle's, bisected from both sides of it.
void check_boundary(const PulseCase& c, const Boundary& b, double reach, double tolerance) {
  const double from = (1.0 - reach) * b.strength, to = (1.0 + reach) * b.strength;
  const std::string label = c.label() + " " + b.below + ">" + b.above;
  ASSERT_EQ(mode(measured(c, from)), b.below) << c.name() << " " << label << " at " << from;
  ASSERT_EQ(mode(measured(c, to)), b.above) << c.name() << " " << label << " at " << to;
  expect_relative(c.name(), label, b.strength, boundary(c, measured, b.below, from, to, 5e-4), tolerance);
}

// Boundaries of the exact block below `limit`, scanned in steps of 0.02.
std::vector<Boundary> exact_boundaries(const PulseCase& c, double limit) {
  std::vector<Boundary> all;
  std::string last = "S";
  for (double strength = 1.02; strength <= limit; strength += 0.02) {
    const std::string now = mode(exact(c, strength));
    if (now == last) continue;
    all.push_back({boundary(c, exact, last, strength - 0.02, strength, 1e-6), last, now});
    last = now;
  }
  return all;
}

const RockingBlock reference{0.5, 2.0, 9.81};

TEST(OnePulseOracle, IsTheReferenceTable) {
  const auto check = [](bool sine, double ratio, std::vector<double> expected) {
    std::vector<double> found;
    for (const Boundary& b : exact_boundaries({reference, sine, ratio}, expected.back() + 0.1))
      found.push_back(b.strength);
    ASSERT_EQ(found.size(), expected.size()) << ratio;
    for (std::size_t i = 0; i < found.size(); ++i)
      EXPECT_NEAR(found[i], expected[i], 6e-5 * expected[i]) << ratio;
  };
  check(true, 1.0, {1.1308});
  check(true, 2.0, {1.2233, 2.3285, 2.3574});
  check(true, 3.0, {1.4003, 3.5459, 3.6632});
  check(true, 4.0, {1.7812, 5.0179, 5.3198});
  check(true, 6.0, {4.576, 8.5456, 9.699});
  check(false, 2.0, {1.4072, 4.2544, 5.1906});
  check(false, 3.0, {1.8529, 6.5404, 10.967});
  check(false, 4.0, {3.3506, 6.4491});
}

// On both sides of it within 1 %: the engine's boundary is then sought between.
void check_lowest(bool sine, double ratio, double strength) {
  check_boundary({reference, sine, ratio}, {strength, "S", "M1"}, 0.01, 0.02);
}
TEST(OneSinePulse, OverturnsAboveTheLowestBoundary) {
  check_lowest(true, 1.0, 1.1308);
  check_lowest(true, 2.0, 1.2233);
  check_lowest(true, 3.0, 1.4003);
  check_lowest(true, 4.0, 1.7812);
  check_lowest(true, 5.0, 2.8493);
  check_lowest(true, 6.0, 4.576);
}
TEST(OneCosinePulse, OverturnsAboveTheLowestBoundary) {
  check_lowest(false, 2.0, 1.4072);
  check_lowest(false, 3.0, 1.8529);
  check_lowest(false, 4.0, 3.3506);
}

// The window is searched from its middle.
void check_window(bool sine, double ratio, double m1_ends, double m0_starts) {
  const double reach = 0.49 * (m0_starts / m1_ends - 1.0);
  check_boundary({reference, sine, ratio}, {m1_ends, "M1", "S"}, reach, 0.05);
  check_boundary({reference, sine, ratio}, {m0_starts, "S", "M0"}, std::min(reach, 0.04), 0.05);
}
TEST(OneSinePulse, LeavesASafeWindowBetweenTheModes) {
  check_window(true, 3.0, 3.5459, 3.6632);
  check_window(true, 4.0, 5.0179, 5.3198);
}
TEST(OneCosinePulse, LeavesASafeWindowBetweenTheModes) {
  check_window(false, 2.0, 4.2544, 5.1906);
  check_boundary({reference, false, 3.0}, {6.5404, "M1", "S"}, 0.05, 0.05);
  check_boundary({reference, false, 3.0}, {10.967, "S", "M0"}, 0.05, 0.05);
}
TEST(OneCosinePulse, StandsAgainAboveM1) {
  check_boundary({reference, false, 4.0}, {6.4491, "M1", "S"}, 0.03, 0.05);
}
// Overturns after six impacts or so: how many depends on every one of them.
TEST(OneCosinePulse, OverturnsAfterManyImpactsWhenSlow) {
  const PulseCase c{reference, false, 1.0};
  EXPECT_FALSE(measured(c, 0.98 * 1.1256).overturned);
  EXPECT_TRUE(measured(c, 1.005 * 1.1256).overturned);
  std::printf("R02c w/p=1 stands at 0.98, overturns at 1.005 of 1.1256\n");
}
TEST(OneCosinePulse, DoesNotOverturnWhenFastEnough) {
  for (const double ratio : {5.0, 6.0})
    for (const double strength : {8.0, 16.0})
      EXPECT_EQ(mode(measured({reference, false, ratio}, strength)), "S") << ratio << " " << strength;
}

void check_all_boundaries(const PulseCase& c, double limit) {
  for (const Boundary& b : exact_boundaries(c, limit)) check_boundary(c, b, 0.02, 0.02);
}
TEST(OnePulse, OverturnsOtherBlocksAtTheirBoundariesToo) {
  check_all_boundaries({{0.25, 1.5, 9.81}, true, 3.5}, 3.0);
  check_all_boundaries({{0.3, 0.9, 9.81}, false, 2.5}, 3.0);
}

// The end of M1 at w/p = 3 is the boundary that knows most of the impact.
double end_of_m1(const Settings& settings) {
  const auto run = [&](const PulseCase& pulse, double strength) {
    return measured_with(settings, pulse, strength);
  };
  const double found = boundary({reference, true, 3.0}, run, "M1", 3.5, 3.56, 2e-5);
  std::printf("R02s end of M1 at w/p=3: E=%g GPa step fraction=%g %.5f error %.2g\n",
              settings.young_modulus / 1e9, settings.step_fraction, found, std::abs(found / 3.54587 - 1.0));
  return found;
}

TEST(OneSinePulse, ConvergesToTheRigidBlockAsStiffnessGrows) {
  const double rigid = 3.54587, soft = rigid - end_of_m1({3e9}), medium = rigid - end_of_m1({30e9}),
               stiff = rigid - end_of_m1({300e9});
  EXPECT_LT(medium, 0.2 * soft);
  EXPECT_LT(stiff, 0.2 * medium);
  EXPECT_LT(std::abs(stiff), 2e-4 * rigid);
}
TEST(OneSinePulse, ConvergesAsTheStepShrinks) {
  const double limit = end_of_m1({30e9, 2.0, 0.1});
  const double coarse = end_of_m1({30e9, 2.0, 0.9}) - limit, fine = end_of_m1({30e9, 2.0, 0.5}) - limit;
  EXPECT_LT(std::abs(fine), 0.5 * std::abs(coarse));
  EXPECT_LT(std::abs(coarse), 2e-4 * limit);
}

}  // namespace
}  // namespace dougong::engine
