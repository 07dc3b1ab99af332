// Stiffness, damping and friction of a contact point, from the two materials and the geometry.
//
// Faces: the blocks are columns in series between the two centroids, so per area of contact
//     1/k = h_a/E_a + h_b/E_b,   point: kn = k L t / 2,   kt = kn G/E,  G/E = 1/(2(1+nu))
//   h distance from the centroid to the face (m), L length of the contact (m), t thickness (m).
//   Terrain is rigid (h = 0). Two points at the ends of L share it. L follows the poses and
//   counts as half of the smaller minimum width where corners meet (contact/bearing_length.h).
// Round contacts: the near-linear stiffness of parallel cylinders (Johnson, Contact Mechanics, 1985,
//   section 5.6): kn = pi/4 E* t, 1/E* = (1-nu_a^2)/E_a + (1-nu_b^2)/E_b, rigid terrain left out.
// Damping: cn = 2 xi sqrt(kn m_n), m_n = 1/(1/m_a + 1/m_b + r_a^2/I_a + r_b^2/I_b) the mass that the
//   point feels along its normal; ct likewise. Of a face at rest, xi is at most resting_damping_ratio.
// Of a pair that a bond ties yet, though its face has a crack, xi is at most the bond's (theory/bonds.md).
// Two materials: the smaller friction coefficient and the mean damping ratio, unless the scene gives the pair
// its own.
#pragma once

#include <optional>

#include "engine/collision/broad_phase.h"
#include "engine/collision/manifold.h"
#include "engine/contact/bearing_length.h"
#include "engine/contact/law.h"

namespace dougong::engine {

/// Of a point of a manifold at these poses.
BearingLength bearing_of(const Model& model, std::span<const Frame> frames, const Manifold& manifold,
                         const Feature& feature);

/// For a bearing length (m), which round contacts have none of. `most_damping`: of the damping ratio, where
/// something else damps the pair.
PointStiffness point_stiffness(const Model& model, std::span<const Frame> frames, const Manifold& manifold,
                               const Feature& feature, double length, BodyPair bodies,
                               std::optional<double> most_damping = {});

}  // namespace dougong::engine
