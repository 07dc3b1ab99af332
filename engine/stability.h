// How fast a scene can vibrate: bounds on the eigenvalues of M^-1 K and M^-1 C.
//
// Gershgorin's theorem on the symmetrically scaled matrices M^(-1/2) K M^(-1/2): no eigenvalue exceeds
// the largest row sum of absolute values. The rows are assembled first (3 x 3 blocks of every body and
// pair), so that terms that cancel do cancel. Every contact point counts, touching or not, as if it
// stuck: the bound also holds for the contact that is about to close.
// What fields add is an estimate for the present places and speeds (fields/fields.h): a close passage raises
// it at any time, so drive() asks again every base interval.
// An integrator turns the two bounds into its largest stable step (Integrator::stable_step).
#pragma once

#include "engine/state.h"

namespace dougong::engine {

struct SpectralBound {
  double stiffness = 0.0;  // of M^-1 K, rad2/s2; sqrt of it is the highest angular frequency
  double damping = 0.0;    // of M^-1 C, 1/s
};

SpectralBound spectral_bound(const Model& model, const State& state, std::span<const Frame> frames);

}  // namespace dougong::engine
