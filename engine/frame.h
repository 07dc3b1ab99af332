// Where every body and terrain is and how it moves at one moment: one cache line each.
#pragma once

#include <span>

#include "engine/crew.h"
#include "engine/model.h"

namespace dougong::engine {

struct alignas(64) Frame {
  double x = 0.0, y = 0.0;    // m, of the centroid, relative to the model's origin
  double c = 1.0, s = 0.0;    // cosine and sine of the angle
  double vx = 0.0, vy = 0.0;  // m/s
  double spin = 0.0;          // rad/s
  double angle = 0.0;         // rad

  /// Sets the angle (rad) with its sine and cosine (sine_cosine.h).
  void turn_to(double to);
  Vec2 position() const { return {x, y}; }
  Vec2 velocity() const { return {vx, vy}; }
  Vec2 turned_to_world(Vec2 local) const { return {c * local.x - s * local.y, s * local.x + c * local.y}; }
  Vec2 turned_to_local(Vec2 world) const { return {c * world.x + s * world.y, c * world.y - s * world.x}; }
  Vec2 to_world(Vec2 local) const { return position() + turned_to_world(local); }
  Vec2 to_local(Vec2 world) const { return turned_to_local(world - position()); }
};

/// Frames of bodies from q = [x | y | angle] and v = [vx | vy | spin], each body_count long.
void place_bodies(const Model& model, std::span<const double> q, std::span<const double> v,
                  std::span<Frame> frames, Crew& crew = Crew::alone());
/// Frames of terrains from their motions at time t. A terrain held still stands where it is at t = 0.
void place_terrains(const Model& model, double t, bool held_still, std::span<Frame> frames);

}  // namespace dougong::engine
