// Forces, energy and stiffness of one pair field: U = K w_i w_j / s,  s^2 = r^2 + softening^2,
//     F_i = K w_i w_j (r_i - r_j) / s^3
//
// The direct sum takes every pair once, so that the two forces are opposite to the last bit. With an
// opening angle and enough bodies the tree takes over (fields/tree.h). Two bodies at one place without
// softening give a motion that is not finite, which drive() reports.
#pragma once

#include "engine/fields/tree.h"

namespace dougong::engine {

/// Fewer bodies are summed directly, which is then the cheaper (measured: the tree breaks even at 1200, 700
/// and 450 bodies for angles of 0.3, 0.5 and 0.8).
inline constexpr std::size_t smallest_tree = 512;
bool uses_tree(const PairField& field);

void add_pair_forces(const PairField& field, std::span<const Frame> frames, Tree& scratch,
                     std::span<Vec2> forces);
double pair_energy(const PairField& field, std::span<const Frame> frames, Tree& scratch);

/// Bound on the eigenvalues of M^-1/2 K M^-1/2 (rad2/s2) at these places, for |K_ij| <= 2 |K w_i w_j|/s^3:
/// Gershgorin's row sums with blocks of bodies.
double pair_stiffness(const PairField& field, std::span<const double> mass, std::span<const Frame> frames,
                      Tree& scratch);

}  // namespace dougong::engine
