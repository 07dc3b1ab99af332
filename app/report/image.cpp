#include "app/report/image.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace dougong::app {
namespace {

std::uint8_t byte_of(double channel) {
  return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(channel, 0.0, 1.0)));
}

png_image header(const Image& image) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGB;
  return png;
}

}  // namespace

Image::Image(int w, int h, Colour fill) : width(w), height(h) {
  rgb.resize(3 * static_cast<std::size_t>(w) * static_cast<std::size_t>(h));
  fill_rectangle(0, 0, w, h, fill);
}

void Image::blend(int x, int y, Colour colour, double share) {
  if (x < 0 || y < 0 || x >= width || y >= height) return;
  std::uint8_t* pixel = at(x, y);
  const double channels[] = {colour.red, colour.green, colour.blue};
  for (int i = 0; i < 3; ++i) pixel[i] = byte_of(pixel[i] / 255.0 + share * (channels[i] - pixel[i] / 255.0));
}

void Image::fill_rectangle(int x, int y, int w, int h, Colour colour) {
  const std::uint8_t channels[] = {byte_of(colour.red), byte_of(colour.green), byte_of(colour.blue)};
  for (int row = std::max(0, y); row < std::min(height, y + h); ++row) {
    for (int column = std::max(0, x); column < std::min(width, x + w); ++column) {
      std::copy(std::begin(channels), std::end(channels), at(column, row));
    }
  }
}

void Image::paste(const Image& other, int x, int y) {
  const int first = std::max(0, -x), last = std::min(other.width, width - x);
  if (first >= last) return;
  for (int row = std::max(0, -y); row < std::min(other.height, height - y); ++row) {
    std::copy_n(other.at(first, row), 3 * (last - first), at(x + first, y + row));
  }
}

std::string png_of(const Image& image) {
  png_image png = header(image);
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);  // asking for the size would pack everything twice
  std::string bytes(size, '\0');
  if (!png_image_write_to_memory(&png, bytes.data(), &size, 0, image.rgb.data(), 0, nullptr)) {
    throw std::runtime_error(std::string("cannot make a PNG: ") + png.message);
  }
  bytes.resize(size);
  return bytes;
}

Image image_of(std::string_view bytes) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_memory(&png, bytes.data(), bytes.size())) {
    throw std::runtime_error(std::string("cannot read a PNG: ") + png.message);
  }
  png.format = PNG_FORMAT_RGB;
  Image image(static_cast<int>(png.width), static_cast<int>(png.height));
  if (!png_image_finish_read(&png, nullptr, image.rgb.data(), 0, nullptr)) {
    throw std::runtime_error(std::string("cannot read a PNG: ") + png.message);
  }
  return image;
}

}  // namespace dougong::app
