// Pushover: the capacity curve of a building under horizontal forces in fixed proportions that grow slowly.
//
//   lambda   multiplier of the pattern (load_pattern.h): the base shear over the weight, V/W
//   d        displacement that the pattern works on, sum p_i (x_i - x_i0) / W   (m)
//   u        roof displacement, mass-weighted mean of the roof's blocks         (m)
//
// Load control ends at the peak. Here the loads are pulled through one spring
// (engine/fields/applied_force.h),
//   lambda = kappa (s - d)
// and s grows in steps. Each step is held until the blocks are at rest under Cundall's local damping
// (engine/settle.h), which moves no equilibrium; lambda is read there. The path is stable while lambda falls
// by less than kappa per metre of d; beyond that it jumps to the next equilibrium, as it does where something
// brittle breaks. kappa = stiffness x (peak multiplier) / (target displacement): the spring alone takes a
// 1/stiffness of the target to reach the peak.
//
// A point of the curve is an equilibrium, not a promise: on the falling branch the building would go on by
// itself under dead loads. What is brittle breaks with a jolt, which may crack what is close to its strength
// beside it.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "structures/collapse_multiplier.h"

namespace dougong::structures {

/// The scene under `multiplier` times these forces (N, horizontal), towards that side.
engine::Scene pushed(const engine::Scene& scene, const std::vector<double>& forces, double multiplier,
                     Direction towards = Direction::right);

struct PushoverOptions {
  Direction towards = Direction::right;
  double peak = 0.0;                        // lambda that the structure is thought to bear: sets the spring
  double target = 0.0;                      // m, of the roof: where the curve ends
  double stiffness = 4.0;                   // of the spring, see above
  double rising_step = 0.04;                // of the peak, that the spring alone would gain in a step
  double falling_step = 0.025;              // of the target, greatest step
  double least_share = 0.1;                 // of the greatest lambda so far: ends the curve below
  TrialOptions trial;                       // its times, ratio and damping; nothing is watched
  std::vector<std::size_t> roof;            // blocks whose displacement is u; empty: those that p works on
  std::function<bool(double share)> go_on;  // told the share of the target reached; false ends it
};

/// A face that left its elastic range: when on the curve, and how.
struct BondEvent {
  std::size_t bond = 0;   // of the scene
  std::size_t point = 0;  // of the curve, after which it has happened
  std::string how;        // "tension", "shear", "yield", "crushing"
};

struct CapacityPoint {
  double multiplier = 0.0;        // -
  double displacement = 0.0;      // m, d
  double roof = 0.0;              // m, u, positive towards the side
  double unbalanced_ratio = 0.0;  // -
  std::size_t cracked = 0;        // bonds so far
};

enum class CurveEnd { target, spent, no_rest, numerically_invalid, interrupted };
std::string to_string(CurveEnd end);

struct CapacityCurve {
  std::vector<CapacityPoint> points;  // the first is the building at rest
  std::vector<BondEvent> events;      // by point, of one point the widest first
  CurveEnd end = CurveEnd::target;
  std::string detail;  // of a run whose numbers failed

  /// The place of the greatest multiplier; 0 without points.
  std::size_t peak() const;
};

/// Throws std::invalid_argument for a scene without gravity or blocks, forces that are not as many as the
/// blocks, and options out of range.
CapacityCurve capacity_curve(const engine::Scene& scene, const std::vector<double>& forces,
                             const PushoverOptions& options);

}  // namespace dougong::structures
