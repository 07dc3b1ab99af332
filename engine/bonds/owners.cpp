#include "engine/bonds/owners.h"

#include <stdexcept>

namespace dougong::engine {
namespace {

Frame frame_at(Vec2 position, double angle) {
  Frame frame;
  frame.x = position.x, frame.y = position.y;
  frame.turn_to(angle);
  return frame;
}

}  // namespace

Index index_of(const Owner& owner, const Model& model, const std::string& asked_by) {
  const std::size_t count = owner.terrain ? model.terrain_count : model.body_count;
  if (owner.index >= count)
    throw std::invalid_argument(asked_by + ": there is no " + (owner.terrain ? "terrain" : "body") +
                                " number " + std::to_string(owner.index));
  return static_cast<Index>(owner.terrain ? model.body_count + owner.index : owner.index);
}

std::vector<Frame> described_frames(const Scene& scene, const Model& model) {
  std::vector<Frame> frames;
  for (const Body& body : scene.bodies) frames.push_back(frame_at(body.position - model.origin, body.angle));
  for (const Terrain& terrain : scene.terrains)
    frames.push_back(frame_at(terrain.position - model.origin, terrain.angle));
  return frames;
}

}  // namespace dougong::engine
