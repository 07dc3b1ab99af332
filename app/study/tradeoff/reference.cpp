#include "app/study/tradeoff/reference.h"

#include <algorithm>
#include <cmath>

#include "engine/accuracy.h"
#include "engine/integrators/table.h"
#include "seismic/synthesis/random.h"

namespace dougong::app {
namespace {

// Finer than the finest rung, so that the coarser of the two runs is still finer than it; but rounding is
// near below the least tolerance.
constexpr double finer_step = 0.25, finer_tolerance = 1e-2, least_tolerance = 1e-14;
constexpr double coarser_step = 2.0, coarser_tolerance = 10.0;
constexpr std::uint64_t ensemble_seed = 2008;

Way finest_of(const std::string& integrator, const LadderChoice& choice, double stiffness,
              const PreparedScene& scene) {
  if (engine::traits_of(integrator).adaptive)
    return adaptive_way(integrator, std::max(finer_tolerance * choice.tolerances.back(), least_tolerance),
                        stiffness);
  return fixed_way(integrator, finer_step * choice.steps.back(), stiffness, scene);
}

Reference tried(const Way& way, const PreparedScene& scene, const Yardstick& by, const TrialLimits& limits) {
  Reference reference;
  reference.coarser =
      attempt(scene, coarsened(way, way.solve.tolerance ? coarser_tolerance : coarser_step), limits);
  // What the coarser run has cost twice over is what the finer one will.
  const double predicted = reference.coarser.completed() ? coarser_step * reference.coarser.cpu : 0.0;
  reference.run = reference.coarser.completed() ? attempt(scene, way, limits, predicted) : reference.coarser;
  reference.difference = distance(by, reference.run.trajectory, reference.coarser.trajectory);
  return reference;
}

bool is_better(const Reference& a, const Reference& b) {
  if (a.run.completed() != b.run.completed()) return a.run.completed();
  return a.difference < b.difference;
}

PreparedScene perturbed(PreparedScene scene, std::size_t member, double speed, const Yardstick& by) {
  const std::span<double> v = scene.state.v();
  const std::size_t bodies = v.size() / 3;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const double number = 2.0 * seismic::uniform_number(ensemble_seed, member, i) - 1.0;
    v[i] += speed * number / (i < 2 * bodies ? 1.0 : by.gyration[i - 2 * bodies]);
  }
  return scene;
}

}  // namespace

std::vector<Way> reference_candidates(const LadderChoice& choice, double stiffness,
                                      const PreparedScene& scene) {
  if (stiffness == rigid) return {finest_of("moreau-jean", choice, stiffness, scene)};
  const std::string dial = engine::resolve_accuracy(engine::AccuracyLevel::reference, scene.model).integrator;
  std::vector<Way> candidates{finest_of(dial, choice, stiffness, scene)};
  for (const char* integrator : {"rk4", "velocity-verlet"})
    if (dial != integrator) candidates.push_back(finest_of(integrator, choice, stiffness, scene));
  return candidates;
}

Reference make_reference(const std::vector<Way>& candidates, const PreparedScene& scene, const Yardstick& by,
                         const TrialLimits& limits) {
  Reference best = tried(candidates.front(), scene, by, limits);
  for (std::size_t i = 1; i < candidates.size(); ++i) {
    Reference next = tried(candidates[i], scene, by, limits);
    if (is_better(next, best)) best = std::move(next);
  }
  return best;
}

double Ensemble::spread() const {
  double sum = 0.0;
  for (const double d : differences) sum += d * d;
  return differences.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(differences.size()));
}

Ensemble make_ensemble(std::size_t members, const Trial& unperturbed, double speed,
                       const PreparedScene& scene, const Yardstick& by, const TrialLimits& limits) {
  Ensemble ensemble;
  for (std::size_t member = 0; member < members; ++member) {
    const Trial trial =
        attempt(perturbed(scene, member, ensemble.perturbation * speed, by), unperturbed.way, limits);
    if (trial.completed())
      ensemble.differences.push_back(distance(by, trial.trajectory, unperturbed.trajectory));
    else
      ++ensemble.failed;
  }
  return ensemble;
}

}  // namespace dougong::app
