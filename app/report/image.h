// A picture in memory: 8-bit RGB, rows from the top. PNG by libpng.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "app/report/colour.h"

namespace dougong::app {

struct Image {
  Image() = default;
  Image(int width, int height, Colour fill = ink::white);

  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  // 3 x width x height

  std::uint8_t* at(int x, int y) {
    return &rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                     static_cast<std::size_t>(x))];
  }
  const std::uint8_t* at(int x, int y) const { return const_cast<Image*>(this)->at(x, y); }
  /// Paints a share of the colour over a pixel; outside the picture nothing happens.
  void blend(int x, int y, Colour colour, double share);
  void fill_rectangle(int x, int y, int w, int h, Colour colour);
  /// Copies another picture with its upper left corner at (x, y), clipped.
  void paste(const Image& other, int x, int y);
};

std::string png_of(const Image& image);
Image image_of(std::string_view png);

}  // namespace dougong::app
