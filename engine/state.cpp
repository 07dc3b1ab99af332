#include "engine/state.h"

#include <bit>

namespace dougong::engine {

State initial_state(const Model& model, const Scene& scene) {
  const std::size_t n = model.body_count;
  State state;
  state.y.resize(6 * n);
  for (std::size_t i = 0; i < n; ++i) {
    const Body& body = scene.bodies[i];
    const Vec2 p = body.position - model.origin;
    const double values[] = {p.x, p.y, body.angle, body.velocity.x, body.velocity.y, body.spin};
    for (std::size_t k = 0; k < 6; ++k) state.y[k * n + i] = values[k];
  }
  const std::vector<Frame> frames = frames_of(model, state);
  state.bonds = initial_bonds(model, frames);
  state.joints = initial_joints(model, frames);
  state.contacts = ContactSet(model);
  state.contacts.keep_apart(held_pairs(model, state.bonds));
  state.contacts.limit_damping(tied_pairs(model, state.bonds));
  state.contacts.update(model, frames);
  return state;
}

void place_all(const Model& model, const State& state, bool terrain_held_still, std::span<Frame> frames,
               Crew& crew) {
  place_bodies(model, state.q(), state.v(), frames, crew);
  place_terrains(model, state.time, terrain_held_still, frames);
}

std::vector<Frame> frames_of(const Model& model, const State& state, bool terrain_held_still) {
  std::vector<Frame> frames(model.size());
  place_all(model, state, terrain_held_still, frames);
  return frames;
}

std::string state_hash(const State& state) {
  std::uint64_t hash = 14695981039346656037ull;
  const auto mix = [&hash](double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    for (int byte = 0; byte < 8; ++byte) hash = (hash ^ ((bits >> (8 * byte)) & 0xff)) * 1099511628211ull;
  };
  mix(state.time);
  for (const double value : state.y) mix(value);
  std::string text(16, '0');
  for (std::size_t digit = 0; digit < 16; ++digit)
    text[15 - digit] = "0123456789abcdef"[(hash >> (4 * digit)) & 15];
  return text;
}

}  // namespace dougong::engine
