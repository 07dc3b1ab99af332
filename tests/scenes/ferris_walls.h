// The dry walls of Ferris and Tin-Loi, Int. J. Mech. Sci. 43 (2001) 209-224, as the layout builds them
// (comparison C01).
#pragma once

#include <stdexcept>
#include <string>

#include "structures/layouts/layout.h"

namespace dougong::scenes {

struct WallPattern {
  std::string courses;
  int repeats;
};

inline WallPattern ferris_pattern(int number) {
  if (number == 1) return {"h1111h, 11111", 3};
  if (number == 2) return {"h1111h, 11111", 5};
  if (number == 3) return {"1111, h111h, 1111, h1_1h, 1h_h1, h1_1h, 1h_h1, h1_1h, 1111, h111h, 1111", 1};
  if (number == 5)
    return {
        "h11h, 111, h11h, 1_1, hh_hh, 1_1, hh_hh, 1_1, h11h, 111, h11h, 1_1, hh_hh, 1_1, hh_hh, 1_1, h11h, "
        "111, h11h",
        1};
  throw std::invalid_argument("there is no wall " + std::to_string(number));
}

inline engine::Scene ferris_wall(int number, double young_modulus, double damping_ratio = 1.0) {
  const WallPattern pattern = ferris_pattern(number);
  return structures::build_layout("pattern-wall", {{"pattern", pattern.courses},
                                                   {"repeats", pattern.repeats},
                                                   {"young_modulus", young_modulus},
                                                   {"damping_ratio", damping_ratio}})
      .scene;
}

}  // namespace dougong::scenes
