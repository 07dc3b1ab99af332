#include "engine/fields/tree.h"

#include <algorithm>

namespace dougong::engine {
namespace {

constexpr std::uint32_t largest_leaf = 8;

struct Square {
  Vec2 middle;
  double half = 0.0;
};

Square square_around(const PairField& field, std::span<const Frame> frames) {
  Vec2 low = frames[field.bodies[0]].position(), high = low;
  for (const std::uint32_t i : field.bodies) {
    low = {std::min(low.x, frames[i].x), std::min(low.y, frames[i].y)};
    high = {std::max(high.x, frames[i].x), std::max(high.y, frames[i].y)};
  }
  return {0.5 * (low + high), 0.5 * std::max(high.x - low.x, high.y - low.y)};
}

std::size_t quarter_of(Vec2 p, Vec2 middle) {
  return (p.x >= middle.x ? 1u : 0u) + (p.y >= middle.y ? 2u : 0u);
}

}  // namespace

void Tree::build(const PairField& field, std::span<const Frame> frames) {
  cells_.clear();
  const auto n = static_cast<std::uint32_t>(field.bodies.size());
  order_.resize(n), moved_.resize(n);
  for (std::uint32_t k = 0; k < n; ++k) order_[k] = k;
  if (n == 0) return;
  const Square all = square_around(field, frames);
  add_cell(field, frames, 0, n, all.middle, all.half, 0);
}

std::uint32_t Tree::add_cell(const PairField& field, std::span<const Frame> frames, std::uint32_t begin,
                             std::uint32_t end, Vec2 middle, double half, std::size_t depth) {
  const auto index = static_cast<std::uint32_t>(cells_.size());
  TreeCell cell;
  cell.middle = middle, cell.half = half, cell.begin = begin, cell.end = end;
  sum_moments(field, frames, cell);
  cell.is_leaf = end - begin <= largest_leaf || depth == deepest - 1;
  cells_.push_back(cell);
  if (cell.is_leaf) return index;
  const auto bounds = divide(frames, field, begin, end, middle);
  for (std::size_t quarter = 0; quarter < 4; ++quarter) {
    if (bounds[quarter] == bounds[quarter + 1]) continue;
    const Vec2 offset{quarter & 1 ? 0.5 * half : -0.5 * half, quarter & 2 ? 0.5 * half : -0.5 * half};
    const std::uint32_t child =
        add_cell(field, frames, bounds[quarter], bounds[quarter + 1], middle + offset, 0.5 * half, depth + 1);
    cells_[index].child[quarter] = child;
  }
  return index;
}

// Sorts order_[begin, end) by quarter, keeping the order within each.
std::array<std::uint32_t, 5> Tree::divide(std::span<const Frame> frames, const PairField& field,
                                          std::uint32_t begin, std::uint32_t end, Vec2 middle) {
  std::array<std::uint32_t, 5> bounds{begin, begin, begin, begin, begin};
  const auto quarter = [&](std::uint32_t k) {
    return quarter_of(frames[field.bodies[order_[k]]].position(), middle);
  };
  for (std::uint32_t k = begin; k < end; ++k) ++bounds[quarter(k) + 1];
  for (std::size_t q = 1; q < 5; ++q) bounds[q] += bounds[q - 1] - begin;
  std::array<std::uint32_t, 4> next{bounds[0], bounds[1], bounds[2], bounds[3]};
  for (std::uint32_t k = begin; k < end; ++k) moved_[next[quarter(k)]++] = order_[k];
  std::copy(moved_.begin() + begin, moved_.begin() + end, order_.begin() + begin);
  return bounds;
}

void Tree::sum_moments(const PairField& field, std::span<const Frame> frames, TreeCell& cell) const {
  Vec2 moment;
  for (std::uint32_t k = cell.begin; k < cell.end; ++k) {
    const double w = field.weight[order_[k]];
    cell.weight += w, cell.absolute += std::abs(w);
    moment += std::abs(w) * (frames[field.bodies[order_[k]]].position() - cell.middle);
  }
  cell.centre = cell.middle + (1.0 / cell.absolute) * moment;
  for (std::uint32_t k = cell.begin; k < cell.end; ++k) {
    const double w = field.weight[order_[k]];
    const Vec2 d = frames[field.bodies[order_[k]]].position() - cell.centre;
    cell.dipole += w * d;
    cell.xx += w * d.x * d.x, cell.xy += w * d.x * d.y, cell.yy += w * d.y * d.y;
  }
}

// With s^2 = R^2 + softening^2:  phi,a = -R_a/s^3,  phi,ab = 3 R_a R_b/s^5 - delta_ab/s^3,
//   phi,abc = 3 (delta_ab R_c + delta_ac R_b + delta_bc R_a)/s^5 - 15 R_a R_b R_c/s^7
CellField field_of(const TreeCell& cell, Vec2 target, double softening_squared) {
  const Vec2 r = target - cell.centre;
  const double s2 = dot(r, r) + softening_squared, i2 = 1.0 / s2, i1 = std::sqrt(i2);
  const double i3 = i1 * i2, i5 = i3 * i2, i7 = i5 * i2;
  const double along = dot(cell.dipole, r), trace = cell.xx + cell.yy;
  const Vec2 qr{cell.xx * r.x + cell.xy * r.y, cell.xy * r.x + cell.yy * r.y};
  const double rqr = dot(r, qr);
  CellField result;
  result.potential = cell.weight * i1 + along * i3 + 0.5 * (3.0 * rqr * i5 - trace * i3);
  const double radial = cell.weight * i3 + 3.0 * along * i5 - 1.5 * trace * i5 + 7.5 * rqr * i7;
  result.field = radial * r - i3 * cell.dipole - 3.0 * i5 * qr;
  return result;
}

}  // namespace dougong::engine
