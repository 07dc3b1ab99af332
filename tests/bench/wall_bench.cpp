// What a simulated second, a step and a contact point of a wall of 1000 bricks cost: of the wall S1, by which
// engines are compared, and of the same bricks as a layout under 20 s of the shipped Wenchuan-style record at
// 0.3 g. Processor time of one core.
#include <benchmark/benchmark.h>

#include "app/study/motion_input.h"
#include "structures/layouts/layout.h"
#include "tests/bench/peak_memory.h"
#include "tests/bench/settled_wall.h"

namespace dougong::bench {
namespace {

constexpr double window = 20.0;  // s, the strongest part of the record

std::shared_ptr<const seismic::GroundMotion> strong_window() {
  app::RecordChoice choice;
  choice.name = "wenchuan";
  seismic::ConditioningOptions options;
  options.from = 5.0;
  options.to = 5.0 + window - 10.0;  // the kept pads of 5 s on each side make up the rest
  options.target_pga = 0.3 * engine::standard_gravity;
  options.vertical = false;
  const auto records = app::read_scenario_record(choice, DOUGONG_RECORDS_DIRECTORY);
  return std::make_shared<const seismic::GroundMotion>(seismic::condition(records, options).ground_motion());
}

// 40 courses of 25 bricks: 20 x 25 whole ones and 20 x (24 whole and 2 halves) are 1020 blocks.
const Wall& wall() {
  static const Wall instance = [] {
    structures::Building building = structures::build_layout("brick-wall", {{"courses", 40.0},
                                                                            {"bricks_per_course", 25.0},
                                                                            {"brick_length", 0.25},
                                                                            {"brick_height", 0.0625},
                                                                            {"young_modulus", 1e8}});
    building.scene.terrains[0].motion = strong_window();
    return settle(building.scene);
  }();
  return instance;
}

void run_wall(benchmark::State& bench, const Wall& w, const engine::DriveOptions& options) {
  Cost cost;
  for (auto _ : bench) cost = run(w, options);
  bench.counters["s_per_simulated_s"] = cost.per_simulated_second();
  bench.counters["us_per_step"] = 1e6 * cost.per_step();
  bench.counters["ns_per_point_step"] = 1e9 * cost.per_step() / static_cast<double>(cost.points);
  bench.counters["bricks"] = static_cast<double>(w.model.body_count);
  bench.counters["points"] = static_cast<double>(cost.points);
  bench.counters["step_us"] = 1e6 * cost.run.step;
  bench.counters["completed"] = cost.run.outcome == engine::Outcome::completed ? 1.0 : 0.0;
  bench.counters["peak_MB"] = peak_megabytes();
}

// The argument is how much of the 20 s is run, in tenths of a second.
void shake(benchmark::State& bench, const char* integrator) {
  engine::DriveOptions options;
  options.integrator = integrator;
  options.end_time = 0.1 * static_cast<double>(bench.range(0));
  run_wall(bench, wall(), options);
}

// 1020 bricks with open head joints that settle by so many micrometres, shaken at 2 Hz by so many hundredths
// of g, for so many tenths of a second, with a damping ratio of so many hundredths.
void s1(benchmark::State& bench, const char* integrator) {
  const Wall w =
      settle(s1_scene(1e-6 * static_cast<double>(bench.range(0)), 0.01 * static_cast<double>(bench.range(1)),
                      0.01 * static_cast<double>(bench.range(3))));
  engine::DriveOptions options = scenes::run_for(0.1 * static_cast<double>(bench.range(2)), 0.05, integrator);
  options.step_fraction = 0.9;
  run_wall(bench, w, options);
}

void shakings(benchmark::internal::Benchmark* bench) {
  bench->Iterations(1)->Unit(benchmark::kSecond);
  for (const int damping : {30, 20})
    bench->Args({1000, 30, 10, damping})
        ->Args({1000, 30, 100, damping})
        ->Args({12, 30, 20, damping})
        ->Args({1000, 150, 40, damping});
}

BENCHMARK_CAPTURE(s1, velocity_verlet, "velocity-verlet")->Apply(shakings);
BENCHMARK_CAPTURE(s1, symplectic_euler, "symplectic-euler")->Apply(shakings);
BENCHMARK_CAPTURE(shake, velocity_verlet, "velocity-verlet")
    ->Arg(200)
    ->Iterations(1)
    ->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(shake, velocity_verlet, "velocity-verlet")
    ->Arg(10)
    ->Iterations(1)
    ->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(shake, symplectic_euler, "symplectic-euler")
    ->Arg(10)
    ->Iterations(1)
    ->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(shake, rk4, "rk4")->Arg(10)->Iterations(1)->Unit(benchmark::kSecond);

}  // namespace
}  // namespace dougong::bench
