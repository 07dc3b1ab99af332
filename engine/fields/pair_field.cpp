#include "engine/fields/pair_field.h"

#include <algorithm>

namespace dougong::engine {
namespace {

struct Pair {
  Vec2 d;              // m, from i to j
  double inverse = 0;  // 1/m, of s
};

inline Pair pair_of(const Frame& i, const Frame& j, double softening_squared) {
  const Vec2 d{j.x - i.x, j.y - i.y};
  return {d, 1.0 / std::sqrt(d.x * d.x + d.y * d.y + softening_squared)};
}

void add_direct_forces(const PairField& field, std::span<const Frame> frames, std::span<Vec2> forces) {
  for (std::size_t a = 0; a < field.bodies.size(); ++a) {
    const Frame& i = frames[field.bodies[a]];
    const double scale = field.strength * field.weight[a];
    Vec2 on_i;
    for (std::size_t b = a + 1; b < field.bodies.size(); ++b) {
      const Pair p = pair_of(i, frames[field.bodies[b]], field.softening_squared);
      const Vec2 f = (scale * field.weight[b] * p.inverse * p.inverse * p.inverse) * p.d;
      on_i -= f;
      forces[field.bodies[b]] += f;
    }
    forces[field.bodies[a]] += on_i;
  }
}

// Sum of w_j phi over all others, and minus its gradient, at the a-th body.
CellField sum_by_tree(const PairField& field, std::span<const Frame> frames, const Tree& tree,
                      std::size_t a) {
  const Frame& target = frames[field.bodies[a]];
  CellField sum;
  tree.visit(
      target.position(), field.opening_angle,
      [&](const TreeCell& cell) {
        const CellField part = field_of(cell, target.position(), field.softening_squared);
        sum.potential += part.potential;
        sum.field += part.field;
      },
      [&](std::uint32_t b) {
        if (b == a) return;
        const Pair p = pair_of(frames[field.bodies[b]], target, field.softening_squared);
        sum.potential += field.weight[b] * p.inverse;
        sum.field += (field.weight[b] * p.inverse * p.inverse * p.inverse) * p.d;
      });
  return sum;
}

double direct_stiffness(const PairField& field, std::span<const double> mass, std::span<const Frame> frames) {
  std::vector<double> row(field.bodies.size());
  for (std::size_t a = 0; a < row.size(); ++a)
    for (std::size_t b = a + 1; b < row.size(); ++b) {
      const Pair p = pair_of(frames[field.bodies[a]], frames[field.bodies[b]], field.softening_squared);
      const double k = 2.0 * std::abs(field.strength * field.weight[a] * field.weight[b]) * p.inverse *
                       p.inverse * p.inverse;
      const double m = mass[field.bodies[a]], n = mass[field.bodies[b]], across = k / std::sqrt(m * n);
      row[a] += k / m + across;
      row[b] += k / n + across;
    }
  return row.empty() ? 0.0 : *std::max_element(row.begin(), row.end());
}

// Row sums of M^-1 K instead, which need nothing of a cell but its weight: up to twice as large.
double tree_stiffness(const PairField& field, std::span<const double> mass, std::span<const Frame> frames,
                      const Tree& tree) {
  double largest = 0.0;
  for (std::size_t a = 0; a < field.bodies.size(); ++a) {
    const Frame& target = frames[field.bodies[a]];
    double sum = 0.0;
    const auto add = [&](Vec2 place, double weight) {
      const Vec2 d = target.position() - place;
      const double s2 = dot(d, d) + field.softening_squared;
      sum += weight / (s2 * std::sqrt(s2));
    };
    tree.visit(
        target.position(), field.opening_angle, [&](const TreeCell& c) { add(c.centre, c.absolute); },
        [&](std::uint32_t b) {
          if (b != a) add(frames[field.bodies[b]].position(), std::abs(field.weight[b]));
        });
    largest =
        std::max(largest, 4.0 * std::abs(field.strength * field.weight[a]) * sum / mass[field.bodies[a]]);
  }
  return largest;
}

}  // namespace

bool uses_tree(const PairField& field) {
  return field.opening_angle > 0.0 && field.bodies.size() >= smallest_tree;
}

void add_pair_forces(const PairField& field, std::span<const Frame> frames, Tree& scratch,
                     std::span<Vec2> forces) {
  if (!uses_tree(field)) return add_direct_forces(field, frames, forces);
  scratch.build(field, frames);
  for (std::size_t a = 0; a < field.bodies.size(); ++a)
    forces[field.bodies[a]] +=
        (field.strength * field.weight[a]) * sum_by_tree(field, frames, scratch, a).field;
}

double pair_energy(const PairField& field, std::span<const Frame> frames, Tree& scratch) {
  double energy = 0.0;
  if (uses_tree(field)) {
    scratch.build(field, frames);
    for (std::size_t a = 0; a < field.bodies.size(); ++a)
      energy += 0.5 * field.weight[a] * sum_by_tree(field, frames, scratch, a).potential;
    return field.strength * energy;
  }
  for (std::size_t a = 0; a < field.bodies.size(); ++a)
    for (std::size_t b = a + 1; b < field.bodies.size(); ++b)
      energy += field.weight[a] * field.weight[b] *
                pair_of(frames[field.bodies[a]], frames[field.bodies[b]], field.softening_squared).inverse;
  return field.strength * energy;
}

double pair_stiffness(const PairField& field, std::span<const double> mass, std::span<const Frame> frames,
                      Tree& scratch) {
  if (!uses_tree(field)) return direct_stiffness(field, mass, frames);
  scratch.build(field, frames);
  return tree_stiffness(field, mass, frames, scratch);
}

}  // namespace dougong::engine
