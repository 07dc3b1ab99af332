// Joints and bond points as a compiled scene holds them: indices into bodies and terrains, local coordinates.
#pragma once

#include "engine/bonds/bond_law.h"
#include "engine/collision/collider.h"
#include "engine/joint.h"

namespace dougong::engine {

struct BondPoint {
  Index a = 0, b = 0;
  Vec2 anchor_b;  // m, in the frame of b
  Vec2 normal_a;  // -, in the frame of a, from a to b
  Vec2 offset;    // m, of the face from the centroid of a, along normal and tangent
  BondStiffness law;
  double damping_ratio = 0.0;  // -, of law's dashpots
};

struct JointElement {
  JointKind kind = JointKind::pin;
  Index a = 0, b = 0;
  Vec2 anchor_a, anchor_b;                                      // m, in the frames of a and b
  double stiffness = 0.0;                                       // N/m
  double damping = 0.0;                                         // N s/m
  double rotational_stiffness = 0.0, rotational_damping = 0.0;  // N m/rad, N m s/rad
  double rest_length = 0.0;                                     // m
  double rest_angle = 0.0;                                      // rad, angle of b less that of a
  bool axial() const { return kind == JointKind::distance || kind == JointKind::spring; }
};

}  // namespace dougong::engine
