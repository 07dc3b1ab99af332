// Dry walls from patterns, one string a course from below: 1 a block, h half a block, _ an opening as long as
// a block (comparison C01).
#pragma once

#include <stdexcept>

#include "tests/scenes/blocks.h"

namespace dougong::scenes {

struct WallBlock {
  double length = 0.4, height = 0.175;  // m
};

inline engine::Scene pattern_wall(const std::vector<std::string>& courses, double friction,
                                  double young_modulus, double damping_ratio = 1.0, WallBlock size = {}) {
  engine::Scene s = scene(friction, young_modulus, damping_ratio);
  for (std::size_t row = 0; row < courses.size(); ++row) {
    double left = 0.0;
    for (const char letter : courses[row]) {
      if (letter != '1' && letter != 'h' && letter != '_')
        throw std::invalid_argument("wall pattern: expected 1, h or _, found " + courses[row]);
      const double length = letter == 'h' ? 0.5 * size.length : size.length;
      if (letter != '_') {
        const double y = (static_cast<double>(row) + 0.5) * size.height;
        s.bodies.push_back(block(0.5 * length, 0.5 * size.height, {left + 0.5 * length, y}));
        s.bodies.back().name = "C" + std::to_string(row + 1) + " at " + std::to_string(left);
      }
      left += length;
    }
  }
  s.terrains.push_back(ground(40.0));
  return s;
}

/// The walls of Ferris and Tin-Loi, Int. J. Mech. Sci. 43 (2001) 209-224.
inline std::vector<std::string> ferris_wall(int number) {
  const std::vector<std::string> bond{"h1111h", "11111"};
  std::vector<std::string> courses;
  if (number == 1 || number == 2) {
    for (std::size_t row = 0; row < (number == 1 ? 6u : 10u); ++row) courses.push_back(bond[row % 2]);
  } else if (number == 3) {
    courses = {"1111", "h111h", "1111", "h1_1h", "1h_h1", "h1_1h", "1h_h1", "h1_1h", "1111", "h111h", "1111"};
  } else if (number == 5) {
    courses = {"h11h", "111", "h11h",  "1_1", "hh_hh", "1_1", "hh_hh", "1_1", "h11h", "111",
               "h11h", "1_1", "hh_hh", "1_1", "hh_hh", "1_1", "h11h",  "111", "h11h"};
  } else {
    throw std::invalid_argument("there is no wall " + std::to_string(number));
  }
  return courses;
}

}  // namespace dougong::scenes
