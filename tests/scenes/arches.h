// Arches of the comparisons C02 and C03 and of the validation cases L01 and L02: all are the layout `arch`.
#pragma once

#include <cmath>
#include <numbers>

#include "structures/layouts/layout.h"

namespace dougong::scenes {

struct ArchCase {
  double radius, thickness_ratio;  // m, t/R
  double voussoirs;
  double embrace = std::numbers::pi;  // rad
  double friction = 0.7;
  double young_modulus = 1e10;  // Pa
  double damping_ratio = 1.0;

  engine::Scene scene() const {
    const double springs_from_ground = embrace == std::numbers::pi ? 0.0 : 0.2 * radius;
    return structures::build_layout("arch", {{"radius", radius},
                                             {"ring_thickness", thickness_ratio * radius},
                                             {"voussoirs", voussoirs},
                                             {"embrace_angle", embrace},
                                             {"abutment_height", springs_from_ground},
                                             {"ground_width", 4.0 * radius},
                                             {"friction", friction},
                                             {"young_modulus", young_modulus},
                                             {"damping_ratio", damping_ratio}})
        .scene;
  }
};

/// C02: Gilbert, Casapulla and Ahmed, Comput. Struct. 84 (2006) 873-887.
inline ArchCase semicircle_of_27(double thickness_ratio, double friction, double young_modulus = 3e9) {
  return {10.0, thickness_ratio, 27, std::numbers::pi, friction, young_modulus};
}

/// C03: Hua et al., LACT3 (2025): 27 divisions of a semicircle, of which the first and the last belong to the
/// base.
inline ArchCase tilting_arch(double young_modulus, double damping_ratio = 1.0) {
  const double inner = 0.3170, outer = 0.3733, radius = 0.5 * (inner + outer);
  return {radius,
          (outer - inner) / radius,
          25,
          25.0 / 27.0 * std::numbers::pi,
          std::tan(std::numbers::pi / 6.0),
          young_modulus,
          damping_ratio};
}

}  // namespace dougong::scenes
