#include "app/study/run_cost.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "app/study/stopwatch.h"
#include "engine/integrators/table.h"

namespace dougong::app {
namespace {

// A step of an adaptive integrator holds many of its own.
double trial_steps(const engine::DriveOptions& drive) {
  return engine::traits_of(drive.integrator).adaptive ? 3.0 : 300.0;
}

double machine_memory() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

}  // namespace

double estimated_cost(const engine::Model& model, const engine::State& state,
                      const engine::DriveOptions& drive, const engine::StepPlan& plan, double duration) {
  engine::State trial = state;
  engine::DriveOptions options = drive;
  options.end_time = options.output_interval = std::min(duration, trial_steps(drive) * plan.step);
  const Stopwatch watch;
  const engine::RunOutcome run = engine::drive(model, trial, options, {});
  return run.end_time > 0.0 ? watch.cpu() / run.end_time * duration : 0.0;
}

void refuse_too_much_output(double samples, double values, std::size_t bodies) {
  const double needed = 2.0 * sizeof(double) * samples * values, available = machine_memory();
  if (needed <= available) return;
  throw std::invalid_argument(fmt::format(
      "output.rate: expected results that fit into the memory of {:.3g} GB, found {:.3g} GB: {:.3g} output "
      "times of {} blocks",
      available / 1e9, needed / 1e9, samples, bodies));
}

void refuse_unstable_step(const engine::DriveOptions& drive, const engine::StepPlan& plan) {
  if (plan.bound == 0.0)
    throw std::invalid_argument("solve.integrator: expected one with a stable step here, found " +
                                drive.integrator + ", under which any undamped vibration grows");
  if (!drive.step || *drive.step <= plan.bound) return;
  throw std::invalid_argument(
      fmt::format("solve.step: expected at most the stability bound of {:.3g} s, found {:.6g} s", plan.bound,
                  *drive.step));
}

}  // namespace dougong::app
