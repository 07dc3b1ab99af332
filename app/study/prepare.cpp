#include "app/study/prepare.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>

#include "engine/integrators/table.h"

namespace dougong::app {
namespace {

using Clock = std::chrono::steady_clock;

void refuse_errors(const std::vector<structures::Finding>& findings) {
  std::string errors;
  for (const structures::Finding& finding : findings)
    if (finding.severity == structures::Severity::error)
      errors += (errors.empty() ? "" : "\n") + finding.message;
  if (!errors.empty()) throw ModelError(errors);
}

engine::DriveOptions drive_options(const Scenario& scenario, double duration) {
  engine::DriveOptions options;
  options.integrator = scenario.solve.integrator;
  options.step_fraction = scenario.solve.step_fraction;
  options.step = scenario.solve.step;
  options.output_interval = 1.0 / scenario.output.rate;
  options.end_time = duration;
  return options;
}

double duration_of(const Scenario& scenario, const MotionInput& motion) {
  if (scenario.solve.duration) return *scenario.solve.duration;
  return motion.ground->duration() + scenario.solve.free_vibration;
}

void settle_building(Preparation& p) {
  if (p.scenario.solve.settle) p.settle = engine::settle(p.model, p.state);
  p.contact_points = 0;
  const auto frames = engine::frames_of(p.model, p.state);
  for (std::size_t i = 0; i < p.state.contacts.points.size(); ++i)
    if (engine::geometry_of(p.state.contacts.points, i, frames).overlap > 0.0) ++p.contact_points;
}

// The mode that carries most of the mass is the one an engineer calls the building's period.
void find_period(Preparation& p) {
  for (const engine::Mode& mode : engine::horizontal_modes(p.model, p.state))
    if (mode.participation > p.participation && mode.period() > 0.0)
      p.period = mode.period(), p.participation = mode.participation;
}

void refuse_unstable_step(const Preparation& p) {
  if (p.plan.bound == 0.0)
    throw std::invalid_argument(
        "solve.integrator: expected one with a stable step for this building, found " + p.drive.integrator +
        ", under which any undamped vibration grows");
  if (!p.drive.step || *p.drive.step <= p.plan.bound) return;
  throw std::invalid_argument(
      fmt::format("solve.step: expected at most the stability bound of {:.3g} s, found {:.6g} s",
                  p.plan.bound, *p.drive.step));
}

double machine_memory() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

// A run that cannot keep its output is found out before it starts. Pose and acceleration of every block
// and a dozen histories, held twice: as computed and as read back for the report.
void refuse_too_much_output(const Preparation& p) {
  const double samples = p.duration / p.plan.output_interval;
  const double values = samples * (4.0 * static_cast<double>(p.model.body_count) + 12.0);
  const double needed = 2.0 * sizeof(double) * values, available = machine_memory();
  if (needed <= available) return;
  throw std::invalid_argument(fmt::format(
      "output.rate: expected results that fit into the memory of {:.3g} GB, found {:.3g} GB: {:.3g} output "
      "times of {} blocks",
      available / 1e9, needed / 1e9, samples, p.model.body_count));
}

// A trial of a few hundred steps on a copy: what the machine at hand really needs.
double estimate_cost(const Preparation& p) {
  engine::State trial = p.state;
  engine::DriveOptions options = p.drive;
  // A step of an adaptive integrator holds many of its own.
  const double steps = engine::traits_of(p.drive.integrator).adaptive ? 3.0 : 300.0;
  options.end_time = options.output_interval = std::min(p.duration, steps * p.plan.step);
  const auto start = Clock::now();
  const engine::RunOutcome run = engine::drive(p.model, trial, options, {});
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return run.end_time > 0.0 ? seconds / run.end_time * p.duration : 0.0;
}

}  // namespace

Preparation prepare(const Scenario& scenario, const std::filesystem::path& records_directory) {
  Preparation p;
  p.scenario = scenario;
  p.building = structures::build_layout(scenario.layout.name, scenario.layout.parameters);
  p.findings = structures::check_model(p.building);
  refuse_errors(p.findings);
  p.motion = make_motion(scenario, records_directory);
  for (engine::Terrain& terrain : p.building.scene.terrains) terrain.motion = p.motion.ground;
  p.model = engine::compile(p.building.scene);
  p.state = engine::initial_state(p.model, p.building.scene);
  settle_building(p);
  find_period(p);
  p.duration = duration_of(scenario, p.motion);
  p.drive = drive_options(scenario, p.duration);
  p.plan = engine::plan_steps(p.model, p.state, p.drive);
  refuse_unstable_step(p);
  refuse_too_much_output(p);
  p.estimated_seconds = estimate_cost(p);
  return p;
}

}  // namespace dougong::app
