// A tower of ten blocks under one sine of 0.4 g: what a simulated second costs, and whether the step changes
// what becomes of it. Processor time of one core.
#include <benchmark/benchmark.h>

#include "tests/bench/settled_wall.h"
#include "tests/bench/sine_cycles.h"

namespace dougong::bench {
namespace {

constexpr int blocks = 10;
constexpr double half_width = 0.5, half_height = 0.2, friction = 0.6, young_modulus = 3e9;  // m, m, -, Pa
constexpr double amplitude = 0.4 * 9.81, duration = 4.0;                                    // m/s2, s

engine::Scene tower(double frequency) {
  engine::Scene s = scenes::column(blocks, half_width, half_height, friction, young_modulus);
  s.terrains[0].motion = scenes::sine_cycles(amplitude, frequency, 1);
  return s;
}

/// Of a block against the ground (m).
double drift(const engine::State& state, const engine::State& start, double ground, std::size_t i) {
  return state.q()[i] - start.q()[i] - ground;
}

// Arguments: step in hundredths of the bound, frequency of the sine in tenths of a hertz.
void shake(benchmark::State& bench, const char* integrator) {
  const engine::Scene scene = tower(0.1 * static_cast<double>(bench.range(1)));
  const Wall wall = settle(scene);
  engine::DriveOptions options = scenes::run_for(duration, 0.005, integrator);
  options.step_fraction = 0.01 * static_cast<double>(bench.range(0));
  double greatest = 0.0, residual = 0.0, fallen = 0.0;
  Cost cost;
  for (auto _ : bench)
    cost = run(wall, options, [&](const engine::Sample& sample) {
      const double ground = scene.terrains[0].motion->at(sample.state.time).displacement.x;
      residual = drift(sample.state, wall.settled, ground, blocks - 1);
      greatest = std::max(greatest, std::abs(residual));
      fallen = 0.0;
      for (std::size_t i = 0; i < blocks; ++i)
        fallen += wall.settled.q()[blocks + i] - sample.state.q()[blocks + i] > half_height ? 1.0 : 0.0;
      return engine::Wish::go_on;
    });
  bench.counters["s_per_simulated_s"] = cost.per_simulated_second();
  bench.counters["us_per_step"] = 1e6 * cost.per_step();
  bench.counters["step_us"] = 1e6 * cost.run.step;
  bench.counters["greatest_m"] = greatest;
  bench.counters["residual_m"] = residual;
  bench.counters["fallen"] = fallen;
  bench.counters["completed"] = cost.run.outcome == engine::Outcome::completed ? 1.0 : 0.0;
}

void steps(benchmark::internal::Benchmark* bench) {
  bench->Iterations(1)->Unit(benchmark::kSecond);
  for (const std::int64_t frequency : {20, 10, 5})
    for (const std::int64_t step : {90, 50, 25}) bench->Args({step, frequency});
}

BENCHMARK_CAPTURE(shake, velocity_verlet, "velocity-verlet")->Apply(steps);
BENCHMARK_CAPTURE(shake, symplectic_euler, "symplectic-euler")->Apply(steps);

}  // namespace
}  // namespace dougong::bench
