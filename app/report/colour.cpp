#include "app/report/colour.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace dougong::app {
namespace {

constexpr std::array<const char*, 9> viridis_samples = {"#440154", "#472d7b", "#3b528b", "#2c728e", "#21918c",
                                                        "#28ae80", "#5ec962", "#addc30", "#fde725"};

// Blue, vermillion, bluish green, reddish purple, orange, sky blue, black.
constexpr std::array<const char*, 7> okabe_ito = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                  "#e69f00", "#56b4e9", "#000000"};

double linear(double channel) {
  return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}
double luminance(Colour c) {
  return 0.2126 * linear(c.red) + 0.7152 * linear(c.green) + 0.0722 * linear(c.blue);
}
double contrast_on_white(Colour c) {
  return 1.05 / (luminance(c) + 0.05);
}

}  // namespace

Colour from_hex(const char* hex) {
  const long code = std::strtol(hex + 1, nullptr, 16);
  const auto channel = [code](int shift) { return static_cast<double>((code >> shift) & 0xff) / 255.0; };
  return {channel(16), channel(8), channel(0)};
}

std::string to_hex(Colour c) {
  const auto byte = [](double v) { return static_cast<int>(std::lround(255.0 * std::clamp(v, 0.0, 1.0))); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(c.red), byte(c.green), byte(c.blue));
}

Colour mixed(Colour a, Colour b, double share) {
  const auto mix = [share](double u, double v) { return u + share * (v - u); };
  return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
}

Colour viridis(double t) {
  const double place = std::clamp(t, 0.0, 1.0) * static_cast<double>(viridis_samples.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(place), viridis_samples.size() - 2);
  return mixed(from_hex(viridis_samples[below]), from_hex(viridis_samples[below + 1]),
               place - static_cast<double>(below));
}

Colour category(std::size_t index) {
  return from_hex(okabe_ito[index % okabe_ito.size()]);
}

Colour readable(Colour c) {
  constexpr double least_contrast = 4.5;
  while (contrast_on_white(c) < least_contrast) c = mixed(c, ink::black, 0.05);
  return c;
}

Colour category_ink(std::size_t index) {
  return readable(category(index));
}

}  // namespace dougong::app
