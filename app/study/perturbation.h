// A building that might as well have been: the one described, with small changes that nobody could have
// measured. Blocks slide and rock chaotically, so one run is one of many that the same description allows.
//
// Every change is uniform within plus or minus the amount, drawn from a counter: (seed, member, what, which)
// makes the number, so that a member is the same in any order and on any number of threads. Member 0 is the
// building as described.
#pragma once

#include <cstdint>
#include <memory>

#include "seismic/motions/ground_motion.h"
#include "structures/building.h"

namespace dougong::app {

struct Perturbation {
  double position = 1e-4;   // m, sideways, of every block or of blocks that are tied together as one
  double friction = 0.02;   // -, of its value, of every material, pair of materials and bond
  double strength = 0.02;   // -, of its value, of every bond
  double damping = 0.05;    // -, of its value, of every material, bond and joint
  double amplitude = 0.01;  // -, of the motion
  double seed = 1;
};

/// What is tied to the ground stays where it is.
void perturb(structures::Building& building, const Perturbation& by, std::size_t member);
std::shared_ptr<const seismic::GroundMotion> perturbed(std::shared_ptr<const seismic::GroundMotion> motion,
                                                       const Perturbation& by, std::size_t member);

}  // namespace dougong::app
