// Which blocks and levels are lost, when and why (LossCriteria in structures/response.h).
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "structures/building.h"
#include "structures/response.h"

namespace dougong::structures {

inline constexpr std::size_t never = std::numeric_limits<std::size_t>::max();

/// How far a block may go before it is lost; a limit that does not apply is infinite.
struct LossLimits {
  double drop = std::numeric_limits<double>::infinity();   // m
  double turn = std::numeric_limits<double>::infinity();   // rad
  double slide = std::numeric_limits<double>::infinity();  // m
};

/// The first of the three that held.
enum class LossCause { fell, turned, left_its_place };

struct Loss {
  std::size_t step = never;   // output time of the loss
  std::size_t onset = never;  // output time from which it had no support any more, <= step
  std::string reason;
  LossCause cause = LossCause::fell;  // of a block
};

/// What of a building is lost, and when.
struct Losses {
  std::vector<double> masses;  // kg, one a block
  std::vector<Loss> blocks;    // one a block
  std::vector<Loss> levels;    // one a storey, bottom up
};

/// Movement of a block since the first output time, relative to the ground (m).
engine::Vec2 displacement(const Trajectory& trajectory, std::size_t step, std::size_t block);

/// One entry a block.
std::vector<LossLimits> loss_limits(const Building& building, const LossCriteria& criteria);
std::vector<Loss> find_block_losses(const Building& building, const Trajectory& trajectory,
                                    const LossCriteria& criteria);
/// One entry a block (kg).
std::vector<double> masses_of(const engine::Scene& scene);
Losses find_losses(const Building& building, const Trajectory& trajectory, const LossCriteria& criteria);
/// One entry a storey, bottom up; masses has one entry a block (kg).
std::vector<Loss> find_level_losses(const Building& building, const std::vector<Loss>& blocks,
                                    const std::vector<double>& masses, const LossCriteria& criteria);

}  // namespace dougong::structures
