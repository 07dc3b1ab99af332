#include "engine/crew.h"

#include <gtest/gtest.h>

#include <numeric>

#include "engine/settle.h"
#include "tests/scenes/running.h"
#include "tests/scenes/running_bond.h"

namespace dougong::engine {
namespace {

using scenes::Running;

TEST(Crew, DoesEveryShareOnce) {
  for (const std::size_t threads : {1u, 2u, 3u, 8u}) {
    Crew crew(threads);
    EXPECT_EQ(crew.size(), threads);
    for (const std::size_t shares : {0u, 1u, 2u, 7u, 1000u}) {
      std::vector<int> done(shares, 0);
      crew.share(shares, [&](std::size_t k) { ++done[k]; });
      EXPECT_EQ(done, std::vector<int>(shares, 1)) << threads << " threads, " << shares << " shares";
    }
  }
}

TEST(Crew, CutsARangeTheSameWayForAnyNumberOfThreads) {
  for (const std::size_t threads : {1u, 2u, 5u}) {
    Crew crew(threads);
    std::vector<std::size_t> ends(3);
    crew.share_range(25, 10, [&](std::size_t first, std::size_t last) { ends[first / 10] = last; });
    EXPECT_EQ(ends, (std::vector<std::size_t>{10, 20, 25}));
  }
}

TEST(Crew, WaitsForItsSlowestMember) {
  Crew crew(2);
  std::vector<double> sums(2);
  for (int round = 0; round < 2000; ++round) {
    crew.share(2, [&](std::size_t k) {
      std::vector<double> values(k == 0 ? 1 : 500, 1.0);
      sums[k] = std::accumulate(values.begin(), values.end(), 0.0);
    });
    ASSERT_EQ(sums, (std::vector<double>{1.0, 500.0}));
  }
}

struct Ending {
  std::string hash;
  double damping, tangential, deepest;
  friend bool operator==(const Ending&, const Ending&) = default;
};

// A wall that falls to pieces: large enough for several shares of everything.
Ending shaken(std::size_t threads, const std::string& integrator) {
  scenes::RunningBond brickwork{.courses = 40, .bricks = 25};
  Running r(scenes::running_bond(brickwork, scenes::sine_motion(15.0, 2.0)));
  DriveOptions options = scenes::run_for(0.04, 0.02, integrator);
  options.threads = threads;
  EXPECT_EQ(r.run(options).outcome, Outcome::completed);
  return {state_hash(r.state), r.state.work.damping, r.state.work.tangential, r.state.deepest_ratio};
}

TEST(Crew, GivesTheSameBitsWhateverItsSize) {
  for (const char* integrator : {"velocity-verlet", "rk4"}) {
    const Ending alone = shaken(1, integrator);
    EXPECT_GT(alone.tangential, 0.0);
    for (const std::size_t threads : {2u, 8u})
      EXPECT_EQ(shaken(threads, integrator), alone) << integrator << ", " << threads << " threads";
  }
}

TEST(Crew, OfNoThreadsIsRefused) {
  Running r(scenes::block_on_ground(0.5, 0.2, 0.6));
  DriveOptions options = scenes::run_for(0.1);
  options.threads = 0;
  EXPECT_THROW(r.run(options), std::invalid_argument);
}

}  // namespace
}  // namespace dougong::engine
