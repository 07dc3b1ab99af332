// What two threads gain on walls of 1000 to 100 000 bricks, whose steps they share: time on the clock, one
// thread and two in turn, the least of some rounds each.
#include <benchmark/benchmark.h>

#include <chrono>

#include "tests/bench/pressed_wall.h"

namespace dougong::bench {
namespace {

struct Timed {
  double per_step = std::numeric_limits<double>::infinity();  // s
  std::string hash;
};

void run_by(std::size_t threads, const Wall& wall, double duration, Timed& least) {
  engine::State state = wall.settled;
  engine::DriveOptions options = scenes::run_for(duration, 0.01);
  options.step_fraction = 0.9;
  options.threads = threads;
  const auto start = std::chrono::steady_clock::now();
  const engine::RunOutcome run = engine::drive(wall.model, state, options, {});
  const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  least.per_step = std::min(least.per_step, took / static_cast<double>(run.steps));
  least.hash = engine::state_hash(state);
}

// Arguments: courses, bricks of a course, simulated time (ms).
void share(benchmark::State& bench) {
  constexpr int rounds = 3;
  scenes::RunningBond brickwork;
  brickwork.courses = static_cast<int>(bench.range(0)), brickwork.bricks = static_cast<int>(bench.range(1));
  const Wall wall = pressed_wall(brickwork, 0.3);
  Timed one, two;
  for (auto _ : bench)
    for (int round = 0; round < rounds; ++round) {
      run_by(1, wall, 1e-3 * static_cast<double>(bench.range(2)), one);
      run_by(2, wall, 1e-3 * static_cast<double>(bench.range(2)), two);
    }
  bench.counters["bricks"] = static_cast<double>(wall.model.body_count);
  bench.counters["us_by_one"] = 1e6 * one.per_step;
  bench.counters["us_by_two"] = 1e6 * two.per_step;
  bench.counters["gain"] = one.per_step / two.per_step;
  bench.counters["same_bits"] = one.hash == two.hash ? 1.0 : 0.0;
}

BENCHMARK(share)
    ->Iterations(1)
    ->Unit(benchmark::kSecond)
    ->Args({40, 25, 250})
    ->Args({100, 100, 100})
    ->Args({250, 400, 30});

}  // namespace
}  // namespace dougong::bench
