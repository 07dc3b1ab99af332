// Blocks at rest on each other whose stiffnesses and masses are far apart (validation cases X01 and X02).
#pragma once

#include "tests/scenes/running.h"

namespace dougong::scenes {

/// One plate on another on the ground, 1 m wide, 0.1 m thick. A face of half sizes b, h is pressed in with
/// the stiffness 2 b E/h per thickness.
struct TwoPlates {
  double lower, upper;            // N/m
  double lower_mass, upper_mass;  // kg
  double g = 9.81, b = 0.5, h = 0.05;

  engine::Scene scene() const {
    engine::Scene s = column(2, b, h, 0.6);
    s.gravity.y = -g;
    s.materials.assign(2, s.materials[0]);
    s.materials[0].young_modulus = lower * h / (2.0 * b);
    s.materials[1].young_modulus = upper * h / (2.0 * b);
    s.bodies[0].mass = lower_mass, s.bodies[1].mass = upper_mass;
    s.bodies[1].material = 1;
    return s;
  }
};

}  // namespace dougong::scenes
