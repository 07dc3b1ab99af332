// The verdict on a building, with its evidence. A blow-up is never a collapse; silent sinking is
// never survival.
//
// The rules, in order; the first that applies decides:
//   numerically invalid   the numbers are not finite, the run diverged, the energy balance does not
//                         close, or blocks sank into each other: nothing is said about the building
//   collapsed             a storey was lost, or too much of the mass fell
//   undecided             the run ended early, or at its end something still moves, drifts or leans so
//                         far that what follows is open
//   survived              none of these
// The reasons for the bounds are in docs/theory/response.md.
#pragma once

#include <string>
#include <vector>

#include "structures/response.h"

namespace dougong::structures {

enum class VerdictKind { survived, collapsed, numerically_invalid, undecided };

/// How the run ended and how good its numbers are.
struct NumericalEvidence {
  enum class Outcome { completed, diverged, interrupted, stopped };

  Outcome outcome = Outcome::completed;
  std::string outcome_detail;       // "speed of S1.slab beyond 1e6 m/s"; may be empty
  bool finite = true;               // every number of the run
  double energy_error_ratio = 0.0;  // -, greatest energy error over the energy turned over (engine/energy.h)
  double deepest_overlap_ratio = 0.0;  // -, over the smaller block's least width
  std::string deepest_overlap_where;   // "S1.column.left / ground at 3.21 s"
  double end_time = 0.0;               // s, reached
  double asked_time = 0.0;             // s
  double greatest_speed_at_end = 0.0;  // m/s, of any block, relative to the ground
};

struct VerdictCriteria {
  /// 5 % of the energy turned over is about 2.5 % of a velocity or a drift.
  double energy_error = 0.05;
  /// A tenth of a block: beyond it the geometry is no longer the building's. Far above any strain
  /// that the linear contact stands for, and above the dent of an honest impact.
  double overlap = 0.1;
  /// Less is local damage. A share of the building's mass.
  double fallen_mass = 0.1;
  /// 0.1 m/s lifts a block by v^2/2g = 0.5 mm, too little to tip any block of building size.
  double speed_at_end = 0.1;  // m/s
  /// Over the lean at which the block topples when it stands alone.
  double lean = 1.0;
  /// Growth of a storey's drift over the last residual_window, against the one before it.
  double drift_growth = 1e-3;
};

struct Verdict {
  VerdictKind kind = VerdictKind::undecided;
  std::string headline;               // one sentence
  std::vector<std::string> evidence;  // one sentence each, numbers with units
};

Verdict judge(const Response& response, const NumericalEvidence& numerics,
              const VerdictCriteria& criteria = {});

std::string to_string(VerdictKind kind);  // "survived", "collapsed", "numerically invalid", "undecided"

}  // namespace dougong::structures
