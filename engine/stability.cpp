#include "engine/stability.h"

#include <array>
#include <cmath>

#include "engine/fields/fields.h"

namespace dougong::engine {
namespace {

using Row = std::array<double, 3>;
using Block = std::array<Row, 3>;

void add_outer(Block& block, double factor, const Row& left, const Row& right) {
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) block[r][c] += factor * left[r] * right[c];
}

double row_sum(const Row& row) {
  return std::abs(row[0]) + std::abs(row[1]) + std::abs(row[2]);
}

// A direction's row of the Jacobian on one body, times M^(-1/2).
Row scaled_row(const Model& model, Index body, double sign, Vec2 direction, Vec2 arm) {
  const double m = 1.0 / std::sqrt(model.mass[body]), i = 1.0 / std::sqrt(model.inertia[body]);
  return {sign * m * direction.x, sign * m * direction.y, sign * i * cross(arm, direction)};
}

// Assembles one matrix (K or C): diagonal blocks of bodies, off-diagonal blocks of pairs as row sums.
class RowSums {
 public:
  explicit RowSums(std::size_t bodies) : diagonal_(bodies), elsewhere_(bodies) {}

  void begin_pair(Index a, Index b) { a_ = a, b_ = b, block_ = {}; }
  void add(double factor, const Row& on_a, const Row& on_b) {
    if (a_ < diagonal_.size()) add_outer(diagonal_[a_], factor, on_a, on_a);
    if (b_ < diagonal_.size()) add_outer(diagonal_[b_], factor, on_b, on_b);
    add_outer(block_, factor, on_a, on_b);
  }
  void end_pair() {
    if (a_ >= diagonal_.size() || b_ >= diagonal_.size()) return;
    for (std::size_t r = 0; r < 3; ++r) {
      elsewhere_[a_][r] += row_sum(block_[r]);
      elsewhere_[b_][r] += row_sum({block_[0][r], block_[1][r], block_[2][r]});
    }
  }
  double largest() const {
    double result = 0.0;
    for (std::size_t i = 0; i < diagonal_.size(); ++i)
      for (std::size_t r = 0; r < 3; ++r)
        result = std::max(result, row_sum(diagonal_[i][r]) + elsewhere_[i][r]);
    return result;
  }

