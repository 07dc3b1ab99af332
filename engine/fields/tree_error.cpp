#include "engine/fields/tree_error.h"

#include <algorithm>
#include <cmath>

namespace dougong::engine {
namespace {

// On the body at `place` of the field, by every other one.
Vec2 direct_force(const PairField& field, std::span<const Frame> frames, std::size_t place) {
  const Vec2 here = frames[field.bodies[place]].position();
  Vec2 sum;
  for (std::size_t b = 0; b < field.bodies.size(); ++b) {
    if (b == place) continue;
    const Vec2 d = here - frames[field.bodies[b]].position();
    const double s2 = dot(d, d) + field.softening_squared;
    sum += (field.weight[b] / (s2 * std::sqrt(s2))) * d;
  }
  return (field.strength * field.weight[place]) * sum;
}

TreeError tree_error(const PairField& field, std::span<const Frame> frames) {
  std::vector<Vec2> forces(frames.size());
  Tree scratch;
  add_pair_forces(field, frames, scratch, forces);
  const std::size_t bodies = field.bodies.size(), compared = std::min(bodies, most_compared);
  double error = 0.0, size = 0.0;
  for (std::size_t k = 0; k < compared; ++k) {
    const std::size_t place = k * bodies / compared;
    const Vec2 exact = direct_force(field, frames, place), off = forces[field.bodies[place]] - exact;
    error += dot(off, off), size += dot(exact, exact);
  }
  return {field.name, field.opening_angle, size > 0.0 ? std::sqrt(error / size) : 0.0, compared, bodies};
}

}  // namespace

std::vector<TreeError> tree_errors(const FieldTerms& fields, std::span<const Frame> frames) {
  std::vector<TreeError> errors;
  for (const PairField& field : fields.pairs)
    if (uses_tree(field)) errors.push_back(tree_error(field, frames));
  return errors;
}

}  // namespace dougong::engine
