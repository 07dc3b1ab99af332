#include "engine/nonsmooth/contact_matrix.h"

#include <algorithm>

namespace dougong::engine {
namespace {

// Rows of J for one body: force and torque of a unit impulse along the normal, and along the tangent.
struct Rows {
  std::array<double, 3> normal, tangential;
};

Rows rows_of(const ImpulsePoint& p, Vec2 arm, double side) {
  const Vec2 n = side * p.normal, t = turned(n);
  return {{n.x, n.y, cross(arm, n)}, {t.x, t.y, cross(arm, t)}};
}

// block += left' G right
void add_product(Block& block, const Rows& left, const PointGain& g, const Rows& right) {
  for (std::size_t j = 0; j < 3; ++j) {
    const double n = g[0] * right.normal[j] + g[1] * right.tangential[j];
    const double t = g[2] * right.normal[j] + g[3] * right.tangential[j];
    for (std::size_t i = 0; i < 3; ++i) block[3 * i + j] += left.normal[i] * n + left.tangential[i] * t;
  }
}

}  // namespace

void ContactMatrix::prepare(const ImpulseProblem& problem) {
  wanted_pairs_.clear();
  for (const ImpulsePoint& p : problem.points)
    if (p.corner < problem.bodies && p.edge < problem.bodies)
      wanted_pairs_.push_back({std::min(p.corner, p.edge), std::max(p.corner, p.edge)});
  if (wanted_pairs_ == pairs_ && bodies_ == problem.bodies) return;
  pairs_ = wanted_pairs_, bodies_ = problem.bodies;
  matrix_.analyse(bodies_, pairs_);
}

void ContactMatrix::set_mass(const ImpulseProblem& problem) {
  matrix_.set_zero();
  for (Index i = 0; i < bodies_; ++i) {
    Block& block = matrix_.diagonal(i);
    block[0] = block[4] = 1.0 / problem.inverse_mass[i];
    block[8] = 1.0 / problem.inverse_inertia[i];
  }
}

void ContactMatrix::add(const ImpulsePoint& p, const PointGain& gain) {
  const Rows corner = rows_of(p, p.arm_corner, 1.0), edge = rows_of(p, p.arm_edge, -1.0);
  if (p.corner < bodies_) add_product(matrix_.diagonal(p.corner), corner, gain, corner);
  if (p.edge < bodies_) add_product(matrix_.diagonal(p.edge), edge, gain, edge);
  if (p.corner >= bodies_ || p.edge >= bodies_) return;
  const BlockLu::OffDiagonal blocks = matrix_.off_diagonal(p.corner, p.edge);
  add_product(blocks.at_row, corner, gain, edge);
  add_product(blocks.at_column, edge, gain, corner);
}

}  // namespace dougong::engine
