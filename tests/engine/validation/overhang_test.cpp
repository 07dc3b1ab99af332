// Validation case E06b: a stack of equal blocks, each hanging over the one below as far as it can.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/reference.h"
#include "tests/oracles/statics.h"
#include "tests/scenes/running.h"

namespace dougong::engine {
namespace {

using scenes::greatest_drift;
using scenes::run_for;
using scenes::Running;
using testing::expect_absolute;
using testing::text;

// The lowest block hangs over a ledge whose edge is at x = 0. Blocks from the bottom up.
Scene overhanging_stack(int count, double length, double height, double part, double young_modulus) {
  Scene s = scenes::scene(0.7, young_modulus);
  Terrain ledge = scenes::ground(20.0);
  ledge.position.x = -10.0;
  s.terrains.push_back(ledge);
  double right = 0.0;
  for (int k = count; k >= 1; --k) {
    right += part * oracles::overhang_limit(length, k);
    const double y = (count - k + 0.5) * height;
    s.bodies.push_back(scenes::block(0.5 * length, 0.5 * height, {right - 0.5 * length, y}));
  }
  return s;
}

void check_overhang(int count, double length, double height, double duration) {
  const std::string name = std::to_string(count) + " blocks of " + text(length) + " x " + text(height);
  Running stands(overhanging_stack(count, length, height, 0.99, 2e9));
  const Running start = stands;
  stands.run(run_for(duration, 0.1));
  expect_absolute("E06b", name + " drift in " + text(duration) + " s at 0.99", 0.0,
                  greatest_drift(stands, start), 1e-4);

  Running falls(overhanging_stack(count, length, height, 1.01, 30e9));
  const Running before = falls;
  double time = 0.0;
  falls.run(run_for(4.0), [&](const Sample& sample) {
    time = sample.state.time;
    return greatest_drift(falls, before) > 0.1 * length ? Wish::stop : Wish::go_on;
  });
  EXPECT_GT(greatest_drift(falls, before), 0.1 * length) << name << " does not topple at 1.01";
  std::printf("E06b %s has moved by a tenth of its length in %.3g s at 1.01\n", name.c_str(), time);
}

TEST(HarmonicOverhang, StandsJustInsideItsLimitAndTopplesJustOutside) {
  check_overhang(8, 1.0, 0.2, 60.0);
}
TEST(HarmonicOverhang, DoesSoWithOtherBlocksToo) {
  check_overhang(5, 0.6, 0.1, 10.0);
}

}  // namespace
}  // namespace dougong::engine
