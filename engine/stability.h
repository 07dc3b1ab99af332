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

#include <array>

#include "engine/state.h"

namespace dougong::engine {

struct SpectralBound {
  double stiffness = 0.0;  // of M^-1 K, rad2/s2; sqrt of it is the highest angular frequency
  double damping = 0.0;    // of M^-1 C, 1/s
};

SpectralBound spectral_bound(const Model& model, const State& state, std::span<const Frame> frames);

/// The row sums of every body, kept, so that contacts that come and go cost no more than their own rows.
class StabilityRows {
 public:
  explicit StabilityRows(const Model& model);

  /// All rows, for the poses of now.
  SpectralBound assemble(const Model& model, const State& state, std::span<const Frame> frames,
                         Crew& crew = Crew::alone());
  /// The rows of those bodies only (terrains are passed over); the others' stay as they were.
  SpectralBound renew(const Model& model, const State& state, std::span<const Frame> frames,
                      std::span<const Index> bodies);

  using Row = std::array<double, 3>;  // along x, y, angle
  using Block = std::array<Row, 3>;

 private:
  // Of K and of C: a body's own block, and the sums over the other bodies' blocks in its rows.
  struct BodyRows {
    Block stiffness{}, damping{};
    Row other_stiffness{}, other_damping{};
  };
  struct Strut;
  class Coupling;

  Row row_of(Index body, Vec2 direction, Vec2 arm) const;
  Row turn_of(Index body) const { return {0.0, 0.0, root_inertia_[body]}; }
  void add_strut(const Strut& strut, Coupling& on_a, Coupling& on_b) const;
  void add_to_links(Index a, Index b, const Coupling& on_a, const Coupling& on_b);
  void add_joint(const JointElement& joint, std::span<const Frame> frames);
  void add_bond(const Model& model, const BondState& state, std::size_t first, std::span<const Frame> frames);
  void add_point(const ContactPoints& points, std::size_t i, Index body, std::span<const Frame> frames,
                 Coupling& coupling) const;
  void renew_body(const ContactSet& contacts, Index body, std::span<const Frame> frames);
  SpectralBound largest(const Model& model, std::span<const Frame> frames) const;

  std::size_t bodies_;
  std::vector<double> root_mass_, root_inertia_;  // 1/sqrt of them; of terrain 0
  std::vector<BodyRows> links_;                   // what joints and bonds add; empty where there are none
  std::vector<SpectralBound> rows_;               // the largest row sum of each body
};

}  // namespace dougong::engine
