// A tower of ten blocks under one sine of 0.4 g: what a simulated second costs, and whether the step changes
// what becomes of it. Processor time of one core.
#include <benchmark/benchmark.h>

#include "tests/bench/settled_wall.h"
#include "tests/bench/sine_cycles.h"

namespace dougong::bench {
namespace {

constexpr std::size_t blocks = 10;
constexpr double half_width = 0.5, half_height = 0.2, friction = 0.6, young_modulus = 3e9;  // m, m, -, Pa
constexpr double amplitude = 0.4 * 9.81, duration = 4.0;                                    // m/s2, s

engine::Scene tower(double frequency) {
  engine::Scene s =
      scenes::column(static_cast<int>(blocks), half_width, half_height, friction, young_modulus);
  s.terrains[0].motion = scenes::sine_cycles(amplitude, frequency, 1);
  return s;
}

/// What becomes of the tower.
struct Fate {
  double greatest = 0.0, residual = 0.0;  // m, drift of the top block against the ground
  int fallen = 0;                         // blocks lower by more than half their height

  void note(const engine::State& settled, const engine::State& state, double ground) {
    residual = state.q()[blocks - 1] - settled.q()[blocks - 1] - ground;
    greatest = std::max(greatest, std::abs(residual));
    fallen = 0;
    for (std::size_t i = blocks; i < 2 * blocks; ++i)
      fallen += settled.q()[i] - state.q()[i] > half_height ? 1 : 0;
  }
};

void report(benchmark::State& bench, const Cost& cost, const Fate& fate) {
  bench.counters["s_per_simulated_s"] = cost.per_simulated_second();
  bench.counters["us_per_step"] = 1e6 * cost.per_step();
  bench.counters["step_us"] = 1e6 * cost.run.step;
  bench.counters["greatest_m"] = fate.greatest;
  bench.counters["residual_m"] = fate.residual;
  bench.counters["fallen"] = fate.fallen;
  bench.counters["completed"] = cost.run.outcome == engine::Outcome::completed ? 1.0 : 0.0;
}

// Arguments: step in hundredths of the bound, frequency of the sine in tenths of a hertz.
void shake(benchmark::State& bench, const char* integrator) {
  const engine::Scene scene = tower(0.1 * static_cast<double>(bench.range(1)));
  const engine::PrescribedMotion& motion = *scene.terrains[0].motion;
  const Wall wall = settle(scene);
  engine::DriveOptions options = scenes::run_for(duration, 0.005, integrator);
  options.step_fraction = 0.01 * static_cast<double>(bench.range(0));
  Cost cost;
  Fate fate;
  for (auto _ : bench)
    cost = run(wall, options, [&](const engine::Sample& sample) {
      fate.note(wall.settled, sample.state, motion.at(sample.state.time).displacement.x);
      return engine::Wish::go_on;
    });
  report(bench, cost, fate);
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
