#include "engine/nonsmooth/block_lu.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>

namespace dougong::engine {
namespace {

// a -= b c
inline void subtract_product(Block& a, const Block& b, const Block& c) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      a[3 * i + j] -= b[3 * i] * c[j] + b[3 * i + 1] * c[3 + j] + b[3 * i + 2] * c[6 + j];
}

inline Block product(const Block& b, const Block& c) {
  Block a;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      a[3 * i + j] = b[3 * i] * c[j] + b[3 * i + 1] * c[3 + j] + b[3 * i + 2] * c[6 + j];
  return a;
}

inline PlaneVelocity product(const Block& b, const PlaneVelocity& y) {
  return {b[0] * y.x + b[1] * y.y + b[2] * y.spin, b[3] * y.x + b[4] * y.y + b[5] * y.spin,
          b[6] * y.x + b[7] * y.y + b[8] * y.spin};
}

inline void subtract_product(PlaneVelocity& x, const Block& b, const PlaneVelocity& y) {
  const PlaneVelocity z = product(b, y);
  x.x -= z.x, x.y -= z.y, x.spin -= z.spin;
}

// By the adjugate. Returns false for a determinant that is zero or not finite.
bool invert(Block& a) {
  const Block c{a[4] * a[8] - a[5] * a[7], a[2] * a[7] - a[1] * a[8], a[1] * a[5] - a[2] * a[4],
                a[5] * a[6] - a[3] * a[8], a[0] * a[8] - a[2] * a[6], a[2] * a[3] - a[0] * a[5],
                a[3] * a[7] - a[4] * a[6], a[1] * a[6] - a[0] * a[7], a[0] * a[4] - a[1] * a[3]};
  const double determinant = a[0] * c[0] + a[1] * c[3] + a[2] * c[6];
  if (!(std::abs(determinant) > 0.0) || !std::isfinite(determinant)) return false;
  for (std::size_t k = 0; k < 9; ++k) a[k] = c[k] / determinant;
  return true;
}

}  // namespace

void BlockLu::analyse(std::size_t rows, std::span<const BodyPair> pairs) {
  find_order(rows, pairs);
  find_fill(pairs);
  find_targets();
  diagonal_.resize(rows), permuted_.resize(rows);
  lower_.resize(rows_.size()), upper_.resize(rows_.size());
}

void BlockLu::find_order(std::size_t rows, std::span<const BodyPair> pairs) {
  std::vector<Eigen::Triplet<double, int>> entries;
  for (const BodyPair& p : pairs) {
    entries.emplace_back(static_cast<int>(p.a), static_cast<int>(p.b), 1.0);
    entries.emplace_back(static_cast<int>(p.b), static_cast<int>(p.a), 1.0);
  }
  for (int i = 0; i < static_cast<int>(rows); ++i) entries.emplace_back(i, i, 1.0);
  Eigen::SparseMatrix<double> pattern(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(rows));
  pattern.setFromTriplets(entries.begin(), entries.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  if (rows > 0) Eigen::AMDOrdering<int>()(pattern, order);
  place_.resize(rows), row_at_.resize(rows);
  for (std::size_t k = 0; k < rows; ++k) {
    row_at_[k] = static_cast<Index>(order.indices()[static_cast<Eigen::Index>(k)]);
    place_[row_at_[k]] = static_cast<Index>(k);
  }
}

// A column's rows: its own, and those of every column whose first row it is (the elimination tree).
void BlockLu::find_fill(std::span<const BodyPair> pairs) {
  const std::size_t n = place_.size();
  std::vector<std::vector<Index>> column(n);
  for (const BodyPair& p : pairs) {
    const auto [low, high] = std::minmax(place_[p.a], place_[p.b]);
    column[low].push_back(high);
  }
  first_.assign(1, 0);
  rows_.clear();
  for (std::size_t k = 0; k < n; ++k) {
    std::vector<Index>& c = column[k];
    std::sort(c.begin(), c.end());
    c.erase(std::unique(c.begin(), c.end()), c.end());
    rows_.insert(rows_.end(), c.begin(), c.end());
    first_.push_back(rows_.size());
    if (c.size() > 1) column[c[0]].insert(column[c[0]].end(), c.begin() + 1, c.end());
  }
}

// Where each product of a column's lower and upper blocks goes, in the order factorise() meets them.
void BlockLu::find_targets() {
  targets_.clear();
  for (std::size_t k = 0; k < place_.size(); ++k)
    for (std::size_t i = first_[k]; i < first_[k + 1]; ++i)
      for (std::size_t j = first_[k]; j < i; ++j)
        targets_.push_back(static_cast<std::uint32_t>(slot(rows_[j], rows_[i])));
}

std::size_t BlockLu::slot(Index column, Index row) const {
  const auto begin = rows_.begin() + static_cast<std::ptrdiff_t>(first_[column]);
  const auto end = rows_.begin() + static_cast<std::ptrdiff_t>(first_[column + 1]);
  return static_cast<std::size_t>(std::lower_bound(begin, end, row) - rows_.begin());
}

void BlockLu::set_zero() {
  std::fill(diagonal_.begin(), diagonal_.end(), Block{});
  std::fill(lower_.begin(), lower_.end(), Block{});
  std::fill(upper_.begin(), upper_.end(), Block{});
}

BlockLu::OffDiagonal BlockLu::off_diagonal(Index row, Index column) {
  const Index r = place_[row], c = place_[column];
  const std::size_t s = slot(std::min(r, c), std::max(r, c));
  if (r > c) return {lower_[s], upper_[s]};
  return {upper_[s], lower_[s]};
}

bool BlockLu::factorise() {
  const std::uint32_t* target = targets_.data();
  for (std::size_t k = 0; k < diagonal_.size(); ++k) {
    if (!invert(diagonal_[k])) return false;
    for (std::size_t i = first_[k]; i < first_[k + 1]; ++i) lower_[i] = product(lower_[i], diagonal_[k]);
    for (std::size_t i = first_[k]; i < first_[k + 1]; ++i) {
      subtract_product(diagonal_[rows_[i]], lower_[i], upper_[i]);
      for (std::size_t j = first_[k]; j < i; ++j, ++target) {
        subtract_product(lower_[*target], lower_[i], upper_[j]);
        subtract_product(upper_[*target], lower_[j], upper_[i]);
      }
    }
  }
  return true;
}

void BlockLu::solve(std::span<PlaneVelocity> x) {
  const std::size_t n = diagonal_.size();
  for (std::size_t k = 0; k < n; ++k) permuted_[k] = x[row_at_[k]];
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = first_[k]; i < first_[k + 1]; ++i)
      subtract_product(permuted_[rows_[i]], lower_[i], permuted_[k]);
  for (std::size_t k = n; k-- > 0;) {
    PlaneVelocity& y = permuted_[k];
    for (std::size_t i = first_[k]; i < first_[k + 1]; ++i)
      subtract_product(y, upper_[i], permuted_[rows_[i]]);
    y = product(diagonal_[k], y);
    x[row_at_[k]] = y;
  }
}

}  // namespace dougong::engine
