// The model check: what is wrong or doubtful about a building before anything is computed.
//
// Errors make a run meaningless: overlapping blocks, blocks that hang in the air, no ground, a level
// without blocks. Warnings are things that are rarely meant: hairline gaps under a block, a centre of
// mass beside its support, slivers, masses or stiffnesses too far apart for one time step.
//
// A block is supported when a chain of touches, each with its normal within about 75 degrees of
// upright, and of bonds and joints leads to a terrain, or when it belongs to a row of blocks that leans on
// supported ones to both sides, as near the crown of an arch. A block whose own centre of mass lies beside
// its support topples at once unless a neighbour pushes it back or what stands on it holds it down, which
// this check does not judge.
#pragma once

#include <string>
#include <vector>

#include "structures/building.h"

namespace dougong::structures {

enum class Severity { warning, error };

struct Finding {
  Severity severity = Severity::warning;
  std::string message;  // names the blocks, the amount and the place
  engine::Vec2 place;   // m
};

struct ModelCheckOptions {
  /// Deeper is an overlap (m). Concrete at 1 MPa shortens by 0.03 mm a metre: less is noise.
  double overlap_tolerance = 1e-5;
  /// Closer is a touch (m): rounding of coordinates, far below any joint.
  double touch_tolerance = 1e-6;
  /// An opening below a block of less than this looks like a mistake (m): it closes with a jolt of
  /// sqrt(2 g gap), 0.14 m/s for 1 mm.
  double suspicious_gap = 1e-3;
  /// Largest over smallest block mass, or Young's modulus. The step follows the lightest and stiffest
  /// block: 1e4 makes it 100 times shorter than the rest needs, and beyond 1e7 the rounding of the
  /// heavy blocks' forces is no longer small against the light blocks' weights.
  double doubtful_ratio = 1e4;
  double absurd_ratio = 1e7;
  /// Length over least width of a block; the slabs of the shipped layouts have 53.
  double sliver_ratio = 100.0;
};

/// Errors first, then warnings; each in the order of the blocks.
std::vector<Finding> check_model(const Building& building, const ModelCheckOptions& options = {});

std::string to_string(Severity severity);  // "warning", "error"

}  // namespace dougong::structures
