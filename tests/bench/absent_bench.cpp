// What a scene lacks costs nothing: a step of the wall S1 as it is, and with charges, fields, bonds, joints
// and observers named but not there; below, the same things present.
//
//     absent_bench [ROUNDS [TENTHS_OF_A_SECOND]]
#include <cmath>
#include <cstdlib>

#include "tests/bench/alternate.h"
#include "tests/bench/settled_wall.h"

namespace dougong::bench {
namespace {

constexpr double settlement = 1e-3, amplitude = 0.3;  // m, g
constexpr double outputs_apart = 0.01;                // s

engine::Scene plain() {
  return s1_scene(settlement, amplitude);
}

engine::Scene neutral_in_an_electric_world() {
  engine::Scene s = plain();
  s.fields.coulomb_constant = 8.988e9;
  s.fields.softening = 0.1;
  s.fields.opening_angle = 0.5;
  s.fields.electric_field = {100.0, 0.0};
  for (engine::Body& body : s.bodies) body.charge = body.linear_drag = body.quadratic_drag = 0.0;
  return s;
}

engine::Scene rules_that_repeat_the_default() {
  engine::Scene s = plain();
  s.materials.push_back(s.materials[0]);
  s.material_pairs.push_back({0, 1, s.materials[0].friction_coefficient});
  return s;
}

engine::Scene charged() {
  engine::Scene s = neutral_in_an_electric_world();
  s.fields.electric_field = {};
  for (engine::Body& body : s.bodies) body.charge = 1e-9;
  return s;
}

engine::Scene dragged() {
  engine::Scene s = plain();
  for (engine::Body& body : s.bodies) body.linear_drag = 1e-6;
  return s;
}

// The left end of the lowest course and the half brick on it.
engine::Scene bonded() {
  const scenes::RunningBond brickwork;
  engine::Scene s = plain();
  engine::Bond bond;
  bond.a.index = 0, bond.b.index = static_cast<std::size_t>(brickwork.bricks);
  bond.start = {0.0, brickwork.height};
  bond.end = {0.5 * (brickwork.length - brickwork.head_joint), brickwork.height};
  s.bonds.push_back(bond);
  return s;
}

engine::Observer silent() {
  return [](const engine::Sample&) { return engine::Wish::go_on; };
}

engine::DriveOptions options_for(double duration) {
  engine::DriveOptions options = scenes::run_for(duration, outputs_apart);
  options.step_fraction = 0.9;
  return options;
}

Contestant contestant(const char* name, const engine::Scene& scene, double duration,
                      engine::Observer observe = {}) {
  return {name, [wall = settle(scene), options = options_for(duration), observe] {
            return 1e6 * run(wall, options, observe).per_step();
          }};
}

void compare(int rounds, double duration) {
  std::vector<Contestant> walls{
      contestant("S1", plain(), duration),
      contestant("S1 once more: what the comparison is good to", plain(), duration),
      contestant("constants of fields, no body charged", neutral_in_an_electric_world(), duration),
      contestant("a rule for a material that nothing is of", rules_that_repeat_the_default(), duration),
      contestant("an observer that only looks, every 10 ms", plain(), duration, silent()),
      contestant("present: drag on every brick", dragged(), duration),
      contestant("present: a charge on every brick, by tree", charged(), duration),
      contestant("present: one bond", bonded(), duration),
  };
  alternate(walls, rounds);
  print_table(walls, "scene", Against::first);
}

}  // namespace
}  // namespace dougong::bench

int main(int count, char** arguments) {
  const int rounds = count > 1 ? std::atoi(arguments[1]) : 5;
  const double duration = 0.1 * (count > 2 ? std::atof(arguments[2]) : 1.0);
  dougong::bench::compare(rounds, duration);
}
