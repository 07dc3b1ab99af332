// The known name that a mistyped one was probably meant to be.
//
// Distance: insertions, deletions, replacements and swaps of neighbours that turn one into the other
// (optimal string alignment). A name is offered when at most a third of the typed letters, and at
// least two, may differ.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace dougong::structures {

std::size_t edit_distance(std::string_view a, std::string_view b);
/// The nearest of the names, the first of equals; empty when none is near.
std::string nearest_name(std::string_view typed, std::span<const std::string> names);

}  // namespace dougong::structures
