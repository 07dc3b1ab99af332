#include "app/report/comparison_legend.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/report/comparison_figures.h"
#include "app/report/gnuplot.h"
#include "app/report/text.h"

namespace dougong::app {
namespace {

constexpr int line_height = 18, margin = 12;  // px
constexpr double character_width = 6.6;       // px

}  // namespace

std::string letter(std::size_t variant) {
  constexpr std::size_t letters = 26;
  const std::string last(1, static_cast<char>('A' + variant % letters));
  return variant < letters ? last : letter(variant / letters - 1) + last;
}

std::size_t drawn_variants(const Comparison& comparison) {
  return std::min(comparison.variants.size(), most_drawn_variants);
}

// The reference is black, the others take the colours of categories.
Colour variant_colour(std::size_t variant) {
  return variant == 0 ? ink::text : category(variant - 1);
}

int legend_height(const Comparison& comparison) {
  return line_height * static_cast<int>(drawn_variants(comparison)) + margin;
}

std::string legend_labels(const Comparison& comparison, int width, int height) {
  const auto fits = static_cast<std::size_t>((width - 40) / character_width);
  std::string out;
  double from_bottom = legend_height(comparison) - 8;
  for (std::size_t v = 0; v < drawn_variants(comparison); ++v) {
    const std::string words =
        fmt::format("{}  {}{}", letter(v), comparison.variants[v].name, v == 0 ? " (reference)" : "");
    out += fmt::format("set label {} at screen {:.5f}, screen {:.5f} left front tc rgb '{}'\n",
                       gnuplot_text(shortened(words, fits)), 14.0 / width, from_bottom / height,
                       to_hex(readable(variant_colour(v))));
    from_bottom -= line_height;
  }
  return out;
}

}  // namespace dougong::app
