// The names of the variants below a figure, a line each, in their colours.
#pragma once

#include <string>

#include "app/report/colour.h"
#include "app/study/compare/comparison.h"

namespace dougong::app {

inline constexpr std::size_t most_drawn_variants = 7;  // as many as there are colours

std::size_t drawn_variants(const Comparison& comparison);
Colour variant_colour(std::size_t variant);
/// px that they need, and the labels on a sheet of this size.
int legend_height(const Comparison& comparison);
std::string legend_labels(const Comparison& comparison, int width, int height);

}  // namespace dougong::app
