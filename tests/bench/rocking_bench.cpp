// Accuracy against cost of the rocking block (validation case R01): worst errors over eight impacts, by
// integrator, step, damping ratio and stiffness; and for a block of half sizes 0.2 x 0.6 m whether a quarter
// period within 0.05 % and an energy ratio within 0.5 % are to be had for 0.01 s of processor time a
// simulated second. Processor time of one core.
#include <benchmark/benchmark.h>

#include <ctime>

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

// The goal of the small block, over its first impacts.
constexpr double quarter_period_goal = 0.05, energy_ratio_goal = 0.5;  // percent
constexpr double cost_goal = 0.01;                                     // s per simulated s
constexpr std::size_t first_impacts = 3;

/// From the rest before an impact to the rest after it.
double energy_ratio(const oracles::RockingBlock& block, double amplitude_before, double amplitude_after) {
  const double before = block.spin_at_impact(amplitude_before), after = block.spin_at_impact(amplitude_after);
  return after * after / (before * before);
}

struct SmallBlockErrors {
  double quarter_period = 0.0, energy_ratio = 0.0;  // percent; the latter the worst of the impacts
};

SmallBlockErrors errors_of(const oracles::RockingBlock& block, double amplitude,
                           const std::vector<oracles::Impact>& measured) {
  SmallBlockErrors errors;
  errors.quarter_period = 100.0 * std::abs(measured[0].time / block.fall_time(amplitude) - 1.0);
  const double exact = block.velocity_ratio() * block.velocity_ratio();
  for (const oracles::Impact& impact : measured) {
    const double ratio = energy_ratio(block, amplitude, impact.amplitude_after);
    errors.energy_ratio = std::max(errors.energy_ratio, 100.0 * std::abs(ratio / exact - 1.0));
    amplitude = impact.amplitude_after;
  }
  return errors;
}

void report(benchmark::State& bench, const SmallBlockErrors& errors, double cost) {
  const bool accurate =
      errors.quarter_period <= quarter_period_goal && errors.energy_ratio <= energy_ratio_goal;
  bench.counters["quarter_period_percent"] = errors.quarter_period;
  bench.counters["energy_ratio_percent"] = errors.energy_ratio;
  bench.counters["s_per_simulated_s"] = cost;
  bench.counters["goal"] = accurate && cost <= cost_goal ? 1.0 : 0.0;
}

// Arguments: step in hundredths of the bound, damping ratio in hundredths, Young's modulus in MPa.
void small_block(benchmark::State& bench, const char* integrator) {
  const oracles::RockingBlock block{0.2, 0.6, 9.81};
  const double amplitude = 0.5 * block.alpha();
  engine::DriveOptions options = scenes::run_for(10.0, 1e-3, integrator);
  options.step_fraction = 0.01 * static_cast<double>(bench.range(0));
  SmallBlockErrors errors;
  double cost = 0.0;
  for (auto _ : bench) {
    scenes::Running running(scenes::tilted_block(block, amplitude, 1e6 * static_cast<double>(bench.range(2)),
                                                 0.01 * static_cast<double>(bench.range(1))));
    const std::clock_t start = std::clock();
    const auto measured = scenes::measured_impacts(running, options, first_impacts);
    cost = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / running.state.time;
    errors = errors_of(block, amplitude, measured);
  }
  report(bench, errors, cost);
}

void cheap_settings(benchmark::internal::Benchmark* bench) {
  bench->Iterations(1)->Unit(benchmark::kMillisecond);
  bench->ArgsProduct({{90, 50, 25}, {100, 200}, {300, 1000, 3000, 10000, 30000}});
}

BENCHMARK_CAPTURE(small_block, velocity_verlet, "velocity-verlet")->Apply(cheap_settings);
BENCHMARK_CAPTURE(small_block, symplectic_euler, "symplectic-euler")->Apply(cheap_settings);

}  // namespace
}  // namespace dougong
