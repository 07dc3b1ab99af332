// Validation case X05 in full: a dry wall of n x n bricks at rest, settled and then watched. What it drifts,
// what its rows carry, and what it costs. Processor time of one core.
#include <benchmark/benchmark.h>

#include <cmath>
#include <ctime>

#include "engine/settle.h"
#include "tests/scenes/running.h"

namespace dougong {
namespace {

double seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// Half of the course above and half of the one below a bed joint.
double force_under(const scenes::Running& r, int row, double h) {
  double force = 0.0;
  for (const auto& f : scenes::point_forces(r.model, r.state)) {
    const double y = f.place.y + r.model.origin.y;
    if (y > (row - 0.5) * h && y < (row + 0.5) * h) force += f.normal;
  }
  return force;
}

// Arguments: bricks a course and courses, duration (s). E 0.1 GPa.
void wall_at_rest(benchmark::State& bench) {
  const int n = static_cast<int>(bench.range(0));
  const double h = 0.2, course = n * 2400.0 * 0.4 * h * 9.81;
  for (auto _ : bench) {
    scenes::Running r(scenes::wall(n, n, 0.6, 1e8));
    const double begin = seconds();
    const auto settled = engine::settle(r.model, r.state, {.longest_time = 30.0, .unbalanced_ratio = 1e-6});
    const double ready = seconds();
    const scenes::Running start = r;
    const auto run = r.run(scenes::run_for(static_cast<double>(bench.range(1)), 0.05));
    bench.counters["settled"] = settled.settled ? 1.0 : 0.0;
    bench.counters["settle_cpu_s"] = ready - begin;
    bench.counters["run_cpu_s"] = seconds() - ready;
    bench.counters["completed"] = run.outcome == engine::Outcome::completed ? 1.0 : 0.0;
    bench.counters["steps"] = static_cast<double>(run.steps);
    bench.counters["drift_over_h"] = scenes::greatest_drift(r, start) / h;
    double worst = 0.0;
    for (const int row : {0, n / 2, n - 1})
      worst = std::max(worst, std::abs(force_under(r, row, h) / ((n - row) * course) - 1.0));
    bench.counters["worst_row_error"] = worst;
  }
}
BENCHMARK(wall_at_rest)->Args({100, 10})->Iterations(1)->Unit(benchmark::kSecond);

}  // namespace
}  // namespace dougong
