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

void add_point(const Model& model, const ContactPoints& points, std::size_t i, std::span<const Frame> frames,
               Index a, RowSums& stiffness, RowSums& damping) {
  const PointGeometry g = geometry_of(points, i, frames);
  const PointStiffness& law = points.stiffness[i];
  const Index corner = points.corner_body[i], edge = points.edge_body[i];
  const struct {
    Vec2 direction;
    double k, c;
  } directions[] = {{g.normal, law.normal, law.normal_damping},
                    {turned(g.normal), law.tangential, law.tangential_damping}};
  for (const auto& d : directions) {
    const Row on_corner = scaled_row(model, corner, 1.0, d.direction, g.arm_corner);
    const Row on_edge = scaled_row(model, edge, -1.0, d.direction, g.arm_edge);
    const bool corner_is_a = corner == a;
    stiffness.add(d.k, corner_is_a ? on_corner : on_edge, corner_is_a ? on_edge : on_corner);
    damping.add(d.c, corner_is_a ? on_corner : on_edge, corner_is_a ? on_edge : on_corner);
  }
}

}  // namespace

SpectralBound spectral_bound(const Model& model, const State& state, std::span<const Frame> frames) {
  RowSums stiffness(model.body_count), damping(model.body_count);
  for (const ContactPair& pair : state.contacts.pairs()) {
    if (!pair.active) continue;
    stiffness.begin_pair(pair.bodies.a, pair.bodies.b);
    damping.begin_pair(pair.bodies.a, pair.bodies.b);
    for (Index k = 0; k < pair.manifold.count; ++k)
      add_point(model, state.contacts.points, pair.first_point + k, frames, pair.bodies.a, stiffness,
                damping);
    stiffness.end_pair();
    damping.end_pair();
  }
  SpectralBound bound{stiffness.largest(), damping.largest()};
  if (model.fields.empty()) return bound;
  // The largest eigenvalue of a sum is at most the sum of the largest.
  const FieldRates fields = field_rates(model.fields, model.mass, frames);
  return {bound.stiffness + fields.stiffness, bound.damping + fields.damping};
}

}  // namespace dougong::engine
