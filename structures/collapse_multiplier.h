// The collapse multiplier of blocks laid dry: the greatest part lambda of every block's weight that can push
// it sideways before the blocks become a mechanism. Found as on a tilting table: gravity of unchanged
// magnitude is turned by
//   theta,   lambda = tan theta
// which for rigid blocks without tension and with Coulomb friction is the same load up to its size, and the
// size does not matter.
//
// One trial holds the load of a multiplier, from the equilibrium of a smaller one:
//   1. the blocks look for their equilibrium under Cundall's local damping (engine/settle.h). It takes a part
//      of every unbalanced force, so it moves no equilibrium, and what has none goes on moving;
//   2. what has come to rest is let go without it and watched for hold_time: slow collapse looks like rest.
// A trial stands when no block moves by more than `away` in 1, comes to rest, and none does so in 2.
//
// Only where the answer lies does a trial have to be watched for so long. The search watches its trials for
// a part of hold_time, preliminary_hold, and once the bracket is narrow goes on watching the one at its lower
// end from where it was left, to the whole of hold_time. If that one falls it is the upper end, and the
// search goes on from the trial that stood before it.
//
// find_collapse_multiplier() raises the load in steps and halves them where a trial does not stand. Each
// trial starts where the last one stood, so the path is that of a load that grows slowly; the trial that
// bounds the answer from above is repeated from the nearest one that stood. With friction the answer of real
// (Coulomb) blocks depends on the path and lies at or below the associative one of limit analysis: Drucker,
// Q. Appl. Math. 11 (1954), "Coulomb friction, plasticity and limit loads"; Gilbert, Casapulla and Ahmed,
// Comput. Struct. 84 (2006) 873-887.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/settle.h"

namespace dougong::structures {

enum class TrialResult { stands, falls, undecided, numerically_invalid };
std::string to_string(TrialResult result);

struct TrialOptions {
  double longest_time = 20.0;      // s, simulated, to come to rest in
  double hold_time = 5.0;          // s, simulated, watched at rest
  double away = 0.05;              // of the least width of the smallest block
  double unbalanced_ratio = 1e-4;  // of the weight: at rest
  double local_damping = 0.8;      // while it looks for its equilibrium
};

/// What happened under the load of one multiplier, from where the trial began.
struct Trial {
  double multiplier = 0.0;  // -
  TrialResult result = TrialResult::undecided;
  double duration = 0.0;           // s, simulated
  double watched = 0.0;            // s of it, at rest without local damping
  double unbalanced_ratio = 0.0;   // of the weight, where it came to rest, or not
  double greatest_movement = 0.0;  // m
  std::string moved_most;          // name of that block
  double kinetic_energy = 0.0;     // J, at the end of the watch
  std::size_t broken_points = 0;   // of bonds, at its end
  std::string detail;              // of a run whose numbers failed
};

/// Holds the load that the scene describes; the state ends where the trial does.
Trial hold(const engine::Scene& scene, engine::State& state, const TrialOptions& options = {});

enum class Direction { left, right };

/// The scene with its gravity turned towards that side by arctan(multiplier).
engine::Scene tilted(const engine::Scene& scene, double multiplier, Direction towards = Direction::right);

struct TiltOptions {
  Direction towards = Direction::right;
  double first_increment = 0.1;   // of lambda
  double largest = 10.0;          // lambda at which the search ends
  double precision = 0.005;       // (falls - stands) / falls
  double preliminary_hold = 0.1;  // of trial.hold_time: watched before the bracket is narrow
  TrialOptions trial;
  std::function<bool(const Trial&)> go_on;  // told of every trial; false ends the search, undecided
};

struct BlockMotion {
  engine::Vec2 translation;  // m, of the centroid
  double turn = 0.0;         // rad
};

struct CollapseMultiplier {
  double stands = 0.0;  // the greatest multiplier that a trial stood for the whole of hold_time
  double falls = 0.0;   // the least that none stood; infinite if there is none below the largest
  TrialResult end = TrialResult::stands;  // of the trial at `falls`: why it is the upper bound
  std::vector<Trial> trials;              // in the order they were made; one that is watched on is two
  engine::State standing;                 // at `stands`
  std::vector<BlockMotion> mechanism;     // of each block in the trial at `falls`
};

/// The scene's own gravity is the weight, and turns towards that side. `stands` and `falls` are both 0 when
/// the blocks do not stand under their weight alone. Ends at a trial whose numbers failed, with `end` saying
/// so. Throws std::invalid_argument for a scene without gravity or without blocks, and options out of range.
CollapseMultiplier find_collapse_multiplier(const engine::Scene& scene, const TiltOptions& options = {});

/// A scene under the load of a multiplier: with the same bodies in the same order.
using LoadedScene = std::function<engine::Scene(double multiplier)>;
/// The same for any load that grows with its multiplier, as the forces of pushover.h; options.towards is not
/// looked at.
CollapseMultiplier find_collapse_multiplier(const engine::Scene& scene, const LoadedScene& loaded,
                                            const TiltOptions& options);

}  // namespace dougong::structures
