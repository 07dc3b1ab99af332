// Accuracy against cost of the rocking block (validation case R01): worst errors over eight impacts, by
// integrator, step, damping ratio and stiffness. Processor time of one core.
#include <benchmark/benchmark.h>

#include "tests/scenes/rocking.h"

namespace dougong {
namespace {

constexpr std::size_t impacts = 8;

struct WorstErrors {
  double time = 0.0, amplitude = 0.0;  // relative
};

WorstErrors compare(const std::vector<oracles::Impact>& measured, const std::vector<oracles::Impact>& exact) {
  WorstErrors worst;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    worst.time = std::max(worst.time, std::abs(measured[i].time / exact[i].time - 1.0));
    worst.amplitude =
        std::max(worst.amplitude, std::abs(measured[i].amplitude_after / exact[i].amplitude_after - 1.0));
  }
  return worst;
}

// Arguments: step in hundredths of the bound, damping ratio in hundredths, Young's modulus in GPa.
void rock(benchmark::State& bench, const char* integrator) {
  const oracles::RockingBlock block{0.25, 1.0, 9.81};
  const auto exact = block.impacts(0.5 * block.alpha(), static_cast<int>(impacts));
  engine::DriveOptions options = scenes::run_for(exact.back().time + 1.0, 5e-4, integrator);
  options.step_fraction = 0.01 * static_cast<double>(bench.range(0));
  WorstErrors worst;
  std::size_t counted = 0;
  for (auto _ : bench) {
    scenes::Running running(scenes::tilted_block(block, 0.5 * block.alpha(),
                                                 1e9 * static_cast<double>(bench.range(2)),
                                                 0.01 * static_cast<double>(bench.range(1))));
    const auto measured = scenes::measured_impacts(running, options, impacts);
    counted = measured.size();
    worst = compare(measured, exact);
  }
  bench.counters["impacts"] = static_cast<double>(counted);
  bench.counters["time_error_percent"] = 100.0 * worst.time;
  bench.counters["amplitude_error_percent"] = 100.0 * worst.amplitude;
}

void steps_and_damping(benchmark::internal::Benchmark* bench) {
  bench->Iterations(1)->Unit(benchmark::kMillisecond);
  for (const std::int64_t damping : {50, 100, 200})
    for (const std::int64_t step : {90, 50, 25}) bench->Args({step, damping, 30});
}

void stiffness(benchmark::internal::Benchmark* bench) {
  bench->Iterations(1)->Unit(benchmark::kMillisecond);
  for (const std::int64_t damping : {100, 200})
    for (const std::int64_t young_modulus : {3, 300, 3000}) bench->Args({50, damping, young_modulus});
}

BENCHMARK_CAPTURE(rock, velocity_verlet, "velocity-verlet")->Apply(steps_and_damping)->Apply(stiffness);
BENCHMARK_CAPTURE(rock, symplectic_euler, "symplectic-euler")->Apply(steps_and_damping);
BENCHMARK_CAPTURE(rock, rk4, "rk4")->Apply(steps_and_damping);

}  // namespace
}  // namespace dougong
