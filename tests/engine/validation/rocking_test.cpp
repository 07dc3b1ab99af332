// Validation cases R01 and R07: free rocking, and the static thresholds of blocks and stacks.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/settle.h"
#include "tests/engine/reference.h"
#include "tests/oracles/rocking.h"
#include "tests/oracles/statics.h"
#include "tests/scenes/leaning.h"
#include "tests/scenes/rocking.h"

namespace dougong::engine {
namespace {

using scenes::measured_impacts;
using scenes::run_for;
using scenes::Running;
using scenes::tilted_block;
using scenes::topples_under;
using testing::expect_relative;
using testing::text;

void check_rocking(const oracles::RockingBlock& c, std::size_t count) {
  const double amplitude = 0.5 * c.alpha();
  const auto exact = c.impacts(amplitude, static_cast<int>(count));
  Running r(tilted_block(c, amplitude, 30e9, 1.0));
  const auto measured = measured_impacts(r, run_for(exact.back().time + 1.0, 5e-4), count);
  ASSERT_EQ(measured.size(), count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::string name = "b=" + text(c.b) + " h=" + text(c.h) + " impact " + std::to_string(i + 1) + " ";
    expect_relative("R01", name + "t", exact[i].time, measured[i].time, i == 0 ? 0.005 : 0.02);
    expect_relative("R01", name + "omega", exact[i].spin_before, measured[i].spin_before, 0.02);
    expect_relative("R01", name + "amplitude", exact[i].amplitude_after / c.alpha(),
                    measured[i].amplitude_after / c.alpha(), 0.02);
  }
}

TEST(RockingOracle, IsTheReferenceTable) {
  const oracles::RockingBlock c{0.25, 1.0, 9.81};
  EXPECT_NEAR(c.alpha(), 0.24497866, 1e-8);
  EXPECT_NEAR(c.p(), 2.6716705, 1e-7);
  const auto impacts = c.impacts(0.5 * c.alpha(), 8);
  const double times[] = {0.493803, 1.29747, 1.97939, 2.57072, 3.09035, 3.55104, 3.96205, 4.33042};
  const double spins[] = {0.565045, 0.515188, 0.46973, 0.428283, 0.390494, 0.356038, 0.324623, 0.29598};
  const double amplitudes[] = {0.386714, 0.306397, 0.246057, 0.199314,
                               0.162415, 0.132918, 0.10913,  0.0898198};
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_NEAR(impacts[i].time / times[i], 1.0, 2e-6) << i;
    EXPECT_NEAR(impacts[i].spin_before / spins[i], 1.0, 2e-6) << i;
    EXPECT_NEAR(impacts[i].amplitude_after / c.alpha() / amplitudes[i], 1.0, 3e-6) << i;
  }
}

TEST(RockingBlock, ImpactsAndDecaysAsHousnerSays) {
  check_rocking({0.25, 1.0, 9.81}, 8);
}
TEST(RockingBlock, DoesSoWithOtherProportionsToo) {
  check_rocking({0.2, 0.6, 9.81}, 4);
  check_rocking({0.4, 2.4, 9.81}, 3);
}

// Half a per cent above its threshold a stack needs acosh(100)/p to turn by half of its alpha.
void check_toppling(const oracles::Stack& c, bool by_acceleration) {
  const double alpha = c.toppling_tilt(), p = std::sqrt(0.75 * 9.81 / std::hypot(c.b, c.count * c.h));
  const double threshold = by_acceleration ? c.toppling_acceleration(1.0) : alpha;
  const std::string name = "R07 b=" + text(c.b) + " h=" + text(c.h) + " n=" + std::to_string(c.count) +
                           (by_acceleration ? " a/g" : " tilt");
  for (const double part : {0.995, 1.005}) {
    Running r(scenes::column(c.count, c.b, c.h, 0.7));
    ASSERT_TRUE(settle(r.model, r.state).settled);
    const bool toppled =
        topples_under(r, part * threshold, by_acceleration, 1.3 * std::acosh(100.0) / p, 0.5 * alpha);
    EXPECT_EQ(toppled, part > 1.0) << name << " " << part;
  }
  std::printf("%s %.6g stands at 0.995, falls at 1.005 of it\n", name.c_str(), threshold);
}

TEST(StackOfBlocks, TopplesAtItsThresholdAcceleration) {
  for (const int n : {1, 2, 3, 5}) check_toppling({0.25, 1.0, n}, true);
}
TEST(StackOfBlocks, TopplesAtItsThresholdTilt) {
  for (const int n : {1, 2, 3}) check_toppling({0.25, 1.0, n}, false);
}
TEST(StackOfBlocks, TopplesAtItsThresholdWithOtherProportionsToo) {
  check_toppling({0.4, 0.8, 2}, true);
  check_toppling({0.4, 0.8, 2}, false);
}

bool slides_under(double mu, double load, bool keep_vertical_part) {
  Running r(scenes::block_on_ground(1.0, 0.2, mu));
  EXPECT_TRUE(settle(r.model, r.state).settled);
  const double start = r.position().x;
  topples_under(r, load, keep_vertical_part, 1.0, 1.0);
  return std::abs(r.position().x - start) > 1e-3;
}

TEST(LowBlock, SlidesAtTheFrictionAngleAndAtMuG) {
  for (const double mu : {0.7, 0.3}) {
    for (const double part : {0.995, 1.005}) {
      EXPECT_EQ(slides_under(mu, part * std::atan(mu), false), part > 1.0) << "tilt " << mu << " " << part;
      EXPECT_EQ(slides_under(mu, part * mu, true), part > 1.0) << "acceleration " << mu << " " << part;
    }
    std::printf("R07 mu=%.2g slides at tilt %.6g and at a/g %.6g bracketed 0.005 0.005\n", mu, std::atan(mu),
                mu);
  }
}

// The same threshold by a ground that really accelerates, from rest and slowly enough.
TEST(RockingBlock, TopplesOnAGroundThatAcceleratesAtItsThreshold) {
  const double rise = 1.0, b = 0.25, h = 1.0;
  for (const double part : {0.995, 1.005}) {
    const double a = part * 9.81 * b / h;
    const auto acceleration = [=](double t) { return t < rise ? a * t / rise : a; };
    const auto velocity = [=](double t) { return t < rise ? 0.5 * a * t * t / rise : a * (t - 0.5 * rise); };
    const auto displacement = [=](double t) {
      const double s = t - rise;
      return t < rise ? a * t * t * t / (6 * rise) : a * (rise * rise / 6 + 0.5 * rise * s + 0.5 * s * s);
    };
    Scene s = scenes::block_on_ground(b, h, 0.7, 300e9);
    s.terrains[0] =
        scenes::ground(2000.0, {}, 0.0, scenes::horizontal_motion(acceleration, velocity, displacement));
    Running r(s);
    ASSERT_TRUE(settle(r.model, r.state).settled);
    double largest = 0.0;
    r.run(run_for(4.0), [&](const Sample&) {
      largest = std::max(largest, std::abs(r.angle()));
      return largest > 0.06 ? Wish::stop : Wish::go_on;
    });
    EXPECT_EQ(largest > 0.06, part > 1.0) << part << " " << largest;
  }
}

TEST(StandingBlock, LoadsItsCornersAsTheMomentSays) {
  struct Case {
    double b, h, a;
  };
  for (const auto& [b, h, a] : {Case{0.25, 1.0, 0.15}, Case{0.4, 0.6, 0.3}}) {
    Running r(scenes::block_on_ground(b, h, 0.7));
    r.model.gravity = {a * 9.81, -9.81};
    SettleOptions options;
    options.unbalanced_ratio = 1e-7;
    ASSERT_TRUE(settle(r.model, r.state, options).settled);
    const double share = oracles::loaded_corner_share(b, h, a, 1.0), weight = r.model.mass[0] * 9.81;
    for (const auto& f : scenes::point_forces(r.model, r.state)) {
      const bool loaded = f.place.x > r.state.q()[0];
      expect_relative("R07", "a=" + text(a) + "g " + (loaded ? "loaded" : "unloaded") + " corner/W",
                      loaded ? share : 1.0 - share, f.normal / weight, 0.005);
    }
  }
}

// Two columns and a lintel laid on them, turned by `tilt` about the right corners of the columns. The mass
// of the lintel is gamma times that of the columns.
Scene frame(const oracles::RockingBlock& c, double tilt, double young_modulus, double damping_ratio) {
  Scene s = scenes::scene(2.0, young_modulus, damping_ratio);
  const double span = 4.0, depth = 0.25;
  Vec2 top;  // between the left upper corners
  for (const double x : {-0.5 * span, 0.5 * span}) {
    s.bodies.push_back(scenes::block(c.b, c.h, Vec2{x, 0.0} + rotated({-c.b, c.h}, -tilt), -tilt));
    top += 0.5 * (Vec2{x, 0.0} + rotated({-2.0 * c.b, 2.0 * c.h}, -tilt));
  }
  s.bodies.push_back(scenes::block(0.5 * span + 2.0 * c.b, depth, top + Vec2{c.b, depth}));
  s.bodies.back().mass = c.lintel * 2.0 * 2400.0 * 4.0 * c.b * c.h;
  s.terrains.push_back(scenes::ground());
  return s;
}

void check_frame(const oracles::RockingBlock& c, std::size_t count) {
  const auto exact = c.impacts(0.5 * c.alpha(), static_cast<int>(count));
  Running r(frame(c, 0.5 * c.alpha(), 30e9, 2.0));
  const auto measured = measured_impacts(r, run_for(exact.back().time + 1.0, 5e-4), count);
  ASSERT_EQ(measured.size(), count);
  for (std::size_t i = 0; i < count; ++i)
    expect_relative("R08",
                    "b=" + text(c.b) + " h=" + text(c.h) + " gamma=" + text(c.lintel) + " impact " +
                        std::to_string(i + 1) + " t",
                    exact[i].time, measured[i].time, i == 0 ? 0.01 : 0.02);
}

TEST(RockingFrame, RocksAsABlockOfTheSameSlenderness) {
  const oracles::RockingBlock reference{0.3, 1.5, 9.81, 1.0};
  EXPECT_NEAR(reference.p(), 1.89929, 1e-5);
  EXPECT_NEAR(reference.velocity_ratio(), 0.927885, 1e-6);
  const auto impacts = reference.impacts(0.5 * reference.alpha(), 4);
  const double times[] = {0.694187, 1.86368, 2.88006, 3.77906};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(impacts[i].time / times[i], 1.0, 3e-6);
  check_frame(reference, 4);
}
TEST(RockingFrame, DoesSoWithOtherProportionsToo) {
  check_frame({0.25, 1.0, 9.81, 2.0}, 3);
}

TEST(RockingFrame, UpliftsAtTheAccelerationOfItsColumnsWhateverTheLintel) {
  for (const double gamma : {0.2, 1.0, 3.0}) {
    const oracles::RockingBlock c{0.3, 1.5, 9.81, gamma};
    for (const double part : {0.995, 1.005}) {
      Running r(frame(c, 0.0, 30e9, 1.0));
      ASSERT_TRUE(settle(r.model, r.state).settled);
      const bool rocks = topples_under(r, part * c.b / c.h, true, 3.0, 0.1 * c.alpha());
      EXPECT_EQ(rocks, part > 1.0) << "gamma " << gamma << " part " << part;
    }
    std::printf("R08 gamma=%g stands at 0.995, rocks at 1.005 of %g g\n", gamma, c.b / c.h);
  }
}

}  // namespace
}  // namespace dougong::engine
