// Barnes and Hut's quadtree: far bodies act as the moments of the cell they lie in.
//
// About the centre c of a cell (weighted by |w|, so that it exists when the charges cancel), with
// d = p_j - c, phi(R) = 1/sqrt(R^2 + softening^2) and R from c to the target, Taylor's series to second
// order is
//     sum w_j phi(R - d_j) = W phi - D_a phi,a + 1/2 Q_ab phi,ab
//     W = sum w_j,  D = sum w_j d_j,  Q_ab = sum w_j d_ja d_jb
// Its error is of the order (width/R)^3 of |W|'s field. D vanishes for masses; for charges it is what is
// left when W cancels. A cell of width w counts as one for a target outside it when w < angle x distance.
// Forces by the tree are not exactly opposite: momentum is kept to the error of the tree, no better.
// Barnes and Hut, Nature 324 (1986) 446-449; moments as in Hernquist, Astrophys. J. Suppl. 64 (1987) 715.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/fields/field_terms.h"
#include "engine/frame.h"

namespace dougong::engine {

struct TreeCell {
  Vec2 middle, centre;  // m, of the square; of the weights
  double half = 0.0;    // m, half the width
  double weight = 0.0, absolute = 0.0;
  Vec2 dipole;
  double xx = 0.0, xy = 0.0, yy = 0.0;   // Q
  std::uint32_t begin = 0, end = 0;      // of the field's bodies, in the tree's order
  std::array<std::uint32_t, 4> child{};  // 0: none
  bool is_leaf = true;
};

class Tree {
 public:
  void build(const PairField& field, std::span<const Frame> frames);

  /// Calls cell(TreeCell) for what counts as one and leaf(k) for every body of the field that does not, in
  /// a fixed order.
  template <class Cell, class Leaf>
  void visit(Vec2 target, double opening_angle, const Cell& cell, const Leaf& leaf) const;

 private:
  static constexpr std::size_t deepest = 40;  // cells of 1e-12 of the scene are not divided

  std::uint32_t add_cell(const PairField& field, std::span<const Frame> frames, std::uint32_t begin,
                         std::uint32_t end, Vec2 middle, double half, std::size_t depth);
  std::array<std::uint32_t, 5> divide(std::span<const Frame> frames, const PairField& field,
                                      std::uint32_t begin, std::uint32_t end, Vec2 middle);
  void sum_moments(const PairField& field, std::span<const Frame> frames, TreeCell& cell) const;

  std::vector<TreeCell> cells_;
  std::vector<std::uint32_t> order_, moved_;
};

inline bool counts_as_one(const TreeCell& cell, Vec2 target, double opening_angle) {
  const Vec2 r = target - cell.centre, m = target - cell.middle;
  const double width = 2.0 * cell.half;
  const bool outside = std::abs(m.x) > cell.half || std::abs(m.y) > cell.half;
  return outside && width * width < opening_angle * opening_angle * dot(r, r);
}

template <class Cell, class Leaf>
void Tree::visit(Vec2 target, double opening_angle, const Cell& cell, const Leaf& leaf) const {
  std::array<std::uint32_t, 4 * deepest + 4> waiting;
  std::size_t count = 0;
  if (!cells_.empty()) waiting[count++] = 0;
  while (count > 0) {
    const TreeCell& c = cells_[waiting[--count]];
    if (counts_as_one(c, target, opening_angle)) {
      cell(c);
    } else if (c.is_leaf) {
      for (std::uint32_t k = c.begin; k < c.end; ++k) leaf(order_[k]);
    } else {
      for (const std::uint32_t child : c.child)
        if (child != 0) waiting[count++] = child;
    }
  }
}

/// Sum of w_j phi over a cell and minus its gradient, at R = target - centre.
struct CellField {
  double potential = 0.0;
  Vec2 field;
};
CellField field_of(const TreeCell& cell, Vec2 target, double softening_squared);

}  // namespace dougong::engine
