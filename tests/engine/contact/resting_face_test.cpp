// Faces at rest have a light dashpot, corners that land or rock their material's; so the step follows.
#include <gtest/gtest.h>

#include "engine/settle.h"
#include "engine/stability.h"
#include "tests/scenes/rocking.h"

namespace dougong::engine {
namespace {

using scenes::run_for;
using scenes::Running;

bool all_rest(const Running& r) {
  const ContactPoints& points = r.state.contacts.points;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!points.history(i).resting) return false;
  return true;
}

double safe_step(const Running& r) {
  return plan_steps(r.model, r.state, run_for(1.0)).step;
}

TEST(RestingFace, HasALightDashpotThatAllowsALongerStep) {
  Running r(scenes::column(4, 0.25, 0.25, 0.6));
  EXPECT_FALSE(all_rest(r));
  const double before = safe_step(r),
               undamped = spectral_bound(r.model, r.state, frames_of(r.model, r.state)).stiffness;
  ASSERT_TRUE(settle(r.model, r.state).settled);
  EXPECT_TRUE(all_rest(r));
  EXPECT_GT(safe_step(r), 2.5 * before);
  EXPECT_NEAR(spectral_bound(r.model, r.state, frames_of(r.model, r.state)).stiffness, undamped,
              1e-3 * undamped);
}

TEST(RestingFace, IsRousedByACornerThatOpensAndComesToRestAgain) {
  Running r(scenes::block_on_ground(0.25, 1.0, 0.6));
  ASSERT_TRUE(settle(r.model, r.state).settled);
  const double at_rest = safe_step(r);
  r.state.v()[2] = 0.2;
  r.run(run_for(0.05));
  EXPECT_FALSE(all_rest(r));
  EXPECT_LT(safe_step(r), 0.6 * at_rest);
  r.run(run_for(8.0));
  EXPECT_TRUE(all_rest(r));
  EXPECT_NEAR(safe_step(r), at_rest, 0.01 * at_rest);
}

// Heavy everywhere or at rest light: a block that rocks loses the same.
TEST(RestingFace, LeavesHousnersLossAlone) {
  const oracles::RockingBlock block{0.25, 1.0, 9.81};
  const auto amplitudes = [&](double resting_ratio) {
    Scene s = scenes::tilted_block(block, 0.5 * block.alpha(), 30e9, 1.0);
    s.contact.resting_damping_ratio = resting_ratio;
    Running r(s);
    return scenes::measured_impacts(r, run_for(5.0, 5e-4), 6);
  };
  const auto light = amplitudes(0.2), heavy = amplitudes(1.0);
  ASSERT_EQ(light.size(), 6u);
  ASSERT_EQ(heavy.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(light[i].amplitude_after, heavy[i].amplitude_after, 1e-4 * block.alpha()) << i;
}

TEST(RestingFace, SettlesByItsCompliance) {
  constexpr int blocks = 10;
  constexpr double half = 0.25, modulus = 1e9, weight = 2400.0 * 0.25 * 9.81;
  Running r(scenes::column(blocks, half, half, 0.6, modulus));
  ASSERT_TRUE(settle(r.model, r.state).settled);
  double sinks = 0.0;
  for (int i = 0; i < blocks; ++i) {
    const double columns = i == 0 ? half : 2.0 * half;  // m, of material between the centroids
    sinks += (blocks - i) * weight * columns / (modulus * 2.0 * half);
  }
  EXPECT_NEAR((2 * blocks - 1) * half - r.position(blocks - 1).y, sinks, 1e-3 * sinks);
}

TEST(RestingFace, KeepsTheDampingRatioOfItsMaterialsIfThatIsLess) {
  Scene s = scenes::block_on_ground(0.25, 1.0, 0.6);
  s.materials[0].damping_ratio = 0.1;
  const Running r(s);
  for (std::size_t i = 0; i < r.state.contacts.points.size(); ++i)
    EXPECT_EQ(r.state.contacts.points.stiffness(i).resting, 1.0);
}

}  // namespace
}  // namespace dougong::engine
