// What every joint bears in a state at rest: stresses, where the force passes, how much of its strength is
// used.
//
//   N  compression, T  shear, over the face (N); e  from the middle of the face to where N passes (m)
// `through` is that place: from block to block it is the line of thrust. The face resists closing with the
// stiffness k of its points together; the blocks themselves, columns between their centroids (h_a, h_b from
// the face, the ground rigid), with
//   k_blocks = 1 / (h_a / (E_a A) + h_b / (E_b A))
// so k / k_blocks tells how much softer or harder the joint is than what it joins.
// A bonded face of length L and area A has two points at +-L/(2 sqrt 3), whose stresses s1, s2 give
//   s(edge) = (s1 + s2)/2 +- sqrt(3) (s1 - s2)/2
// and uses of its strength  tension at its edge / tensile strength, or force / yield of a ductile point, and
// |T| / (cohesion + mu N) and N / crushing force at the worse point, if it has one. A dry face has no
// tension: with e' = 2 |e| / L its greatest stress is
//   N/A (1 + 3 e')  to e' = 1/3,   4/3 N / (A (1 - e'))  beyond,
// and it uses e' of what it can turn before it hinges about its end, and |T| / (mu N) of its friction.
// Navier's linear stress, as in Heyman, The Stone Skeleton (1966). A face without a strength in compression,
// as every dry one, has its stress given and not judged.
#pragma once

#include <string>
#include <vector>

#include "engine/state.h"

namespace dougong::structures {

enum class FaceLimit { none, tension, yield, crushing, shear, friction, turning };
std::string to_string(FaceLimit limit);

struct FaceLoad {
  bool bonded = false;
  std::size_t bond = 0;       // of the scene, if bonded
  std::size_t a = 0, b = 0;   // bodies; terrains are numbered behind them
  engine::Vec2 start, end;    // m, of the face
  engine::Vec2 through;       // m, where N passes it, no farther than its ends
  double normal = 0.0;        // N, compression
  double shear = 0.0;         // N
  double eccentricity = 0.0;  // -, e', unsigned; of a face in tension too
  double compression = 0.0;   // Pa, the greatest; infinite at a corner
  double tension = 0.0;       // Pa, the greatest
  double used = 0.0;          // of the limit that is nearest
  FaceLimit limit = FaceLimit::none;
  double stiffness = 0.0;         // N/m, k
  double blocks_stiffness = 0.0;  // N/m, k_blocks; 0 at a corner
};

/// Bonds first, in the scene's order, then the pairs that touch. A bond that has broken altogether is left
/// out.
std::vector<FaceLoad> face_loads(const engine::Model& model, const engine::State& state);
/// The same in motion, `frames` those of the state: bonds by their springs, contacts with their dashpots.
std::vector<FaceLoad> face_loads(const engine::Model& model, const engine::State& state,
                                 std::span<const engine::Frame> frames);

/// Places in the list, the most used first.
std::vector<std::size_t> by_use(const std::vector<FaceLoad>& faces);

}  // namespace dougong::structures
