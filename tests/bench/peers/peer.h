// Another engine as the wall sees it: bricks on a ground that is moved, steps, and where the bricks are.
//
// Metres, seconds and kilograms at this border; a driver converts to the units its engine likes. All peers
// lay the bricks face to face, know one friction coefficient, do not bounce and never put a body to sleep.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "engine/vec2.h"

namespace dougong::peers {

struct Box {
  engine::Vec2 centre, size;  // m, width and height
};

struct Wall {
  std::vector<Box> bricks;
  Box ground;
  double density = 0.0;   // kg/m3, of a thickness of 1 m
  double friction = 0.0;  // between any two
  double gravity = 0.0;   // m/s2, downwards
};

class Peer {
 public:
  virtual ~Peer() = default;
  /// One step of h (s), the ground going sideways at a constant speed (m/s).
  virtual void step(double h, double ground_speed) = 0;
  virtual engine::Vec2 position(std::size_t brick) const = 0;  // m, of the centre
};

struct PeerKind {
  const char* name;
  const char* settings;  // what is not the library's default, or worth knowing
  std::unique_ptr<Peer> (*build)(const Wall& wall);
};

/// The engines whose libraries were found when this was built.
std::span<const PeerKind> peers();

}  // namespace dougong::peers
