// Corners that coincide, edges on edges, vertices on vertices, bodies inside each other.
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "engine/settle.h"
#include "tests/engine/reference.h"
#include "tests/scenes/audit.h"
#include "tests/scenes/discs.h"
#include "tests/scenes/mirror.h"

namespace dougong::engine {
namespace {

using scenes::block;
using scenes::run_for;
using scenes::Running;
using ::testing::AllOf;
using testing::expect_absolute;
using ::testing::HasSubstr;

constexpr double quarter = 0.25 * std::numbers::pi;

Scene on_ground(std::vector<Body> bodies, double damping_ratio = 1.0, double young_modulus = 1e9) {
  Scene s = scenes::scene(0.6, young_modulus, damping_ratio);
  s.bodies = std::move(bodies);
  for (std::size_t i = 0; i < s.bodies.size(); ++i) s.bodies[i].name = "body " + std::to_string(i);
  s.terrains.push_back(scenes::ground());
  return s;
}

// Blocks in a grid, without bond: every inner corner is that of four blocks.
void check_grid(int columns, int rows, double b, double h) {
  std::vector<Body> bodies;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) bodies.push_back(block(b, h, {(2 * i + 1) * b, (2 * j + 1) * h}));
  Running r(on_ground(std::move(bodies)));
  ASSERT_TRUE(settle(r.model, r.state, {.unbalanced_ratio = 1e-7}).settled);
  const Running start = r;
  r.run(run_for(5.0));
  const std::string name = "grid " + std::to_string(columns) + " x " + std::to_string(rows) + ": ";
  expect_absolute("corners", name + "drift in 5 s (m)", 0.0, greatest_drift(r, start), 1e-9);
  expect_absolute("corners", name + "turn (rad)", 0.0, greatest_turn(r, start), 1e-9);
  const std::size_t last = static_cast<std::size_t>(columns - 1);
  expect_absolute("corners", name + "first and last column sink alike (m)", 0.0,
                  r.position(0).y - r.position(last).y, 1e-10);
}

TEST(CoincidentCorners, OfFourBlocksCarryAsTheirColumnsDo) {
  check_grid(2, 2, 0.5, 0.25);
  check_grid(4, 3, 0.25, 0.125);
  // 0.4 m is no binary number: blocks overlap those diagonally below by 1e-16 m.
  check_grid(3, 2, 0.2, 0.2);
  check_grid(4, 3, 0.2, 0.2);
}

// Where the corners of two blocks meet there is nothing to press on.
TEST(CoincidentCorners, OfTwoBlocksSideBySideDoNotPush) {
  Running r(on_ground({block(0.2, 0.1, {0.0, 0.1}), block(0.2, 0.1, {0.4, 0.3})}));
  r.model.gravity = {};
  const Running start = r;
  r.run(run_for(0.5));
  expect_absolute("corners", "corner at corner: drift in 0.5 s (m)", 0.0, greatest_drift(r, start), 1e-12);
}

double difference_from_mirror(const Running& r, const Running& mirror) {
  double worst = 0.0;
  for (std::size_t i = 0; i < r.bodies(); ++i)
    worst = std::max(
        {worst, std::abs(r.position(i).x + mirror.position(i).x), std::abs(r.angle(i) + mirror.angle(i))});
  return worst;
}

// What stands on a vertex falls to the side it leans to, and mirrored to the other; it makes no energy of it.
void check_fall(const std::string& name, const std::vector<Body>& bodies, double lean, double duration) {
  for (const double xi : {0.0, 1.0}) {
    Scene s = on_ground(bodies, xi);
    s.bodies.back().angle += lean;
    Running r(s), mirror(scenes::mirrored(s));
    auto options = run_for(duration);
    options.step_fraction = 0.2;
    const auto audit = scenes::audited(r, options);
    mirror.run(options);
    const std::string label = name + ", lean " + testing::text(lean) + ", xi=" + testing::text(xi) + ": ";
    EXPECT_TRUE(audit.completed()) << label << audit.run.detail;
    expect_absolute("corners", label + "energy error", 0.0, audit.energy_error, 0.02);
    // In the balance, or without any loss, rounding decides.
    if (lean != 0.0 && xi > 0.0)
      expect_absolute("corners", label + "difference from its mirror image (m, rad)", 0.0,
                      difference_from_mirror(r, mirror), 1e-6);
  }
}

TEST(Vertex, OnAVertexOrAnEdgeMakesNoEnergy) {
  const double high = 0.2 * std::numbers::sqrt2;
  const Body diamond = block(0.2, 0.2, {0.0, high}, quarter);
  for (const double lean : {0.0, 1e-3}) {
    check_fall("vertex on the ground", {diamond}, lean, 2.0);
    check_fall("vertex on vertex", {diamond, block(0.2, 0.2, {0.0, 3.0 * high}, quarter)}, lean, 1.0);
    check_fall("vertex on an edge",
               {block(0.5, 0.1, {0.0, 0.1}), block(0.2, 0.2, {0.1, 0.25 + high}, quarter)}, lean, 2.0);
    check_fall("edge on vertex", {diamond, block(0.4, 0.1, {0.0, 2.0 * high + 0.1})}, lean, 1.0);
  }
}

// Its corner is pressed in where the long face takes over from the short one.
void check_slender(double ratio, double degrees, double speed, double spin) {
  const double h = 0.2, b = ratio * h, angle = degrees * std::numbers::pi / 180.0;
  Scene s =
      on_ground({block(b, h, {0.0, b * std::sin(angle) + h * std::cos(angle) + 1e-4}, angle)}, 0.0, 1e8);
  s.gravity = {}, s.materials[0].friction_coefficient = 0.0;
  s.bodies[0].velocity.y = -speed, s.bodies[0].spin = spin;
  Running r(s);
  auto options = run_for(0.1, 1e-3);
  options.step_fraction = 0.1;
  const auto audit = scenes::audited(r, options);
  EXPECT_TRUE(audit.completed()) << audit.run.detail;
  expect_absolute("corners", "block of 1:" + testing::text(ratio) + " through 45 deg: energy error", 0.0,
                  audit.energy_error, 5e-3);
}

TEST(Vertex, OfASlenderBlockKeepsItsEnergyWhenAnotherFaceTakesOver) {
  check_slender(4.0, 45.5, 4.0, 1.0);
  check_slender(6.0, 46.0, 2.0, -1.0);
  check_slender(10.0, 47.5, 4.0, -2.0);
}

// A block flies past a hexagon so that corner meets corner.
scenes::Audit audit_of_passing(double offset) {
  constexpr double radius = 0.2, half = 0.18, turn = 0.1, block_angle = 1.099, speed = 3.0;
  std::vector<Vec2> corners;
  for (int i = 0; i < 6; ++i) {
    const double angle = turn + i * std::numbers::pi / 3.0;
    corners.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  Body hexagon;
  hexagon.shape = make_polygon(corners).polygon;
  Scene s = scenes::scene(0.0, 1e8, 0.0);
  s.gravity = {};
  s.bodies = {hexagon, block(half, half, {0.6, offset}, block_angle)};
  s.bodies[1].velocity.x = -speed;
  Running r(s);
  auto options = run_for(0.4, 1e-3);
  options.step_fraction = 0.1;
  const auto audit = scenes::audited(r, options);
  EXPECT_TRUE(audit.completed()) << offset << ": " << audit.run.detail;
  return audit;
}

TEST(Vertex, ThatIsPressedPastAnotherMakesNoEnergy) {
  double error = 0.0, gained = 0.0;
  for (int i = 0; i < 150; ++i) {
    const auto audit = audit_of_passing(0.4 + 2e-4 * i);
    error = std::max(error, audit.energy_error), gained = std::max(gained, audit.energy_gained);
  }
  expect_absolute("corners", "block past a hexagon, corner by corner: energy error", 0.0, error, 0.03);
  expect_absolute("corners", "block past a hexagon, corner by corner: energy gained", 0.0, gained, 0.004);
}

// Edges of the same length, one above the other.
TEST(Edge, OnAnEqualEdgeRests) {
  for (const double angle : {0.0, std::numbers::pi, 2.0 * quarter}) {
    Running r(on_ground({block(0.2, 0.2, {0.0, 0.2}), block(0.2, 0.2, {0.0, 0.6}, angle)}));
    ASSERT_TRUE(settle(r.model, r.state, {.unbalanced_ratio = 1e-7}).settled) << angle;
    const Running start = r;
    r.run(run_for(5.0));
    expect_absolute("corners", "edge on edge, turned by " + testing::text(angle) + ": drift (m)", 0.0,
                    greatest_drift(r, start), 1e-9);
  }
}

// A body inside another has no way out that geometry could tell: it is refused, by name.
TEST(DeepOverlap, IsRefusedWithTheNamesOfBoth) {
  const std::vector<std::vector<Body>> cases{
      {block(0.2, 0.2, {0.0, 1.0}), block(0.2, 0.2, {0.0, 1.0})},
      {block(0.2, 0.2, {0.0, 1.0}), block(0.2, 0.2, {0.0, 1.0}, quarter)},
      {block(1.0, 1.0, {0.0, 2.0}), block(0.1, 0.1, {0.0, 2.0})},
      {scenes::disc(0.2, {0.0, 1.0}), scenes::disc(0.2, {0.0, 1.0})},
      {block(0.5, 0.5, {0.0, 1.0}), scenes::disc(0.2, {0.0, 1.0})},
      {scenes::disc(1.0, {0.0, 2.0}), block(0.1, 0.1, {0.0, 2.0})},
  };
  for (std::size_t i = 0; i < cases.size(); ++i) {
    Running r(on_ground(cases[i]));
    const RunOutcome run = r.run(run_for(0.1));
    EXPECT_EQ(run.outcome, Outcome::diverged) << "case " << i;
    EXPECT_THAT(run.detail, AllOf(HasSubstr("body 0"), HasSubstr("body 1"), HasSubstr("overlap")))
        << "case " << i;
  }
}

}  // namespace
}  // namespace dougong::engine
