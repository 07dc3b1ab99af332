// How far every joint of a building opened and slid in a run, and what it bore.
//
// A joint is a face that two blocks share at rest, bonded or dry (self_weight.h): from `start` to `end`, t
// along it and n, t turned by 90 degrees, towards b; both turn with a. Of a point P of the face, as fixed in
// a and as fixed in b,
//   d(P) = P_b - P_a                         since the first output time (m)
//   opening = greatest n . d of both ends    slip = t . d, mean of both ends
// They are followed until a or b is lost: after that the face is none. Closed faces have a negative opening,
// by the compression of the blocks; it reads 0.
//
// Forces are those of the bond's springs and of the contacts between the two blocks (which bear the
// compression of a cracked bond), at the output times. A contact belongs to the joint of its blocks whose
// middle was nearest at rest; contacts of blocks that had none are no joint of the building's.
#pragma once

#include <map>

#include "structures/response.h"
#include "structures/self_weight.h"

namespace dougong::structures {

struct JointMotion {
  Peak opening;                   // m, the widest
  Peak slip;                      // m, the farthest, signed: b towards `end` is positive
  double residual_opening = 0.0;  // m, mean of the last second, or when a or b was lost
  double residual_slip = 0.0;     // m
};

/// Of every joint; terrains, numbered behind the blocks, move with the ground.
std::vector<JointMotion> joint_motions(const std::vector<FaceLoad>& joints, const Trajectory& trajectory,
                                       const std::vector<BlockLoss>& losses);

struct JointForces {
  Peak compression, tension;  // N, both positive
  Peak shear;                 // N, signed as FaceLoad's
};

/// Follows the forces of joints while a run goes.
class JointForceRecorder {
 public:
  JointForceRecorder() = default;
  /// joints: face_loads() of this state, at rest.
  JointForceRecorder(std::vector<FaceLoad> joints, const engine::Model& model, const engine::State& rest);

  /// `frames` are the state's.
  void note(const engine::Model& model, const engine::State& state, std::span<const engine::Frame> frames);

  const std::vector<FaceLoad>& joints() const { return joints_; }
  const std::vector<JointForces>& forces() const { return forces_; }

 private:
  const std::size_t* joint_of(const FaceLoad& face, const engine::Model& model,
                              std::span<const engine::Frame> frames) const;

  struct Sum {
    double normal = 0.0, shear = 0.0;  // N
  };
  std::vector<FaceLoad> joints_;
  std::vector<engine::Vec2> middle_;  // m, of each in the frame of its a
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> of_blocks_;
  std::map<std::size_t, std::size_t> of_bond_;
  std::vector<JointForces> forces_;
  std::vector<Sum> sums_;
};

}  // namespace dougong::structures
