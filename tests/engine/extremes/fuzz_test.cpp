// Three hundred scenes at random (tests/scenes/random_scene.h); tests/bench/fuzz runs as many as one asks
// for.
#include "tests/scenes/fuzz.h"

#include <gtest/gtest.h>

namespace dougong::engine {
namespace {

TEST(RandomScene, IsTheSameEverywhere) {
  scenes::SplitMix64 random(1234567);
  EXPECT_EQ(random.next(), 6457827717110365317u);
  EXPECT_EQ(random.next(), 3203168211198807973u);
}

TEST(RandomScene, RunsToItsEndAndMakesNothingFromNothing) {
  scenes::FuzzWorst worst;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const auto f = scenes::fuzz_one(seed);
    worst.note(f);
    for (const std::string& fault : f.faults) ADD_FAILURE() << "seed " << seed << ": " << fault;
  }
  std::printf("fuzz 300 scenes: %s\n", worst.text().c_str());
}

}  // namespace
}  // namespace dougong::engine
