// Bars cut into bonded blocks of equal length, with the springs of the bar between: per area E/l along it and
// kappa G/l across, l the distance of the centroids; l/2 of it at an end that is held.
#pragma once

#include <string>

#include "tests/scenes/blocks.h"

namespace dougong::scenes {

struct BondedBar {
  double depth = 1.0, modulus = 25e9;  // m, Pa; 1 m thick
  double shear_modulus = 0.0;          // Pa, kappa G; 0: no shear strain to speak of
  double density = 2400.0;             // kg/m3
  int count = 10;
  engine::Vec2 start, end;  // m, of the axis
};

/// Adds the blocks of a bar and the bonds between them, and to what its ends are given to. Returns the index
/// of the first; the others follow. The blocks touch nothing.
inline std::size_t add_bar(engine::Scene& s, const BondedBar& bar, const engine::Owner* at_start,
                           const engine::Owner* at_end) {
  using engine::Owner;
  const engine::Vec2 along = (1.0 / bar.count) * (bar.end - bar.start);
  const double l = norm(along);
  const engine::Vec2 across = (0.5 * bar.depth / l) * turned(along);
  const std::size_t first = s.bodies.size();
  const auto bond = [&](Owner a, Owner b, int place, double distance) {
    engine::Bond joint;
    joint.name = "bond " + std::to_string(s.bonds.size());
    joint.a = a, joint.b = b;
    const engine::Vec2 middle = bar.start + static_cast<double>(place) * along;
    joint.start = middle - across, joint.end = middle + across;
    joint.normal_stiffness = bar.modulus / distance;
    joint.shear_stiffness = (bar.shear_modulus > 0.0 ? bar.shear_modulus : 1e4 * bar.modulus) / distance;
    s.bonds.push_back(joint);
  };
  for (int i = 0; i < bar.count; ++i) {
    engine::Body body =
        block(0.5 * l, 0.5 * bar.depth, bar.start + (i + 0.5) * along, std::atan2(along.y, along.x));
    body.name = "block " + std::to_string(s.bodies.size());
    body.mass = bar.density * l * bar.depth;
    body.collides = false;
    s.bodies.push_back(body);
    if (i > 0) bond({false, first + i - 1u}, {false, first + static_cast<std::size_t>(i)}, i, l);
  }
  if (at_start) bond(*at_start, {false, first}, 0, 0.5 * l);
  if (at_end) bond({false, s.bodies.size() - 1}, *at_end, bar.count, 0.5 * l);
  return first;
}

}  // namespace dougong::scenes
