// Running-bond walls of 100 to 100 000 bricks under the shaking of S1: what a brick costs a step. They start
// where the weight of the courses above presses every joint, not from a settled state: to settle the largest
// would take hours. Processor time of one core.
#include <benchmark/benchmark.h>

#include "tests/bench/peak_memory.h"
#include "tests/bench/settled_wall.h"

namespace dougong::bench {
namespace {

// A joint carries the courses above it; the lowest, on rigid ground, is twice as stiff.
void press(engine::Scene& scene, const scenes::RunningBond& w) {
  const double weight = w.density * w.length * w.height * -scene.gravity.y;
  const double yields = weight * w.height / (w.young_modulus * w.length);  // m, under one brick
  std::vector<double> sunk;
  for (int course = 0; course < w.courses; ++course)
    sunk.push_back((course == 0 ? 0.0 : sunk.back()) +
                   (w.courses - course) * yields * (course == 0 ? 0.5 : 1.0));
  for (engine::Body& body : scene.bodies)
    body.position.y -= sunk[static_cast<std::size_t>(body.position.y / w.height)];
}

// Arguments: courses, bricks of a course, simulated time (ms).
void shake(benchmark::State& bench, const char* integrator) {
  scenes::RunningBond brickwork;
  brickwork.courses = static_cast<int>(bench.range(0)), brickwork.bricks = static_cast<int>(bench.range(1));
  engine::Scene scene = scenes::running_bond(brickwork, scenes::sine_motion(0.3 * 9.81, 2.0));
  press(scene, brickwork);
  Wall wall{engine::compile(scene), {}};
  wall.settled = engine::initial_state(wall.model, scene);
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
