#include "app/study/tradeoff/ladder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/integrators/table.h"

namespace dougong::app {
namespace {

// Through contacts every method is of first order and the bound is near what is needed; in smooth motion
// small parts of it pay.
const std::vector<double> steps_with_contacts{0.9, 0.5, 0.25, 0.1},
    smooth_steps{0.5, 0.2, 0.1, 0.05, 0.02, 0.01};
const std::vector<double> usual_tolerances{1e-4, 1e-6, 1e-8, 1e-10};
const std::vector<double> usual_stiffnesses{0.1, 1.0, 10.0};

std::vector<std::string> applicable(const engine::Model& model) {
  std::vector<std::string> names = integrator_choices();
  std::erase_if(names, [&](const std::string& name) {
    return name == automatic_integrator || !does_not_apply(name, model).empty();
  });
  return names;
}

engine::StepPlan plan_of(const std::string& integrator, const PreparedScene& scene) {
  engine::DriveOptions options = scene.drive;
  options.integrator = integrator;
  options.step = std::nullopt;
  return engine::plan_steps(scene.model, scene.state, options);
}

void sort_coarse_first(std::vector<double>& values) {
  std::ranges::sort(values, std::greater{});
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

// To what is worth writing into a scene file.
double rounded(double value) {
  return std::stod(fmt::format("{:.4g}", value));
}

bool is_rigid(const std::string& integrator) {
  return engine::traits_of(integrator).rigid_contacts;
}

std::vector<Way> series_of(const std::string& integrator, const LadderChoice& choice, double stiffness,
                           const PreparedScene& scene) {
  std::vector<Way> ways;
  if (engine::traits_of(integrator).adaptive)
    for (const double t : choice.tolerances) ways.push_back(adaptive_way(integrator, t, stiffness));
  else
    for (const double part : choice.steps) ways.push_back(fixed_way(integrator, part, stiffness, scene));
  return ways;
}

}  // namespace

std::string does_not_apply(const std::string& integrator, const engine::Model& model) {
  if (!is_rigid(integrator)) return "";
  if (!model.has_contacts()) return "nothing touches";
  return model.has_rocking_restitution() ? "rigid contacts know no rocking restitution" : "";
}

LadderChoice completed(LadderChoice choice, const PreparedScene& scene) {
  const engine::Model& model = scene.model;
  const bool only_contacts = model.has_contacts() && model.bond_points.empty() && model.joints.empty();
  if (choice.integrators.empty()) choice.integrators = applicable(model);
  if (choice.steps.empty()) choice.steps = model.has_contacts() ? steps_with_contacts : smooth_steps;
  if (choice.tolerances.empty()) choice.tolerances = usual_tolerances;
  if (choice.stiffnesses.empty())
    choice.stiffnesses = only_contacts ? usual_stiffnesses : std::vector<double>{1.0};
  for (auto* values : {&choice.steps, &choice.tolerances, &choice.stiffnesses}) sort_coarse_first(*values);
  return choice;
}

Way fixed_way(const std::string& integrator, double part, double stiffness, const PreparedScene& scene) {
  const engine::IntegratorTraits traits = engine::traits_of(integrator);
  const engine::StepPlan plan = plan_of(integrator, scene);
  Way way{traits.rigid_contacts ? rigid : stiffness, {}};
  way.solve.integrator = integrator;
  const double longest = std::min(plan.base_interval, traits.longest_step);
  if (plan.bound <= longest && (part < 1.0 || plan.bound == 0.0))
    way.solve.step_fraction = part;
  else
    way.solve.step = rounded(part * std::min(plan.bound, longest));
  return way;
}

Way adaptive_way(const std::string& integrator, double tolerance, double stiffness) {
  Way way{stiffness, {}};
  way.solve.integrator = integrator;
  way.solve.tolerance = tolerance;
  return way;
}

std::vector<Way> ladder_of(const LadderChoice& choice, double stiffness, const PreparedScene& scene) {
  std::vector<Way> ways;
  for (const std::string& integrator : choice.integrators) {
    // Rigid contacts are no stiffer for a stiffer material: one series of them is enough.
    if (is_rigid(integrator) && stiffness != 1.0) continue;
    for (Way& way : series_of(integrator, choice, stiffness, scene)) ways.push_back(std::move(way));
  }
  return ways;
}

Way own_way(const PreparedScene& scene) {
  const engine::DriveOptions& drive = scene.drive;
  const engine::IntegratorTraits traits = engine::traits_of(drive.integrator);
  if (traits.adaptive) return adaptive_way(drive.integrator, drive.tolerance, 1.0);
  Way way = fixed_way(drive.integrator, drive.step_fraction, 1.0, scene);
  if (drive.step) way.solve.step = drive.step, way.solve.step_fraction = std::nullopt;
  return way;
}

}  // namespace dougong::app
