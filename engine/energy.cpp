#include "engine/energy.h"

#include <algorithm>
#include <cmath>

#include "engine/fields/fields.h"

namespace dougong::engine {
namespace {

// A scene that turns over less than this part of the energy it started with is at rest, or drifts freely.
constexpr double energy_at_rest = 1e-6;
// Rigid contacts store nothing: then rounding is all there is.
constexpr double rounding = 1e-9;

double given(double at_start, double now) {
  return std::max(0.0, at_start - now);
}

}  // namespace

Energies energies_of(const Model& model, const State& state) {
  const std::size_t n = model.body_count;
  const auto q = state.q(), v = state.v();
  Energies e;
  for (std::size_t i = 0; i < n; ++i) {
    e.kinetic += 0.5 * model.mass[i] * (v[i] * v[i] + v[n + i] * v[n + i]);
    e.kinetic += 0.5 * model.inertia[i] * v[2 * n + i] * v[2 * n + i];
    e.gravity -= model.mass[i] * (model.gravity.x * q[i] + model.gravity.y * q[n + i]);
    e.terms += model.mass[i] * (std::abs(model.gravity.x * q[i]) + std::abs(model.gravity.y * q[n + i]));
  }
  const auto frames = frames_of(model, state);
  if (!model.fields.empty()) e.field = field_energy(model.fields, frames);
  const StoredEnergy stored = stored_energy(state.contacts.points, frames);
  const double in_bonds = bond_energy(model, state.bonds, frames);
  e.elastic = stored.normal + stored.tangential + in_bonds + joint_energy(model, frames);
  e.input = state.work.input;
  e.damping = state.work.damping;
  e.friction = state.work.tangential - stored.tangential;
  e.fracture = state.work.bonds - in_bonds;
  return e;
}

void EnergyTurnover::note(const Energies& energies) {
  if (!started_) first_ = energies;
  started_ = true;
  error_ = energies.balance() - first_.balance();
  largest_error_ = std::max(largest_error_, std::abs(error_));
  largest_input_ = std::max(largest_input_, std::abs(energies.input));
  turnover_ =
      std::max(turnover_, std::abs(energies.input) + given(first_.gravity, energies.gravity) +
                              given(first_.field, energies.field) + given(first_.elastic, energies.elastic) +
                              given(first_.kinetic, energies.kinetic));
}

double EnergyTurnover::relative_error() const {
  const double scale = std::max({turnover_, energy_at_rest * (first_.elastic + first_.kinetic),
                                 std::abs(first_.field), rounding * first_.terms});
  return scale > 0.0 ? largest_error_ / scale : 0.0;
}

}  // namespace dougong::engine
