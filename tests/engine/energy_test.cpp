#include "engine/energy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "engine/settle.h"
#include "tests/scenes/running.h"

namespace dougong::engine {
namespace {

using scenes::run_for;
using scenes::Running;

TEST(Energies, OfABlockInFlightAreKineticAndGravity) {
  Scene s = scenes::scene(0.6);
  s.bodies.push_back(scenes::block(0.5, 0.2, {0.0, 5.0}));
  s.bodies[0].velocity = {3.0, 4.0};
  s.bodies[0].spin = 1.5;
  Running r(s);
  const Energies e = r.energies();
  const double m = 2400.0 * 0.4, i = m * (1.0 + 0.16) / 12.0;
  EXPECT_NEAR(e.kinetic, 0.5 * m * 25.0 + 0.5 * i * 2.25, 1e-9);
  EXPECT_EQ(e.elastic, 0.0);
  r.run(run_for(0.5));
  EXPECT_NEAR(r.energies().gravity - e.gravity, m * 9.81 * (r.position().y - 5.0), 1e-8);
  EXPECT_NEAR(r.energies().balance(), e.balance(), 1e-8);
}

TEST(Energies, OfASlidingBlockGoToFriction) {
  for (const double mu : {0.2, 0.5}) {
    Scene s = scenes::block_on_ground(0.5, 0.05, mu, 3e9);
    Running r(s);
    settle(r.model, r.state);
    r.state.v()[0] = 1.0;
    const Energies start = r.energies();
    r.run(run_for(1.0));
    const Energies end = r.energies();
    EXPECT_NEAR(end.friction / start.kinetic, 1.0, 2e-3);
    EXPECT_NEAR(end.balance() - start.balance(), 0.0, 1e-3 * start.kinetic);
    EXPECT_LT(end.kinetic, 1e-9 * start.kinetic);
  }
}

TEST(Energies, OfAnElasticBounceComeBack) {
  Scene s = scenes::scene(0.0, 1e8, 0.0);
  s.bodies.push_back(scenes::block(0.5, 0.2, {0.0, 0.2 + 0.01}));
  s.terrains.push_back(scenes::ground());
  Running r(s);
  const Energies start = r.energies();
  DriveOptions options = run_for(0.2, 1e-3);
  options.step_fraction = 0.05;
  double most_elastic = 0.0, worst = 0.0;
  const double fallen = r.model.mass[0] * 9.81 * 0.01;
  r.run(options, [&](const Sample& sample) {
    const Energies e = energies_of(r.model, sample.state);
    most_elastic = std::max(most_elastic, e.elastic);
    worst = std::max(worst, std::abs(e.balance() - start.balance()));
    return Wish::go_on;
  });
  EXPECT_GT(most_elastic, 0.9 * fallen);
  EXPECT_LT(worst, 0.01 * fallen);
  EXPECT_EQ(r.energies().damping, 0.0);
  EXPECT_NEAR(r.energies().friction, 0.0, 1e-9 * fallen);
}

TEST(Energies, OfAPlasticImpactGoToTheDashpots) {
  Scene s = scenes::scene(0.6, 1e8, 1.0);
  s.bodies.push_back(scenes::block(0.5, 0.2, {0.0, 0.2 + 0.01}));
  s.terrains.push_back(scenes::ground());
  Running r(s);
  const double start = r.energies().balance(), fallen = r.model.mass[0] * 9.81 * 0.01;
  DriveOptions options = run_for(1.0, 1e-3);
  options.step_fraction = 0.2;
  r.run(options);
  EXPECT_NEAR(r.energies().damping / fallen, 1.0, 0.02);
  EXPECT_NEAR(r.energies().balance() - start, 0.0, 0.01 * fallen);
}

// A slab of rubber slides without friction over the end of a table, or back onto it. Its weight W rests on a
// length that gets shorter or longer on the way.
struct OffTheTable {
  Energies start, end;
};

OffTheTable slide(double from, double to) {
  constexpr double half = 1.0, height = 0.2, modulus = 1e7, speed = 0.2;
  Scene s = scenes::scene(0.0, modulus);
  s.bodies.push_back(scenes::block(half, 0.5 * height, {from, 0.5 * height}));
  Terrain table;
  table.name = "table";
  table.shape = make_rectangle(4.0, 1.0);
  table.position = {-2.0, -0.5};  // its end at x = 0
  s.terrains.push_back(table);
  Running r(s);
  settle(r.model, r.state);
  r.state.v()[0] = to > from ? speed : -speed;
  OffTheTable t;
  t.start = r.energies();
  DriveOptions options = run_for(std::abs(to - from) / speed);
  options.step_fraction = 0.1;
  r.run(options);
  t.end = r.energies();
  return t;
}

// Centred at x < 0 the slab rests on L = 1 - x, its weight e = (1 + x)/2 beside the middle of that: the
// corners bear W (1/2 +- e/L) on springs of k L/2 each.
double stored_at(double x) {
  const double weight = 960.0 * 9.81, per_length = 1e8, length = 1.0 - x, lever = 0.5 * (1.0 + x) / length;
  return weight * weight / (per_length * length) * (0.5 + 2.0 * lever * lever);
}

TEST(Energies, OfAContactWhoseLengthChangesUnderLoadAreKept) {
  for (const auto& [from, to] : {std::pair{-0.9, -0.4}, std::pair{-0.4, -0.9}}) {
    const OffTheTable t = slide(from, to);
    const double stored = stored_at(to) - stored_at(from);
    EXPECT_NEAR((t.end.elastic - t.start.elastic) / stored, 1.0, 0.02) << from;
    EXPECT_LT(std::abs(t.end.balance() - t.start.balance()), 0.01 * std::abs(stored)) << from;
  }
}

// Sixteen bricks of all sizes thrown about in a box, corner on corner and face on face, without any loss.
Scene brick_gas(unsigned seed) {
  Scene s = scenes::scene(0.0, 1e8, 0.0);
  s.gravity = {};
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (int i = 0; i < 16; ++i) {
    const double b = 0.1 + 0.05 * any(random), h = 0.1 + 0.05 * any(random);
    s.bodies.push_back(scenes::block(b, h, {-0.9 + 0.6 * (i % 4), -0.9 + 0.6 * (i / 4)}, 3.0 * any(random)));
    s.bodies.back().name = "brick " + std::to_string(i);
    s.bodies.back().velocity = {2.0 * any(random), 2.0 * any(random)};
    s.bodies.back().spin = 5.0 * any(random);
  }
  for (int side = 0; side < 4; ++side) {
    Terrain wall;
    wall.name = "wall " + std::to_string(side);
    wall.shape = make_rectangle(4.4, 1.0);
    wall.position = rotated({0.0, -1.7}, side * 0.5 * std::numbers::pi);
    wall.angle = side * 0.5 * std::numbers::pi;
    s.terrains.push_back(wall);
  }
  return s;
}

TEST(Energies, OfBricksThatCollideWithoutLossStay) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    Running r(brick_gas(seed));
    const Energies start = r.energies();
    double worst = 0.0;
    DriveOptions options = run_for(3.0);
    options.step_fraction = 0.1;
    const RunOutcome run = r.run(options, [&](const Sample&) {
      worst = std::max(worst, std::abs(r.energies().balance() - start.balance()));
      return Wish::go_on;
    });
    EXPECT_EQ(run.outcome, Outcome::completed) << seed << ": " << run.detail;
    EXPECT_LT(worst, 0.01 * start.kinetic) << seed;
    std::printf("bricks in a box, seed %u: error/energy %.2g\n", seed, worst / start.kinetic);
  }
}

