// Response of a building: what engineers ask of a run.
//
//   u_i(t)   mean horizontal displacement of the level's blocks, mass-weighted, relative to the ground
//            and to the first output time; blocks that are lost no longer count
//   theta_i  interstorey drift ratio = (u_i - u_(i-1)) / h_i, h_i the original storey height
//   floor acceleration is absolute; base shear V is the horizontal force of the ground on the building
//   M        overturning moment about the foot, of the horizontal inertia forces and with the sign of V,
//              M = sum m_b a_b (y_b - y_foot)   (N m)
//            the moment of the weight on a building that leans, and of vertical inertia, is not in it
//
// A storey is lost when its level has lost its support or too much of its mass (LossCriteria). Its
// drift is frozen from then on (the value at the loss is kept) and its peak is taken before the loss.
// There is no floor acceleration after the loss: it reads 0. The reasons for the defaults are in
// docs/theory/response.md.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/vec2.h"
#include "structures/building.h"

namespace dougong::structures {

/// When a block counts as lost, and with it its storey. A block is lost for good as soon as it has
///   fallen: gone down relative to the ground by more than drop_of_width of its least width, but never
///     by less than least_drop_of_storey nor needing more than most_drop_of_storey of its storey height;
///   turned: by more than turn since the start (circles may roll); or
///   left its place: moved past its storey's blocks (their median) by more than slide_of_length of its
///     own greatest extent.
/// A level is lost when more than level_mass of its mass is lost, when everything that carries it in
/// its storey is lost, or when the level below is lost.
struct LossCriteria {
  double drop_of_width = 0.5;          // -, a brick that drops one course has gone twice as far
  double least_drop_of_storey = 0.02;  // -, settling and rocking of thin plates is no fall
  double most_drop_of_storey = 0.5;    // -, half a storey down is a fall for any block
  double turn = 0.7853981633974483;    // rad, 45 deg: half-way to lying on its side
  double slide_of_length = 1.0;        // -, no part of it is where it was among its neighbours
  double level_mass = 0.5;             // -
};

/// Residual drift is the mean over this time at the end of the run (s).
inline constexpr double residual_window = 1.0;
/// A falling block has lost its support since it last stood higher than this part of the drop at
/// which it counts as fallen.
inline constexpr double onset_of_fall = 0.1;

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
  double acceleration(std::size_t step, std::size_t block) const {
    return accelerations[step * blocks + block];
  }
};

/// Throws std::invalid_argument, naming what does not fit, when the trajectory is not the building's.
void require_matching(const Building& building, const Trajectory& trajectory);

/// These of its output times alone.
Trajectory at_steps(const Trajectory& trajectory, const std::vector<std::size_t>& steps);

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
  double height = 0.0;                     // m
  bool is_base = false;                    // of isolators: no interstorey drift counts there
  std::vector<double> drift;               // nt, -, frozen once lost
  std::vector<double> shear_drift;         // nt, -, without the rotation of its base (shear_drift.h)
  std::vector<double> floor_displacement;  // nt, m, relative to the ground
  std::vector<double> floor_acceleration;  // nt, m/s2, absolute
  Envelope peak_drift;                     // before any loss
  Envelope peak_shear_drift;               // before any loss
  Envelope peak_acceleration;              // m/s2, before any loss
  double residual_drift = 0.0;             // -, mean of the last second, or at the loss
  double original_mass = 0.0;              // kg
  std::vector<double> mass_lost;           // nt, fraction of the storey's original mass
  std::optional<double> lost_at;           // s
  std::string lost_because;                // "100 % of its level's mass was lost"; empty while it stands
};

struct BlockLoss {
  std::size_t block = 0;
  double time = 0.0;   // s
  std::string reason;  // "fell 1.30 m", "turned 41 deg", ...
};

/// How far a standing block leans at the end, against the lean at which it would topple if it stood
/// alone: limit = atan(width / height).
struct Lean {
  std::string block;   // name; empty when no block stands
  double angle = 0.0;  // rad, since the start, signed
  double limit = 0.0;  // rad
  double ratio() const { return limit > 0.0 ? (angle < 0.0 ? -angle : angle) / limit : 0.0; }
};

struct Response {
  std::vector<double> times;
  std::vector<StoreyResponse> storeys;
  std::vector<double> roof_displacement;  // nt, m, relative to the ground
  Envelope peak_roof_displacement;
  std::vector<double> base_shear;               // nt, N, positive when the ground pushes the building to +x
  Envelope peak_base_shear;                     // N, before any storey is lost
  double weight = 0.0;                          // N
  std::vector<double> overturning_moment;       // nt, N m
  Envelope peak_overturning_moment;             // N m, before any storey is lost
  double height = 0.0;                          // m, of the levels above the foot
  std::vector<BlockLoss> losses;                // in order of time
  std::optional<double> first_loss_of_support;  // s
  double fallen_mass_fraction = 0.0;            // of the whole building, at the end
  Envelope peak_base_shear_ratio;               // -, V/W
  std::size_t blocks = 0;                       // of the building
  Lean greatest_lean;                           // at the end, the one nearest to its limit
};

/// The storey with the largest peak drift of either sign; null without storeys.
const StoreyResponse* storey_of_peak_drift(const Response& response);
/// The standing storey with the largest residual drift; null when none stands.
const StoreyResponse* storey_of_residual_drift(const Response& response);

/// Throws std::invalid_argument when the trajectory does not belong to the building. A trajectory
/// without any output time gives a response without histories.
Response compute_response(const Building& building, const Trajectory& trajectory,
                          const LossCriteria& criteria = {});

/// When the last storey was lost (s); empty while one stands.
std::optional<double> total_loss(const Building& building, const Trajectory& trajectory,
                                 const LossCriteria& criteria = {});

}  // namespace dougong::structures
