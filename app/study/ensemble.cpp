#include "app/study/ensemble.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <numeric>

#include "app/study/metrics.h"
#include "app/study/output_times.h"
#include "app/study/share_tasks.h"
#include "engine/integrators/table.h"

namespace dougong::app {
namespace {

// With what a run differs from the one described.
struct Variation {
  std::size_t member = 0;
  bool half_step = false;
};

std::vector<NamedValue> sheet_of(const Perturbation& p) {
  const auto percent = [](double part) { return fmt::format("± {:.3g} %", 100.0 * part); };
  return {{"position", fmt::format("± {:.3g} mm", 1e3 * p.position), "sideways, of every block"},
          {"friction", percent(p.friction), "of every material and bond"},
          {"strength", percent(p.strength), "of every bond"},
          {"damping", percent(p.damping), "of every material, bond and joint"},
          {"amplitude", percent(p.amplitude), "of the ground motion"},
          {"seed", fmt::format("{:.0f}", p.seed), "of the numbers, each uniform within its range"}};
}

// As it was run, with steps half as long, or a tenth of the tolerance. A step that follows the stability
// bound is to do so at half of its part of it: at the impacts of a collapse too.
void refine(engine::DriveOptions& drive, const engine::StepPlan& plan) {
  if (engine::traits_of(drive.integrator).adaptive)
    drive.tolerance *= 0.1;
  else if (drive.step || !std::isfinite(plan.bound))
    drive.step = 0.5 * plan.step;
  else
    drive.step_fraction = 0.5 * std::min(drive.step_fraction, plan.step / plan.bound);
}

EnsembleMember run_one(const Preparation& described, const Variation& v, const ProgressObserver& go_on) {
  Preparation p = prepare_member(described, v.member);
  if (v.half_step) refine(p.drive, described.plan);
  const RunResult run = execute(p, "", go_on);
  return member_of(run);
}

constexpr double drawn_rate = 50.0;  // Hz, of the histories that the members keep

void keep_roof_drift(const structures::Response& response, EnsembleMember& member) {
  double end = std::numeric_limits<double>::infinity();
  for (const auto& storey : response.storeys) end = std::min(end, storey.lost_at.value_or(end));
  if (!(response.height > 0.0)) return;
  for (const std::size_t step : kept_steps(response.times, drawn_rate, {})) {
    if (response.times[step] >= end) break;
    member.roof_times.push_back(response.times[step]);
    member.roof_drift.push_back(response.roof_displacement[step] / response.height);
  }
}

}  // namespace

std::size_t runs_of(const Scenario& scenario) {
  return static_cast<std::size_t>(scenario.ensemble.n) + (scenario.ensemble.half_step ? 1 : 0);
}

EnsembleMember member_of(const RunResult& run) {
  EnsembleMember member;
  member.verdict = run.verdict.kind;
  member.state_hash = run.reproducibility.state_hash;
  member.done = !run.partial;
  for (const Metric& metric : metrics_of(run)) member.values.push_back(metric.value);
  if (!run.response.roof_displacement.empty()) keep_roof_drift(run.response, member);
  return member;
}

EnsembleSheet run_ensemble(const Preparation& described, const RunResult& run, std::size_t jobs,
                           const EnsembleObserver& progress) {
  const EnsembleChoice& choice = described.scenario.ensemble;
  EnsembleSheet sheet;
  sheet.perturbations = sheet_of(choice.perturbation);
  for (const Metric& metric : metrics_of(run))
    sheet.metrics.push_back(metric.name), sheet.units.push_back(metric.unit);
  const auto n = static_cast<std::size_t>(choice.n);
  sheet.members.resize(n);
  sheet.members[0] = member_of(run);
  std::vector<Variation> variations;
  for (std::size_t i = 1; i < n; ++i) variations.push_back({i, false});
  if (choice.half_step) variations.push_back({0, true});

  std::mutex mutex;
  EnsembleProgress state{0, variations.size(), 0.0};
  std::vector<double> parts(variations.size());
  std::atomic<bool> stopped{false};
  share_tasks(variations.size(), jobs, [&](std::size_t i) {
    const Variation& v = variations[i];
    if (stopped) return;
    EnsembleMember member = run_one(described, v, [&](const Progress& now) {
      const std::lock_guard lock(mutex);
      parts[i] = now.end_time > 0.0 ? now.time / now.end_time : 1.0;
      state.part = std::accumulate(parts.begin(), parts.end(), 0.0);
      if (progress && !progress(state)) stopped = true;
      return !stopped;
    });
    const std::lock_guard lock(mutex);
    (v.half_step ? sheet.half_step : sheet.members[v.member]) = std::move(member);
    parts[i] = 0.0;
    ++state.done;
  });
  return sheet;
}

}  // namespace dougong::app
