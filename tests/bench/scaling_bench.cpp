// Running-bond walls of 100 to 100 000 bricks under the shaking of S1: what a brick costs a step. They start
// where the weight of the courses above presses every joint, not from a settled state: to settle the largest
// would take hours. Processor time of one core.
#include <benchmark/benchmark.h>

#include "tests/bench/peak_memory.h"
#include "tests/bench/pressed_wall.h"

namespace dougong::bench {
namespace {

// Arguments: courses, bricks of a course, simulated time (ms).
void shake(benchmark::State& bench, const char* integrator) {
  scenes::RunningBond brickwork;
  brickwork.courses = static_cast<int>(bench.range(0)), brickwork.bricks = static_cast<int>(bench.range(1));
  const Wall wall = pressed_wall(brickwork, 0.3);
  engine::DriveOptions options =
      scenes::run_for(1e-3 * static_cast<double>(bench.range(2)), 0.01, integrator);
  options.step_fraction = 0.9;
  Cost cost;
  for (auto _ : bench) cost = run(wall, options);
  const auto bricks = static_cast<double>(wall.model.body_count);
  bench.counters["bricks"] = bricks;
  bench.counters["points"] = static_cast<double>(cost.points);
  bench.counters["steps"] = static_cast<double>(cost.run.steps);
  bench.counters["us_per_step"] = 1e6 * cost.per_step();
  bench.counters["ns_per_body_step"] = 1e9 * cost.per_step() / bricks;
  bench.counters["completed"] = cost.run.outcome == engine::Outcome::completed ? 1.0 : 0.0;
  bench.counters["peak_MB"] = peak_megabytes();
}

void sizes(benchmark::internal::Benchmark* bench) {
  bench->Iterations(1)->Unit(benchmark::kSecond);
  bench->Args({10, 10, 1000})->Args({40, 25, 250})->Args({100, 100, 100})->Args({250, 400, 30});
}

BENCHMARK_CAPTURE(shake, velocity_verlet, "velocity-verlet")->Apply(sizes);
BENCHMARK_CAPTURE(shake, symplectic_euler, "symplectic-euler")->Apply(sizes);

}  // namespace
}  // namespace dougong::bench
