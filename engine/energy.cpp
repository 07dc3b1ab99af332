#include "engine/energy.h"

namespace dougong::engine {

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

}  // namespace dougong::engine
