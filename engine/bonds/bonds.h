// The bonds of a scene, compiled: two Gauss points for each face, and the kernel that turns poses into
// forces.
//
// A point is an anchor of body b against the face of body a, as a contact's corner is against an edge
// (contact/contact_points.h): opening g = n . (p_b - e_a), slip s = t . (p_b - e_a), n and t turning with a.
// Both are functions of the poses alone, so the elastic forces have a potential. With the points at
// +-L/(2 sqrt 3) and half the area each, the pair carries the moment of the linear stress over the face:
// bending stiffness k L^3/12 exactly.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/bonds/bond_law.h"
#include "engine/collision/broad_phase.h"
#include "engine/frame.h"

namespace dougong::engine {

/// What a point did at the last committed poses, for the work since then.
struct BondPast {
  double opening = 0.0, slip = 0.0;                       // m
  double normal = 0.0, tangential = 0.0;                  // N
  double normal_dashpot = 0.0, tangential_dashpot = 0.0;  // N
};

struct BondState {
  std::vector<BondHistory> history;  // one a point
  std::vector<BondPast> past;
  std::size_t broken = 0;  // points
  bool cracked = false;    // a face that was joined has a crack: release_cracked() is due
  bool loosened = false;   // a point of a cracked face broke: tied_pairs() may have changed
};

struct BondGeometry {
  Vec2 normal, arm_a, arm_b;         // -, m: from the centroids to the anchor of b
  double opening = 0.0, slip = 0.0;  // m
};

/// Sums over the points: powers (W), and with `commit` the works since the last commit (J).
struct BondTotals {
  double damping_power = 0.0, spring_power = 0.0;
  double damping_work = 0.0, spring_work = 0.0;
};

/// The compiled points of a scene's bonds; bond i has points 2 i and 2 i + 1. Throws std::invalid_argument,
/// naming the bond, for owners that do not exist, a face without length or a stiffness or strength that is
/// not positive.
std::vector<BondPoint> compile_bonds(const Scene& scene, const Model& model);
/// Faces longer than what is bonded of them are not joined: they touch beside their bonds from the start.
BondState initial_bonds(const Model& model, std::span<const Frame> frames);

/// A pair of bodies whose face was joined, and the energy that its points had stored in compression (J).
struct ReleasedPair {
  BodyPair bodies;
  double energy = 0.0;
};
/// Leaves compression and friction to the contacts wherever a point has cracked.
std::vector<ReleasedPair> release_cracked(const Model& model, BondState& state,
                                          std::span<const Frame> frames);

/// Sorted pairs that do not touch because a pin, a weld or a joined face holds them.
std::vector<BodyPair> held_pairs(const Model& model, const BondState& state);

/// Sorted pairs whose joined face has a crack and that a bond ties yet: their contacts are damped as the bond
/// is.
std::vector<PairDamping> tied_pairs(const Model& model, const BondState& state);

BondGeometry bond_geometry(const BondPoint& point, std::span<const Frame> frames);
/// Adds the forces of all bonds. With `commit`, the poses are those of an accepted step: points yield and
/// break.
BondTotals add_bond_forces(const Model& model, BondState& state, std::span<const Frame> frames, bool commit,
                           std::span<Vec2> forces, std::span<double> torques);
double bond_energy(const Model& model, const BondState& state, std::span<const Frame> frames);

}  // namespace dougong::engine
