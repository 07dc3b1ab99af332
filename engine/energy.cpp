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

// Of the first terrain, or of the bodies' centre of mass.
Vec2 common_velocity(const Model& model, const State& state, std::span<const Frame> frames) {
  if (model.terrain_count > 0) return frames[model.body_count].velocity();
  const std::size_t n = model.body_count;
  Vec2 momentum;
  for (std::size_t i = 0; i < n; ++i) momentum += model.mass[i] * Vec2{state.v()[i], state.v()[n + i]};
  return (1.0 / model.total_mass()) * momentum;
}

double agitation_of(const Model& model, const State& state, std::span<const Frame> frames) {
  const std::size_t n = model.body_count;
  const auto v = state.v();
  const Vec2 common = n > 0 ? common_velocity(model, state, frames) : Vec2{};
  double energy = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 u = Vec2{v[i], v[n + i]} - common;
    energy += 0.5 * model.mass[i] * dot(u, u) + 0.5 * model.inertia[i] * v[2 * n + i] * v[2 * n + i];
  }
  return energy;
}

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
  e.agitation = agitation_of(model, state, frames);
  if (!model.fields.empty()) e.field = field_energy(model.fields, frames);
  const StoredEnergy stored = stored_energy(state.contacts.points, frames);
  const double in_bonds = bond_energy(model, state.bonds, frames);
  e.elastic = stored.normal + stored.tangential + in_bonds + joint_energy(model, frames);
  e.stagger = state.work.stagger;
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
                                 first_.agitation, std::abs(first_.field), rounding * first_.terms});
  return scale > 0.0 ? largest_error_ / scale : 0.0;
}

}  // namespace dougong::engine
