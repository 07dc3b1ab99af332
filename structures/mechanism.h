// How a structure begins to move at collapse: which blocks, and what its joints do.
//
// From the equilibrium under the load that still stood and the motion of each block under the load that none
// stood. At every point where two blocks touch or are bonded there, the motion opens the joint and slips it
// by
//   o = n . d,  s = t . d,   d = (u_b + phi_b x r_b) - (u_a + phi_a x r_a)
// u translation, phi turn, r from the centroid to the point. Over the points of a pair:
//   hinge    one end opens, the other stays
//   sliding  it slips where it stays closed
//   parting  all of it opens
#pragma once

#include "structures/collapse_multiplier.h"

namespace dougong::structures {

enum class JointAction { hinge, sliding, parting };
std::string to_string(JointAction action);

struct MovingJoint {
  JointAction action = JointAction::hinge;
  std::size_t a = 0, b = 0;  // bodies; terrains are numbered behind them
  engine::Vec2 place;        // m: of a hinge the point that stays, else the middle
  engine::Vec2 tangent;      // along the joint
  double opening = 0.0;      // m, the greatest
  double slip = 0.0;         // m, of b along the tangent, where the joint opens least
};

struct Mechanism {
  std::vector<std::size_t> moving;  // blocks, the one that moves most first
  std::vector<MovingJoint> joints;
};

struct MechanismOptions {
  double moving = 0.1;  // of the greatest translation of a block: less is at rest
  double acting = 0.2;  // of the greatest opening or slip of a joint: less is closed
};

/// `standing` is a state of the model; without motions nothing fell, and nothing moves.
Mechanism mechanism_of(const engine::Model& model, const engine::State& standing,
                       const std::vector<BlockMotion>& motions, const MechanismOptions& options = {});

}  // namespace dougong::structures
