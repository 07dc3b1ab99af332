// Where what fell lies, and how hard it hit.
//
//   reach   how far the debris lies beyond a face of the building as it stood (m), at the last output time.
//           Debris are the lost blocks (loss.h); the faces are the outermost points of the blocks at the
//           first output time. Everything is relative to the ground.
//   impact  the greatest kinetic energy of a lost block after it lost its support,
//             E = 1/2 m |v|^2 + 1/2 J w^2   (J)
//           v (m/s, relative to the ground) and w (rad/s) as differences of successive output times. A
//           falling block is fastest just before it hits, and differences show it as it was half an output
//           interval earlier: E is short by the factor 1 - g dt/v, 2 % at 5 m/s and 100 Hz.
// What lies below the building's foot by more than its height has gone over the end of the ground and is
// counted apart.
#pragma once

#include <vector>

#include "structures/loss.h"
#include "structures/outline.h"

namespace dougong::structures {

struct Side {
  double reach = 0.0;  // m, beyond the face; 0 when nothing lies there
  double mass = 0.0;   // kg, of the debris whose centroids lie beyond the face
};

struct Footprint {
  double face_left = 0.0, face_right = 0.0;  // m, where the building stood
  double foot = 0.0, height = 0.0;           // m, of the building as it stood
  Side left, right;
  std::size_t over_the_edge = 0;  // blocks that fell off the ground's end
};

/// A block that was lost, and its hardest hit.
struct Fall {
  std::size_t block = 0;
  double support_lost = 0.0;  // s
  double hit = 0.0;           // s
  double speed = 0.0;         // m/s, before the hit
  double energy = 0.0;        // J
};

/// Outlines of all blocks at an output time, relative to the ground; one entry a block.
std::vector<std::vector<Outline>> block_outlines(const Building& building, const Trajectory& trajectory,
                                                 std::size_t step);
Extent extent_of_building(const Building& building, const Trajectory& trajectory, std::size_t step);

/// Needs an output time.
Footprint footprint(const Building& building, const Trajectory& trajectory, const Losses& losses);
/// In order of the loss of support.
std::vector<Fall> falls(const Building& building, const Trajectory& trajectory, const Losses& losses);

}  // namespace dougong::structures
