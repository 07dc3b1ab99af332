// A running-bond wall of 1000 bricks under 20 s of the shipped Wenchuan-style record at 0.3 g: what a
// simulated second, a step and a contact point cost, for every integrator. Processor time of one core.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <ctime>

#include "app/study/motion_input.h"
#include "engine/drive.h"
#include "engine/integrators/table.h"
#include "engine/settle.h"
#include "structures/layouts/layout.h"
#include "tests/scenes/running.h"
#include "tests/scenes/running_bond.h"

namespace dougong {
namespace {

constexpr double window = 20.0;  // s, the strongest part of the record

std::shared_ptr<const seismic::GroundMotion> strong_window() {
  app::RecordChoice choice;
  choice.name = "wenchuan";
  seismic::ConditioningOptions options;
  options.from = 20.0;
  options.to = 20.0 + window - 10.0;  // the kept pads of 5 s on each side make up the rest
  options.target_pga = 0.3 * engine::standard_gravity;
  options.vertical = false;
  const auto records = app::read_scenario_record(choice, DOUGONG_RECORDS_DIRECTORY);
  return std::make_shared<const seismic::GroundMotion>(seismic::condition(records, options).ground_motion());
}

struct Wall {
  engine::Model model;
  engine::State settled;
};

// 40 courses of 25 bricks: 20 x 25 whole ones and 20 x (24 whole and 2 halves) are 1020 blocks.
const Wall& wall() {
  static const Wall instance = [] {
    structures::Building building = structures::build_layout("brick-wall", {{"courses", 40.0},
                                                                            {"bricks_per_course", 25.0},
                                                                            {"brick_length", 0.25},
                                                                            {"brick_height", 0.0625},
                                                                            {"young_modulus", 1e8}});
    building.scene.terrains[0].motion = strong_window();
    Wall w{engine::compile(building.scene), {}};
    w.settled = engine::initial_state(w.model, building.scene);
    engine::settle(w.model, w.settled);
    return w;
  }();
  return instance;
}

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

void run_wall(benchmark::State& bench, const Wall& w, const engine::DriveOptions& options) {
  engine::RunOutcome run;
  std::size_t points = 0;
  std::clock_t ticks = 0;
  for (auto _ : bench) {
    engine::State state = w.settled;
    const std::clock_t start = std::clock();
    run = engine::drive(w.model, state, options, {});
    ticks = std::clock() - start;
    points = state.contacts.points.size();
  }
  const double cpu = static_cast<double>(ticks) / CLOCKS_PER_SEC;
  const auto steps = static_cast<double>(run.steps);
  bench.counters["s_per_simulated_s"] = cpu / run.end_time;
  bench.counters["us_per_step"] = 1e6 * cpu / steps;
  bench.counters["ns_per_point_step"] = 1e9 * cpu / steps / static_cast<double>(points);
  bench.counters["bricks"] = static_cast<double>(w.model.body_count);
  bench.counters["points"] = static_cast<double>(points);
  bench.counters["step_us"] = 1e6 * run.step;
  bench.counters["peak_MB"] = peak_megabytes();
}

// The argument is how much of the 20 s is run, in tenths of a second.
void shake(benchmark::State& bench, const char* integrator) {
  engine::DriveOptions options;
  options.integrator = integrator;
  options.end_time = 0.1 * static_cast<double>(bench.range(0));
  run_wall(bench, wall(), options);
}

// The wall S1 by which engines are compared: 1020 bricks with open head joints that settle by so many
// micrometres, shaken at 2 Hz by so many hundredths of g, for so many tenths of a second.
void s1(benchmark::State& bench) {
  scenes::RunningBond brickwork;
  brickwork.young_modulus *= 1e6 * scenes::settlement(brickwork) / static_cast<double>(bench.range(0));
  const double amplitude = 0.01 * 9.81 * static_cast<double>(bench.range(1));
  const engine::Scene scene = scenes::running_bond(brickwork, scenes::sine_motion(amplitude, 2.0));
  Wall w{engine::compile(scene), {}};
  w.settled = engine::initial_state(w.model, scene);
  engine::settle(w.model, w.settled);
  engine::DriveOptions options = scenes::run_for(0.1 * static_cast<double>(bench.range(2)), 0.05);
  options.step_fraction = 0.9;
  run_wall(bench, w, options);
}

BENCHMARK(s1)->Args({1000, 30, 100})->Iterations(1)->Unit(benchmark::kSecond);
BENCHMARK(s1)->Args({12, 30, 20})->Iterations(1)->Unit(benchmark::kSecond);
BENCHMARK(s1)->Args({1000, 150, 40})->Iterations(1)->Unit(benchmark::kSecond);
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
}  // namespace dougong
