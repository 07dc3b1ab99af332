// Response of a building: what engineers ask of a run.
//
//   u_i(t)   mean horizontal displacement of the level's blocks, mass-weighted, relative to the ground
//   theta_i  interstorey drift ratio = (u_i - u_(i-1)) / h_i, h_i the original storey height
//   floor acceleration is absolute; base shear V is the horizontal force of the ground on the building
//
// A storey is lost when its level has lost its support or too much of its mass (LossCriteria). Its
// drift is frozen from then on (the value at the loss is kept) and its peak is taken before the loss.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/vec2.h"
#include "structures/building.h"

namespace dougong::structures {

/// Poses of every block at the output times, and what the ground did and bore.
struct Trajectory {
  std::vector<double> times;                      // s, nt of them
  std::size_t blocks = 0;                         // nb
  std::vector<double> poses;                      // nt x nb x 3: x (m), y (m), angle (rad)
  std::vector<engine::Vec2> ground_displacement;  // nt, m
  std::vector<engine::Vec2> ground_reaction;      // nt, N, force of the ground on the building
  std::vector<double> accelerations;              // nt x nb, m/s2, horizontal, absolute

  engine::Vec2 position(std::size_t step, std::size_t block) const {
    const double* p = &poses[3 * (step * blocks + block)];
    return {p[0], p[1]};
  }
  double angle(std::size_t step, std::size_t block) const { return poses[3 * (step * blocks + block) + 2]; }
  double acceleration(std::size_t step, std::size_t block) const { return accelerations[step * blocks + block]; }
};

struct Peak {
  double value = 0.0;  // signed
  double time = 0.0;   // s
};
/// Both signs of a history, each with its time.
struct Envelope {
  Peak positive;
  Peak negative;
  /// The one of larger magnitude, sign kept.
  Peak largest() const { return positive.value >= -negative.value ? positive : negative; }
};

struct StoreyResponse {
  std::string name;
  double height = 0.0;                    // m
  std::vector<double> drift;              // nt, -, frozen once lost
  std::vector<double> floor_displacement; // nt, m, relative to the ground
  std::vector<double> floor_acceleration; // nt, m/s2, absolute
  Envelope peak_drift;                    // before any loss
  Envelope peak_acceleration;             // m/s2, before any loss
  double residual_drift = 0.0;            // -, mean of the last second, or at the loss
  double original_mass = 0.0;             // kg
  std::vector<double> mass_lost;          // nt, fraction of the storey's original mass
  std::optional<double> lost_at;          // s
};

struct BlockLoss {
  std::size_t block = 0;
  double time = 0.0;       // s
  std::string reason;      // "fell 1.30 m", "turned 41 deg", ...
};

struct Response {
  std::vector<double> times;
  std::vector<StoreyResponse> storeys;
  std::vector<double> roof_displacement;  // nt, m, relative to the ground
  Envelope peak_roof_displacement;
  std::vector<double> base_shear;         // nt, N, positive when the ground pushes the building to +x
  Envelope peak_base_shear;               // N
  double weight = 0.0;                    // N
  std::vector<BlockLoss> losses;          // in order of time
  std::optional<double> first_loss_of_support;  // s
  double fallen_mass_fraction = 0.0;      // of the whole building, at the end
};

}  // namespace dougong::structures
