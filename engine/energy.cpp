#include "engine/energy.h"

#include <algorithm>
#include <cmath>

namespace dougong::engine {
namespace {

// A motion that turns over less than this part of what the weight stores in the contacts is rest.
constexpr double energy_at_rest = 1e-6;

}  // namespace

Energies energies_of(const Model& model, const State& state) {
  const std::size_t n = model.body_count;
  const auto q = state.q(), v = state.v();
  Energies e;
  for (std::size_t i = 0; i < n; ++i) {
    e.kinetic += 0.5 * model.mass[i] * (v[i] * v[i] + v[n + i] * v[n + i]);
    e.kinetic += 0.5 * model.inertia[i] * v[2 * n + i] * v[2 * n + i];
    e.gravity -= model.mass[i] * (model.gravity.x * q[i] + model.gravity.y * q[n + i]);
  }
  const StoredEnergy stored = stored_energy(state.contacts.points, frames_of(model, state));
  e.elastic = stored.normal + stored.tangential;
  e.input = state.work.input;
  e.damping = state.work.damping;
  e.friction = state.work.tangential - stored.tangential;
  return e;
}

void EnergyTurnover::note(const Energies& energies) {
  if (!started_) first_ = energies;
  started_ = true;
  error_ = energies.balance() - first_.balance();
  largest_error_ = std::max(largest_error_, std::abs(error_));
  turnover_ =
      std::max(turnover_, std::abs(energies.input) + std::max(0.0, first_.gravity - energies.gravity));
}

double EnergyTurnover::relative_error() const {
  const double scale = std::max({turnover_, energy_at_rest * first_.elastic, first_.kinetic});
  return scale > 0.0 ? largest_error_ / scale : 0.0;
}

}  // namespace dougong::engine
