// Floors that shear against each other and do nothing else: flat blocks bonded face to face, with a shear
// stiffness and a dashpot of their own for every storey, and a normal stiffness at which nothing tilts.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "tests/oracles/shear_chain.h"
#include "tests/scenes/blocks.h"

namespace dougong::scenes {

namespace shear_building {

constexpr double width = 10.0, thickness = 0.1;  // m, of a floor
constexpr double upright = 1e10;                 // N/m, of a storey upwards

inline engine::Bond bond_between(std::size_t floor, double shear_stiffness) {
  engine::Bond b;
  b.name = "storey " + std::to_string(floor + 1);
  b.a = floor == 0 ? engine::Owner{true, 0} : engine::Owner{false, floor - 1};
  b.b = {false, floor};
  const double y = static_cast<double>(floor) * thickness;
  b.start = {-0.5 * width, y}, b.end = {0.5 * width, y};
  b.normal_stiffness = upright / width;
  b.shear_stiffness = shear_stiffness / width;
  b.damping_ratio = 0.0;
  return b;
}

// A dashpot of c (N s/m) between a floor and the one below, along a line so long that it stays level.
inline engine::Joint dashpot(engine::Owner below, std::size_t floor, double level_below, double c) {
  constexpr double far = 1e4;  // m
  engine::Joint j;
  j.name = "dashpot " + std::to_string(floor + 1);
  j.kind = engine::JointKind::spring;
  j.a = below, j.b = {false, floor};
  j.anchor_a = {-far, level_below};
  j.stiffness = 1e-3;
  j.damping = c;
  return j;
}

}  // namespace shear_building

/// Without gravity; a level's yield drift makes its storey two bonds, of which one flows.
inline engine::Scene shear_building_scene(const std::vector<oracles::ChainLevel>& levels,
                                          std::shared_ptr<const engine::PrescribedMotion> motion) {
  using namespace shear_building;
  engine::Scene s = scene(0.0, 1e9);
  s.gravity = {};
  s.terrains.push_back(ground(2.0 * width, {}, 0.0, std::move(motion)));
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const oracles::ChainLevel& l = levels[i];
    const double y = (static_cast<double>(i) + 0.5) * thickness;
    engine::Body floor = block(0.5 * width, 0.5 * thickness, {0.0, y});
    floor.mass = l.mass;
    s.bodies.push_back(floor);
    engine::Bond elastic = bond_between(i, l.stiffness);
    if (std::isfinite(l.yield)) {
      engine::Bond flowing = bond_between(i, (1.0 - l.hardening) * l.stiffness);
      elastic.shear_stiffness = l.hardening * l.stiffness / width;
      flowing.cohesion = (1.0 - l.hardening) * l.stiffness * l.yield / width;
      flowing.friction_coefficient = 0.0;
      flowing.yield_strength = 1e12;  // ductile: what it cannot hold in shear flows
      s.bonds.push_back(flowing);
    }
    s.bonds.push_back(elastic);
    const engine::Owner below = i == 0 ? engine::Owner{true, 0} : engine::Owner{false, i - 1};
    const double level = i == 0 ? y + 1.0 : thickness;  // the ground's centroid lies 1 m deep
    if (l.damping > 0.0) s.joints.push_back(dashpot(below, i, level, l.damping));
    if (l.drag > 0.0) s.joints.push_back(dashpot({true, 0}, i, y + 1.0, l.drag));
  }
  return s;
}

}  // namespace dougong::scenes
