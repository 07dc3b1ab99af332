// Blocks of very different size, and very many of them, at rest.
#include <gtest/gtest.h>

#include "engine/settle.h"
#include "tests/engine/reference.h"
#include "tests/oracles/statics.h"
#include "tests/scenes/audit.h"

namespace dougong::engine {
namespace {

using scenes::run_for;
using scenes::Running;
using testing::expect_absolute;
using testing::expect_relative;
using testing::scientific;

/// How far a block of half sizes b, h sinks into the ground: h W/(2 b E).
double sunk(double h, double young_modulus) {
  return 2400.0 * 2.0 * h * 9.81 * h / young_modulus;
}

// A large cube in equilibrium, a small one let fall on it and one beside it, along its side. The column under
// the one on top is half of both cubes long: it sinks by the half of the large one more.
void check_sizes(double large, double small, double young_modulus, double fall) {
  const double low = 0.5 * large - sunk(0.5 * large, young_modulus), half = 0.5 * small;
  Scene s = scenes::scene(0.6, young_modulus);
  s.bodies = {scenes::block(0.5 * large, 0.5 * large, {0.0, low}),
              scenes::block(half, half, {0.1 * large, low + 0.5 * large + half + fall}),
              scenes::block(half, half, {0.5 * large + half, half + fall})};
  s.terrains.push_back(scenes::ground(4.0 * large));
  Running r(s);
  const auto audit = scenes::audited(r, run_for(10.0 * std::sqrt(2.0 * fall / 9.81), 1e-3));
  const std::string name = scientific(small) + " m on and beside " + scientific(large) + " m: ";
  EXPECT_TRUE(audit.completed()) << audit.run.detail;
  const double beside = sunk(half, young_modulus), on_top = beside * (1.0 + large / small);
  const double above = r.position(1).y - r.position(0).y - 0.5 * large - half;
  expect_absolute("sizes", name + "place on top over its width", 0.0, (above + on_top) / small, 1e-6);
  expect_absolute("sizes", name + "place beside over its width", 0.0,
                  (r.position(2).y - half + beside) / small, 1e-6);
  expect_absolute("sizes", name + "speed (m/s)", 0.0, std::max(norm(r.velocity(1)), norm(r.velocity(2))),
                  1e-6);
  expect_absolute("sizes", name + "way of the large one over its width", 0.0,
                  std::abs(r.position(0).y - low) / large, 1e-8);
}

TEST(SmallBlock, RestsOnAndBesideOneAHundredThousandTimesAsLarge) {
  check_sizes(100.0, 1e-3, 1e10, 5e-3);
}
TEST(SmallBlock, DoesSoInOtherSizesToo) {
  check_sizes(10.0, 1e-2, 1e9, 2e-2);
}

// The joint above i blocks carries the n - i others: n of them sink by w/k (n + 1/2 n (n - 1) ... ), the
// lowest on half a column.
void check_tower(int count, double b, double h, double young_modulus) {
  Running r(scenes::column(count, b, h, 0.6, young_modulus));
  const SettleReport settled = settle(r.model, r.state, {.longest_time = 60.0, .unbalanced_ratio = 1e-7});
  ASSERT_TRUE(settled.settled) << settled.unbalanced_ratio << settled.detail;
  const double weight = 2400.0 * 4.0 * b * h * 9.81, k = 2.0 * b * young_modulus / (2.0 * h);
  const double joints = 0.5 * count * (count - 1.0), exact = weight / k * (joints + 0.5 * count);
  const double top = (2.0 * count - 1.0) * h - r.position(static_cast<std::size_t>(count - 1)).y;
  const std::string name = "tower of " + std::to_string(count) + ": ";
  expect_relative("tower", name + "sinks at the top (m)", exact, top, 1e-4);
  const Running start = r;
  const auto audit = scenes::audited(r, run_for(5.0));
  EXPECT_TRUE(audit.completed()) << audit.run.detail;
  expect_absolute("tower", name + "drift in 5 s over its sinking", 0.0, greatest_drift(r, start) / exact,
                  1e-5);
  expect_absolute("tower", name + "lean (rad)", 0.0, greatest_turn(r, start), 1e-9);
}

TEST(Tower, OfTwoHundredBlocksStands) {
  check_tower(200, 0.5, 0.1, 1e10);
}
TEST(Tower, OfOtherBlocksStandsToo) {
  check_tower(120, 0.3, 0.1, 5e9);
}

}  // namespace
}  // namespace dougong::engine
