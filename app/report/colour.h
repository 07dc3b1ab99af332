// Colours: Okabe-Ito for categories (readable without colour vision), viridis for magnitudes.
//
// Okabe & Ito, "Color Universal Design", 2008. Viridis: van der Walt & Smith, matplotlib 1.5, CC0;
// sampled at 9 points and interpolated.
#pragma once

#include <cstdint>
#include <string>

namespace dougong::app {

struct Colour {
  double red = 0.0, green = 0.0, blue = 0.0;  // 0 .. 1, sRGB
  friend bool operator==(const Colour&, const Colour&) = default;
};

Colour from_hex(const char* hex);  // "#rrggbb"
std::string to_hex(Colour colour);
/// share = 0: a; share = 1: b.
Colour mixed(Colour a, Colour b, double share);

/// Dark violet at 0, yellow at 1; clamped.
Colour viridis(double t);
/// The colour of a category (storey, energy term) in every figure of a report; repeats after 7.
Colour category(std::size_t index);
/// Darkened just enough to be read as text on white (WCAG AA).
Colour readable(Colour colour);
Colour category_ink(std::size_t index);

namespace ink {
inline constexpr Colour black{0.0, 0.0, 0.0};
inline constexpr Colour text{0.13, 0.13, 0.13};
inline constexpr Colour quiet{0.35, 0.35, 0.35};
inline constexpr Colour outline{0.16, 0.16, 0.18};
inline constexpr Colour pale{0.78, 0.78, 0.78};
inline constexpr Colour terrain{0.66, 0.66, 0.66};
inline constexpr Colour hatch{0.38, 0.38, 0.38};
inline constexpr Colour block{0.90, 0.91, 0.93};
inline constexpr Colour white{1.0, 1.0, 1.0};
inline constexpr Colour lost{0.83, 0.0, 0.0};
inline constexpr Colour bond{0.0, 0.33, 0.62}, cracked{0.93, 0.53, 0.0}, crushed{0.55, 0.2, 0.65};
}  // namespace ink

}  // namespace dougong::app
