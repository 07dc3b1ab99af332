// What a tree costs in accuracy, measured: its forces on the bodies against those of the direct sum, at the
// places where the bodies are.
//
//     error = sqrt( sum |F_tree - F_direct|^2 / sum |F_direct|^2 )
//
// over all bodies of the field, or evenly picked ones where there are many: the direct sum over those picked
// takes time with their number times that of all.
#pragma once

#include <string>
#include <vector>

#include "engine/fields/pair_field.h"

namespace dougong::engine {

struct TreeError {
  std::string field;           // "gravitation", "electrostatic"
  double opening_angle = 0.0;  // -
  double relative = 0.0;       // -
  std::size_t compared = 0, bodies = 0;
};

/// Most bodies that are all compared, and how many are else.
inline constexpr std::size_t most_compared = 2000;

/// One for each field that is summed by a tree.
std::vector<TreeError> tree_errors(const FieldTerms& fields, std::span<const Frame> frames);

}  // namespace dougong::engine