 private:
  std::vector<Block> diagonal_;
  std::vector<Row> elsewhere_;
  Index a_ = 0, b_ = 0;
  Block block_{};
};

// A spring and dashpot between two bodies along one direction, at arms from their centroids.
struct Strut {
  Index a, b;
  Vec2 direction, arm_a, arm_b;
  double stiffness, damping;
};

struct Sums {
  RowSums stiffness, damping;
  void begin_pair(Index a, Index b) { stiffness.begin_pair(a, b), damping.begin_pair(a, b); }
  void end_pair() { stiffness.end_pair(), damping.end_pair(); }
  void add(const Model& model, const Strut& s) {
    const Row on_a = scaled_row(model, s.a, 1.0, s.direction, s.arm_a);
    const Row on_b = scaled_row(model, s.b, -1.0, s.direction, s.arm_b);
    stiffness.add(s.stiffness, on_a, on_b);
    damping.add(s.damping, on_a, on_b);
  }
};

// The pair's first body takes the row of the strut's side that is on it.
void add_point(const Model& model, const ContactPoints& points, std::size_t i, std::span<const Frame> frames,
               Index first, Sums& sums) {
  const PointGeometry g = geometry_of(points, i, frames);
  const PointStiffness law = points.stiffness(i);
  const double damping = damping_share(points, i);
  const bool corner_first = points.corner_body[i] == first;
  Strut s{first,
          corner_first ? points.edge_body[i] : points.corner_body[i],
          g.normal,
          corner_first ? g.arm_corner : g.arm_edge,
          corner_first ? g.arm_edge : g.arm_corner,
          law.normal,
          damping * law.normal_damping};
  sums.add(model, s);
  s.direction = turned(g.normal), s.stiffness = law.tangential, s.damping = damping * law.tangential_damping;
  sums.add(model, s);
  // A force that acts inside of its corner has less lever than counted here.
  if (points.rocking.empty() || points.rocking[i].couple == 0.0) return;
  const Row turn_a{0.0, 0.0, 1.0 / std::sqrt(model.inertia[s.a])};
  const Row turn_b{0.0, 0.0, -1.0 / std::sqrt(model.inertia[s.b])};
  sums.damping.add(points.rocking[i].couple * points.rocking[i].length, turn_a, turn_b);
}

void add_bond_point(const Model& model, const BondPoint& p, const BondGeometry& g, Sums& sums) {
  sums.add(model, {p.a, p.b, g.normal, g.arm_a, g.arm_b, p.law.normal, p.law.normal_damping});
  sums.add(model, {p.a, p.b, turned(g.normal), g.arm_a, g.arm_b, p.law.tangential, p.law.tangential_damping});
}

void add_bond_points(const Model& model, const BondState& state, std::span<const Frame> frames, Sums& sums) {
  for (std::size_t i = 0; i < model.bond_points.size(); ++i) {
    const BondPoint& p = model.bond_points[i];
    const BondGeometry g = bond_geometry(p, frames);
    if (i % 2 == 0) sums.begin_pair(p.a, p.b);
    if (!state.history[i].gone()) add_bond_point(model, p, g, sums);
    if (i % 2 == 1) sums.end_pair();
  }
}

void add_joint(const Model& model, const JointElement& j, std::span<const Frame> frames, Sums& sums) {
  const JointGeometry g = joint_geometry(j, frames);
  const double length = norm(g.separation);
  const Vec2 along = j.axial() && length > 0.0 ? (1.0 / length) * g.separation : Vec2{1.0, 0.0};
  sums.begin_pair(j.a, j.b);
  sums.add(model, {j.a, j.b, along, g.middle_a, g.middle_b, j.stiffness, j.damping});
  // A pin acts across too; across a stretched spring its tension F/l does.
  const double across = j.axial() ? (length > 0.0 ? norm(g.spring) / length : 0.0) : j.stiffness;
  sums.add(model, {j.a, j.b, turned(along), g.middle_a, g.middle_b, across, j.axial() ? 0.0 : j.damping});
  const Row turn_a{0.0, 0.0, 1.0 / std::sqrt(model.inertia[j.a])};
  const Row turn_b{0.0, 0.0, -1.0 / std::sqrt(model.inertia[j.b])};
  sums.stiffness.add(j.rotational_stiffness, turn_a, turn_b);
  sums.damping.add(j.rotational_damping, turn_a, turn_b);
  sums.end_pair();
}

}  // namespace

SpectralBound spectral_bound(const Model& model, const State& state, std::span<const Frame> frames) {
  Sums sums{RowSums(model.body_count), RowSums(model.body_count)};
  for (const ContactPair& pair : state.contacts.pairs()) {
    if (!pair.active) continue;
    sums.begin_pair(pair.bodies.a, pair.bodies.b);
    for (Index k = 0; k < pair.manifold.count; ++k)
      add_point(model, state.contacts.points, pair.first_point + k, frames, pair.bodies.a, sums);
    sums.end_pair();
  }
  add_bond_points(model, state.bonds, frames, sums);
  for (const JointElement& joint : model.joints) add_joint(model, joint, frames, sums);
  SpectralBound bound{sums.stiffness.largest(), sums.damping.largest()};
  if (model.fields.empty()) return bound;
  // The largest eigenvalue of a sum is at most the sum of the largest.
  const FieldRates fields = field_rates(model.fields, model.mass, frames);
  return {bound.stiffness + fields.stiffness, bound.damping + fields.damping};
}

}  // namespace dougong::engine
