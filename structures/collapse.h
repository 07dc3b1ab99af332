// A collapse told: how it began, when it could no longer be stopped, how it went on and what it left.
//
//   initiation       the first loss of support (loss.h) of a block of the storeys that were lost; of any
//                    block when no storey was
//   no return        when gravity began to drive and did so to the end. With U(t) the gravitational energy
//                    of the blocks of the storey that was lost first (of all that were lost when no storey
//                    was), relative to the ground:
//                      U = sum m g (y - y_ground)   (J)
//                    A block that rocks lifts itself, and gravity brings it back until it stands over its
//                    corner; from there gravity takes it on. Looked at from the loss backwards: where U last
//                    fell below its value at the start, and from there back to the crest of that last
//                    excursion, or to the fall below itself when it had lifted nothing.
//   complete         when the last storey that was lost was lost
//   mode             collapse_mode.h
//   footprint, falls debris.h;   remaining voids voids.h, within the faces of the building as it stood and
//                    its height beyond them
// The point of no return is told with hindsight and of this motion: a push the other way would have moved it.
// Times are output times.
#pragma once

#include <optional>

#include "structures/collapse_mode.h"
#include "structures/debris.h"
#include "structures/voids.h"

namespace dougong::structures {

struct Collapse {
  CollapseMode mode = CollapseMode::none;
  std::vector<std::string> reasons;                       // for the mode
  std::optional<double> initiation, no_return, complete;  // s
  std::optional<double> first_touch;                      // s, of neighbours, before the initiation
  Footprint footprint;
  std::vector<Fall> falls;        // in order of the loss of support
  double impact_energy = 0.0;     // J, sum over the falls
  std::vector<Void> voids;        // that remain, largest first
  double void_area = 0.0;         // m2, of them all
  double void_area_before = 0.0;  // m2, as the building stood

  bool happened() const { return mode != CollapseMode::none; }
};

/// Without a lost block only first_touch is told. Throws std::invalid_argument as compute_response.
Collapse describe_collapse(const Building& building, const Trajectory& trajectory,
                           const LossCriteria& criteria = {}, const ModeCriteria& mode = {});

}  // namespace dougong::structures
