// The matrix of Newton's methods for rigid contacts, M + sum J' G J over the points: G (kg) says how the
// impulse of a point, along normal and tangent, falls as its relative velocity grows.
#pragma once

#include "engine/nonsmooth/block_lu.h"
#include "engine/nonsmooth/impulse_problem.h"

namespace dougong::engine {

/// By rows: normal impulse over normal and tangential velocity, tangential impulse over both (kg).
using PointGain = std::array<double, 4>;

class ContactMatrix {
 public:
  /// Which bodies touch: all that is kept from one problem to the next.
  void prepare(const ImpulseProblem& problem);
  void set_mass(const ImpulseProblem& problem);
  void add(const ImpulsePoint& point, const PointGain& gain);
  /// Returns false for a singular matrix.
  bool factorise() { return matrix_.factorise(); }
  /// In place; what stands for terrains stays as it is.
  void solve(std::span<PlaneVelocity> x) { matrix_.solve(x.first(bodies_)); }

 private:
  std::size_t bodies_ = 0;
  std::vector<BodyPair> pairs_, wanted_pairs_;
  BlockLu matrix_;
};

}  // namespace dougong::engine
