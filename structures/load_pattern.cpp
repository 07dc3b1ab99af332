#include "structures/load_pattern.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include "structures/outline.h"

namespace dougong::structures {
namespace {

/// Elevation of the lowest corner of the blocks (m, in the model's coordinates).
double foot_of(const engine::Model& model, const engine::State& state) {
  const std::size_t n = model.body_count;
  double foot = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < n; ++i)
    for (const Outline& outline :
         outlines(model.shapes[i], {state.q()[i], state.q()[n + i]}, state.q()[2 * n + i]))
      foot = std::min(foot, extent_of(outline).low.y);
  return foot;
}

/// What a block counts, before the forces are scaled.
std::vector<double> shares(const engine::Model& model, const engine::State& state, LoadPattern pattern) {
  const std::size_t n = model.body_count;
  std::vector<double> share(model.mass.begin(), model.mass.begin() + static_cast<std::ptrdiff_t>(n));
  if (pattern == LoadPattern::mass) return share;
  if (pattern == LoadPattern::triangular) {
    const double foot = foot_of(model, state);
    for (std::size_t i = 0; i < n; ++i) share[i] *= state.q()[n + i] - foot;
    return share;
  }
  const std::vector<engine::Mode> modes = engine::horizontal_modes(model, state);
  const engine::Mode* mode = main_mode(modes);
  if (!mode) throw std::runtime_error("load pattern first-mode: no mode of the building swings");
  for (std::size_t i = 0; i < n; ++i) share[i] *= mode->shape[i];
  return share;
}

}  // namespace

std::string to_string(LoadPattern pattern) {
  switch (pattern) {
    case LoadPattern::mass:
      return "mass";
    case LoadPattern::triangular:
      return "triangular";
    case LoadPattern::first_mode:
      return "first-mode";
  }
  return "";
}

std::span<const LoadPattern> load_patterns() {
  static constexpr std::array all{LoadPattern::mass, LoadPattern::triangular, LoadPattern::first_mode};
  return all;
}

const engine::Mode* main_mode(const std::vector<engine::Mode>& modes) {
  const engine::Mode* main = nullptr;
  for (const engine::Mode& mode : modes)
    if (mode.period() > 0.0 && (!main || mode.participation > main->participation)) main = &mode;
  return main;
}

std::vector<double> pattern_forces(const engine::Model& model, const engine::State& state,
                                   LoadPattern pattern) {
  std::vector<double> forces = shares(model, state, pattern);
  const double weight = model.total_mass() * engine::norm(model.gravity);
  const double sum = std::accumulate(forces.begin(), forces.end(), 0.0);
  for (double& force : forces) force *= weight / sum;
  return forces;
}

}  // namespace dougong::structures
