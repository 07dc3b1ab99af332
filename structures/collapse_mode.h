// How a building collapsed, as practitioners name it.
//
// The mode is that of the beginning: what is asked is asked at the time t of the loss of the storey that was
// lost first (loss.h), of that building and not of its neighbour. The first answer that is yes decides:
//
//   partial         no storey was lost: single blocks fell
//   pounding        the neighbours touched within pounding_before ahead of the first loss of support
//   overturning     the storeys that were lost turned as one body, by at least least_turn: the best rigid
//                   motion of their outlines explains rigid_share of what they moved about their centroid,
//                   and the blocks turned with it (block_turn of its angle in the mean)
//   sliding         most of what the storey had lost left its place sideways (loss.h) without turning by
//                   standing_turn in the mean
//   out of support  what carried it stood, and a floor or beam, at least floor_width of the storey wide, fell
//   partial wall    what carried it stood, and smaller blocks fell
//   pancake         the level came down on the one below by at least as much as it went aside
//   soft storey     one of several storeys had soft_share of all displacement between storeys
//   sway            that displacement was spread over the storeys, or there is only one
//
// "Stood": turned by less than standing_turn in the mean of the mass, not lost for its greater part, and not
// down by half of what the level is down.
#pragma once

#include <string>
#include <vector>

#include "structures/loss.h"

namespace dougong::structures {

enum class CollapseMode {
  none,
  partial,
  pounding,
  overturning,
  sliding,
  out_of_support,
  partial_wall,
  pancake,
  soft_storey,
  sway
};
inline constexpr CollapseMode collapse_modes[] = {CollapseMode::none,         CollapseMode::partial,
                                                  CollapseMode::pounding,     CollapseMode::overturning,
                                                  CollapseMode::sliding,      CollapseMode::out_of_support,
                                                  CollapseMode::partial_wall, CollapseMode::pancake,
                                                  CollapseMode::soft_storey,  CollapseMode::sway};
/// "none", "partial", "pounding", ... "soft storey", "sway".
std::string to_string(CollapseMode mode);

/// The project's own: no standard draws these lines. The reasons are in docs/theory/response.md.
struct ModeCriteria {
  double pounding_before = 1.0;                // s
  double least_turn = 0.08726646259971647;     // rad, 5 deg
  double rigid_share = 0.75;                   // of the mass-weighted sum of squares
  double block_turn = 0.5;                     // of the angle of the body
  double standing_turn = 0.17453292519943295;  // rad, 10 deg
  double floor_width = 0.5;                    // of the storey's width
  double soft_share = 0.6;                     // of the sum of displacements between storeys
};

struct ModeFinding {
  CollapseMode mode = CollapseMode::none;
  std::vector<std::string> reasons;  // sentences, with the numbers that decided
};

/// The level that was lost first; the lowest of several. `never` when none was.
std::size_t first_lost(const Losses& losses);
/// The storeys [from, to) of the building that this one belongs to; it ends where a neighbour stands.
struct StoreyRange {
  std::size_t from = 0, to = 0;
};
StoreyRange building_of_storey(const Building& building, std::size_t storey);

/// `initiation`: the output time from which the first support was lost.
ModeFinding find_mode(const Building& building, const Trajectory& trajectory, const Losses& losses,
                      std::size_t initiation, const ModeCriteria& criteria = {});

}  // namespace dougong::structures