// A ground that pulls a block along puts in force times velocity: the block's kinetic energy and, while
// it slips, the friction that the relative motion eats.
TEST(Energies, GetTheirInputFromTheMovingGround) {
  const double a = 4.0, mu = 0.2;
  Scene s = scenes::block_on_ground(0.5, 0.05, mu, 3e9);
  s.terrains[0].motion = scenes::horizontal_motion([=](double) { return a; }, [=](double t) { return a * t; },
                                                   [=](double t) { return 0.5 * a * t * t; });
  Running r(s);
  settle(r.model, r.state);
  const double start = r.energies().balance();
  r.run(run_for(0.5));
  const Energies e = r.energies();
  const double m = r.model.mass[0], pull = mu * m * 9.81;
  EXPECT_NEAR(e.input / (pull * 0.5 * a * 0.25), 1.0, 2e-3);
  EXPECT_NEAR(e.friction / (pull * 0.5 * (a - mu * 9.81) * 0.25), 1.0, 5e-3);
  EXPECT_LT(std::abs(e.balance() - start), 1e-3 * e.input);
}

// The whole ledger of a shaken wall: every loss is a loss, and nothing is made.
TEST(Energies, OfAShakenWallBalance) {
  Scene s = scenes::wall(2, 3, 0.6, 1e9);
  const double w = 2.0 * std::numbers::pi * 2.0, a = 3.0;
  s.terrains[0].motion =
      scenes::horizontal_motion([=](double t) { return a * std::sin(w * t); },
                                [=](double t) { return a / w * (1.0 - std::cos(w * t)); },
                                [=](double t) { return a / w * (t - std::sin(w * t) / w); });
  for (const char* integrator :
       {"velocity-verlet", "symplectic-euler", "leapfrog", "rk3", "rk4", "dormand-prince"}) {
    Running r(s);
    ASSERT_TRUE(settle(r.model, r.state).settled);
    const double start = r.energies().balance();
    double worst = 0.0, input = 0.0;
    Energies last{};
    const RunOutcome run = r.run(run_for(1.0, 0.01, integrator), [&](const Sample& sample) {
      const Energies e = energies_of(r.model, sample.state);
      worst = std::max(worst, std::abs(e.balance() - start));
      input = std::max(input, e.input);
      EXPECT_GE(e.friction, -1e-6 * (1.0 + input)) << integrator << " " << sample.state.time;
      EXPECT_GE(e.damping, last.damping - 3e-6 * (1.0 + input)) << integrator << " " << sample.state.time;
      last = e;
      return Wish::go_on;
    });
    EXPECT_EQ(run.outcome, Outcome::completed);
    EXPECT_LT(worst, 0.01 * input) << integrator;
    ::testing::Test::RecordProperty(std::string(integrator) + " ledger error over input",
                                    std::to_string(worst / input));
    std::printf("ledger %s wall: error/input %.3g\n", integrator, worst / input);
  }
}

}  // namespace
}  // namespace dougong::engine
