// Sparse LU of a matrix of 3 x 3 blocks, one row of blocks for every body, a block wherever two bodies touch.
//
// The pattern is symmetric, the values need not be. Rows are eliminated in an order that keeps the fill small
// (approximate minimum degree: Amestoy, Davis and Duff, SIAM J. Matrix Anal. Appl. 17 (1996) 886-905),
// without pivoting among blocks: the diagonal holds the bodies' masses. analyse() allocates; factorise() and
// solve() do not.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "engine/collision/broad_phase.h"
#include "engine/nonsmooth/plane_velocity.h"

namespace dougong::engine {

using Block = std::array<double, 9>;  // by rows

class BlockLu {
 public:
  /// Finds the pattern of `rows` rows with a block for every pair, which may be given more than once.
  void analyse(std::size_t rows, std::span<const BodyPair> pairs);
  void set_zero();
  Block& diagonal(Index row) { return diagonal_[place_[row]]; }
  /// Blocks (row, column) and (column, row) of a pair that was given to analyse().
  struct OffDiagonal {
    Block &at_row, &at_column;
  };
  OffDiagonal off_diagonal(Index row, Index column);

  /// Returns false where a block on the diagonal became singular.
  bool factorise();
  /// Three values for every row, in place.
  void solve(std::span<PlaneVelocity> x);
  std::size_t blocks() const { return diagonal_.size() + 2 * lower_.size(); }

 private:
  void find_order(std::size_t rows, std::span<const BodyPair> pairs);
  void find_fill(std::span<const BodyPair> pairs);
  void find_targets();
  std::size_t slot(Index column, Index row) const;

  std::vector<Index> place_, row_at_;  // of a row in the order of elimination, and back
  std::vector<std::size_t> first_;     // of each column, into rows_, lower_ and upper_
  std::vector<Index> rows_;            // below the diagonal, ascending
  std::vector<std::uint32_t> targets_;
  std::vector<Block> diagonal_, lower_, upper_;
  std::vector<PlaneVelocity> permuted_;
};

}  // namespace dougong::engine
