#include "app/study/prepare.h"

#include "app/study/rocking_limits.h"
#include "app/study/run_cost.h"

namespace dougong::app {
namespace {

void choose_drive(Preparation& p) {
  p.accuracy = choose_integration(p.scenario.solve, p.model, p.drive);
  p.drive.output_interval = 1.0 / p.scenario.output.rate;
  p.drive.end_time = p.duration;
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

void note_rocking_limits(Preparation& p) {
  for (std::string& text : RockingLimits{}.look(p.model, p.state))
    p.findings.push_back({structures::Severity::warning, std::move(text), {}});
}

// The mode that carries most of the mass is the one an engineer calls the building's period.
void find_period(Preparation& p) {
  for (const engine::Mode& mode : engine::horizontal_modes(p.model, p.state))
    if (mode.participation > p.participation && mode.period() > 0.0)
      p.period = mode.period(), p.participation = mode.participation;
}

// Pose and acceleration of every block and a dozen histories.
void refuse_too_much_output(const Preparation& p) {
  const double values = 4.0 * static_cast<double>(p.model.body_count) + 12.0;
  app::refuse_too_much_output(p.duration / p.plan.output_interval, values, p.model.body_count);
}

// Everything that follows from the building and its motion.
void make_ready(Preparation& p) {
  for (engine::Terrain& terrain : p.building.scene.terrains) terrain.motion = p.motion.ground;
  p.model = engine::compile(p.building.scene);
  p.state = engine::initial_state(p.model, p.building.scene);
  settle_building(p);
  note_rocking_limits(p);
  find_period(p);
  p.duration = duration_of(p.scenario, p.motion);
  choose_drive(p);
  p.plan = engine::plan_steps(p.model, p.state, p.drive);
  refuse_unstable_step(p.drive, p.plan);
  refuse_too_much_output(p);
}

}  // namespace

std::vector<structures::Finding> checked_findings(const structures::Building& building) {
  std::vector<structures::Finding> findings = structures::check_model(building);
  std::string errors;
  for (const structures::Finding& finding : findings)
    if (finding.severity == structures::Severity::error)
      errors += (errors.empty() ? "" : "\n") + finding.message;
  if (!errors.empty()) throw ModelError(errors);
  return findings;
}

Preparation prepare(const Scenario& scenario, const std::filesystem::path& records_directory) {
  Preparation p;
  p.scenario = scenario;
  p.building = building_of(scenario);
  p.findings = checked_findings(p.building);
  p.motion = make_motion(scenario, records_directory);
  make_ready(p);
  p.estimated_seconds = estimated_cost(p.model, p.state, p.drive, p.plan, p.duration);
  return p;
}

Preparation prepare_member(const Preparation& described, std::size_t member) {
  Preparation p;
  p.scenario = described.scenario;
  p.building = described.building;
  p.motion = described.motion;
  const Perturbation& by = p.scenario.ensemble.perturbation;
  perturb(p.building, by, member);
  p.motion.ground = perturbed(p.motion.ground, by, member);
  make_ready(p);
  return p;
}

}  // namespace dougong::app
