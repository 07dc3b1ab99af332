#include "app/study/ensemble.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <mutex>

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

// As it was run, with steps half as long, or a tenth of the tolerance.
void refine(engine::DriveOptions& drive, double step) {
  if (engine::traits_of(drive.integrator).adaptive)
    drive.tolerance *= 0.1;
  else
    drive.step = 0.5 * step;
}

EnsembleMember run_one(const Preparation& described, const Variation& v, const ProgressObserver& go_on) {
  Preparation p = prepare_member(described, v.member);
  if (v.half_step) refine(p.drive, described.plan.step);
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
  EnsembleProgress state{0, variations.size()};
  std::atomic<bool> stopped{false};
  share_tasks(variations.size(), jobs, [&](std::size_t i) {
    const Variation& v = variations[i];
    if (stopped) return;
    EnsembleMember member = run_one(described, v, [&](const Progress&) {
      const std::lock_guard lock(mutex);
      if (progress && !progress(state)) stopped = true;
      return !stopped;
    });
    const std::lock_guard lock(mutex);
    (v.half_step ? sheet.half_step : sheet.members[v.member]) = std::move(member);
    ++state.done;
  });
  return sheet;
}

}  // namespace dougong::app
