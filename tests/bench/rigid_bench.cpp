// Rigid contacts (moreau-jean) beside springs (velocity Verlet): the rocking block of R01, and a dry wall of
// 12 x 20 bricks at rest and shaken. What each errs or creeps, and costs. Processor time of one core.
#include <benchmark/benchmark.h>

#include <ctime>

#include "tests/scenes/rocking.h"
#include "tests/scenes/running_bond.h"

namespace dougong {
namespace {

constexpr std::size_t impacts = 8;

// Arguments: step (us), damping ratio.
void rock(benchmark::State& bench) {
  const oracles::RockingBlock block{0.25, 1.0, 9.81};
  const auto exact = block.impacts(0.5 * block.alpha(), static_cast<int>(impacts));
  const double step = 1e-6 * static_cast<double>(bench.range(0));
  engine::DriveOptions options =
      scenes::run_for(exact.back().time + 1.0, std::max(5e-4, step), "moreau-jean");
  options.step = step;
  double time = 0.0, amplitude = 0.0;
  for (auto _ : bench) {
    scenes::Running r(
        scenes::tilted_block(block, 0.5 * block.alpha(), 30e9, static_cast<double>(bench.range(1))));
    const auto measured = scenes::measured_impacts(r, options, impacts);
    for (std::size_t i = 0; i < measured.size(); ++i) {
      time = std::max(time, std::abs(measured[i].time / exact[i].time - 1.0));
      amplitude = std::max(amplitude, std::abs(measured[i].amplitude_after / exact[i].amplitude_after - 1.0));
    }
  }
  bench.counters["time_error_percent"] = 100.0 * time;
  bench.counters["amplitude_error_percent"] = 100.0 * amplitude;
}
BENCHMARK(rock)->ArgsProduct({{1000, 100, 10}, {1000, 2, 1}})->Iterations(1)->Unit(benchmark::kMillisecond);

// Arguments: amplitude of the 2 Hz shaking (g/100), duration (ms), friction (1/100). Drift at the end,
// relative to the ground, is creep as long as nothing slides.
void wall(benchmark::State& bench, const char* integrator) {
  engine::Scene s = scenes::wall(12, 20, 0.01 * static_cast<double>(bench.range(2)));
  s.terrains[0].motion = scenes::sine_motion(0.0981 * static_cast<double>(bench.range(0)), 2.0);
  engine::RunOutcome run;
  double drift = 0.0;
  std::clock_t ticks = 0;
  for (auto _ : bench) {
    scenes::Running r(s);
    const scenes::Running start = r;
    const std::clock_t begin = std::clock();
    run = r.run(scenes::run_for(1e-3 * static_cast<double>(bench.range(1)), 0.01, integrator));
    ticks = std::clock() - begin;
    const engine::Vec2 way = s.terrains[0].motion->at(r.state.time).displacement;
    for (std::size_t i = 0; i < r.bodies(); ++i)
      drift = std::max(drift, norm(r.position(i) - start.position(i) - way));
  }
  const double cpu = static_cast<double>(ticks) / CLOCKS_PER_SEC;
  bench.counters["completed"] = run.outcome == engine::Outcome::completed ? 1.0 : 0.0;
  bench.counters["drift_m"] = drift;
  bench.counters["s_per_simulated_s"] = cpu / run.end_time;
  bench.counters["us_per_step"] = 1e6 * cpu / static_cast<double>(run.steps);
  if (run.impulses.solves == 0) return;
  bench.counters["iterations_per_step"] =
      static_cast<double>(run.impulses.iterations) / static_cast<double>(run.impulses.solves);
  bench.counters["worst_residual"] = run.impulses.worst_residual;
}
BENCHMARK_CAPTURE(wall, moreau_jean, "moreau-jean")
    ->Args({0, 10000, 60})
    ->Args({30, 2000, 60})
    ->Args({80, 200, 50})
    ->Iterations(1)
    ->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(wall, velocity_verlet, "velocity-verlet")
    ->Args({0, 200, 60})
    ->Args({30, 200, 60})
    ->Args({80, 200, 50})
    ->Iterations(1)
    ->Unit(benchmark::kSecond);

}  // namespace
}  // namespace dougong
