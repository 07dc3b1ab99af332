// Validation cases E04, E11 and E17: balls that bounce, bodies that collide, and what is conserved.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "tests/engine/reference.h"
#include "tests/oracles/bouncing_ball.h"
#include "tests/oracles/collisions.h"
#include "tests/scenes/discs.h"

namespace dougong::engine {
namespace {

using scenes::disc;
using scenes::run_for;
using scenes::Running;
using testing::expect_absolute;
using testing::expect_relative;
using testing::text;

struct Bounces {
  std::vector<double> times, apexes;
  double rest_time = 0.0;  // the last time it was more than 0.1 um up
};

// An impact is where the falling ball starts to rise.
Bounces measured_bounces(Running& r, double radius, double until) {
  Bounces b;
  double last_speed = 0.0, height = 0.0;
  auto options = run_for(until, 1e-4);
  options.step_fraction = 0.01;
  r.run(options, [&](const Sample& sample) {
    const double up = r.position().y - radius, speed = r.velocity().y;
    if (last_speed < 0.0 && speed > 0.0) {
      if (!b.times.empty()) b.apexes.push_back(height);
      b.times.push_back(sample.state.time - 0.5e-4), height = 0.0;
    }
    height = std::max(height, up), last_speed = speed;
    if (up > 1e-7) b.rest_time = sample.state.time;
    return Wish::go_on;
  });
  return b;
}

Scene dropped_ball(const oracles::BouncingBall& c, double radius, double young_modulus) {
  Scene s = scenes::scene(0.6, young_modulus, damping_ratio_for_restitution(c.restitution));
  s.gravity.y = -c.g;
  s.bodies.push_back(disc(radius, {0.0, radius + c.clearance}));
  s.terrains.push_back(scenes::ground());
  return s;
}

void check_bouncing(const oracles::BouncingBall& c, double radius) {
  Running r(dropped_ball(c, radius, 60e9));
  const Bounces b = measured_bounces(r, radius, c.rest_time() + 0.3);
  ASSERT_GE(b.apexes.size(), 6u);
  for (int n = 0; n < 6; ++n) {
    const std::string name = "e=" + text(c.restitution) + " impact " + std::to_string(n + 1) + " ";
    expect_relative("E04", name + "t", c.impact_time(n), b.times[static_cast<std::size_t>(n)], 0.01);
    expect_relative("E04", name + "apex", c.apex_after(n), b.apexes[static_cast<std::size_t>(n)], 0.01);
  }
  expect_relative("E04", "e=" + text(c.restitution) + " rests at", c.rest_time(), b.rest_time, 0.01);
  expect_absolute("E04", "e=" + text(c.restitution) + " speed at rest", 0.0, norm(r.velocity()), 1e-9);
}

TEST(BouncingBall, ImpactsRisesAndComesToRestAsItsRestitutionSays) {
  const oracles::BouncingBall reference{1.0, 0.7, 9.81};
  const double times[] = {0.451524, 1.08366, 1.52615, 1.8359, 2.05272, 2.20449};
  for (int n = 0; n < 6; ++n) EXPECT_NEAR(reference.impact_time(n) / times[n], 1.0, 4e-6);
  EXPECT_NEAR(reference.rest_time(), 2.55863, 1e-5);
  check_bouncing(reference, 0.1);
}
TEST(BouncingBall, DoesSoForOtherBallsToo) {
  check_bouncing({2.0, 0.6, 9.81}, 0.2);
}

// The greatest error of ten impacts that meet the floor at other parts of a step.
double worst_restitution_error(const std::string& integrator, double step_fraction) {
  double worst = 0.0;
  for (int i = 0; i < 10; ++i) {
    const oracles::BouncingBall c{0.1 + 1e-4 * i, 0.7, 9.81};
    Running r(dropped_ball(c, 0.1, 3e9));
    auto options = run_for(1.8 * c.fall_time(), 1e-3, integrator);
    options.step_fraction = step_fraction;
    double before = 0.0, after = 0.0;
    r.run(options, [&](const Sample&) {
      const double energy = 0.5 * dot(r.velocity(), r.velocity()) + c.g * (r.position().y - 0.1);
      (before == 0.0 ? before : after) = energy;
      return Wish::go_on;
    });
    worst = std::max(worst, std::abs(std::sqrt(after / before) / c.restitution - 1.0));
  }
  std::printf("E04 %s at %g of the bound: worst error of the restitution %.2g\n", integrator.c_str(),
              step_fraction, worst);
  return worst;
}

TEST(BouncingBall, NeedsASmallPartOfTheStabilityBoundForItsRestitution) {
  for (const char* integrator : {"velocity-verlet", "symplectic-euler", "rk4"}) {
    const double coarse = worst_restitution_error(integrator, 0.5);
    const double medium = worst_restitution_error(integrator, 0.1);
    const double fine = worst_restitution_error(integrator, 0.01);
    EXPECT_LT(medium, coarse);
    EXPECT_LT(fine, medium);
    EXPECT_LT(fine, 0.015);
  }
  EXPECT_LT(worst_restitution_error("velocity-verlet", 0.1), 0.005);
}

// Falls coarsely, then meets the floor in steps of a 40 000th of the contact.
oracles::CompliantImpact measured_impact(const oracles::BallOnSpring& c) {
  Scene s = scenes::scene(0.6, 30e9, c.damping_ratio);
  s.gravity.y = -c.g;
  s.contact.point_stiffness = c.stiffness;
  s.bodies.push_back(disc(0.5, {0.0, 0.5 + c.clearance}));
  s.bodies[0].mass = c.mass;
  s.terrains.push_back(scenes::ground());
  Running r(s);
  const double v0 = std::sqrt(2.0 * c.g * c.clearance), fall = v0 / c.g;
  r.run(run_for(0.999 * fall, 0.001 * fall));
  oracles::CompliantImpact measured{0.0, 0.0, 0.0};
  double start = 0.0;
  r.run(run_for(0.1 * fall, 2e-6), [&](const Sample& sample) {
    const double overlap = 0.5 - r.position().y, speed = r.velocity().y;
    if (overlap <= 0.0 && speed < 0.0) start = sample.state.time;
    if (sample.terrain_reaction.y > 0.0) measured.duration = sample.state.time - start;
    measured.penetration = std::max(measured.penetration, overlap);
    measured.restitution = speed / v0;
    return overlap <= 0.0 && speed > 0.0 ? Wish::stop : Wish::go_on;
  });
  return measured;
}

void check_compliant(const oracles::BallOnSpring& c) {
  const auto exact = c.impact(), measured = measured_impact(c);
  const std::string name = "k=" + text(c.stiffness) + " zeta=" + text(c.damping_ratio) + " ";
  expect_relative("E04", name + "restitution", exact.restitution, measured.restitution, 0.01);
  expect_relative("E04", name + "penetration", exact.penetration, measured.penetration, 0.01);
  expect_relative("E04", name + "contact time", exact.duration, measured.duration, 0.01);
}

TEST(BouncingBall, OnASpringThatNeverPullsIsTheReference) {
  const oracles::BallOnSpring reference{1.0, 1e5, 0.1, 1.0, 9.81};
  const auto exact = reference.impact();
  EXPECT_NEAR(exact.restitution / 0.74162, 1.0, 1e-5);
  EXPECT_NEAR(exact.penetration / 0.012164, 1.0, 5e-5);
  EXPECT_NEAR(exact.duration / 0.00939993, 1.0, 1e-5);
  check_compliant(reference);
  check_compliant({3.0, 4e4, 0.4, 0.5, 9.81});
}

// Linear and angular momentum about the origin.
struct Momenta {
  Vec2 linear;
  double angular = 0.0;
  double turnover = 0.0;  // the same without signs
};
Momenta momenta(const Running& r) {
  Momenta sum{scenes::momentum(r), scenes::angular_momentum(r, {}), 0.0};
  for (std::size_t i = 0; i < r.bodies(); ++i)
    sum.turnover += r.model.mass[i] * norm(r.velocity(i)) * (1.0 + norm(r.position(i)));
  return sum;
}

void expect_same_momenta(const std::string& name, const std::string& quantity, const Momenta& before,
                         const Momenta& after) {
  expect_absolute(name, quantity + " linear momentum", 0.0,
                  norm(after.linear - before.linear) / before.turnover, 1e-10);
  expect_absolute(name, quantity + " angular momentum", 0.0,
                  std::abs(after.angular - before.angular) / before.turnover, 1e-10);
}

Scene floating(double friction, double restitution) {
  const double xi = restitution == 1.0 ? 0.0 : damping_ratio_for_restitution(restitution);
  Scene s = scenes::scene(friction, 30e9, xi);
  s.gravity = {};
  return s;
}

void add(Scene& s, Body body, double mass, oracles::Vector velocity) {
  body.mass = mass;
  body.velocity = {velocity.x, velocity.y};
  s.bodies.push_back(std::move(body));
}

DriveOptions fine_run(double end_time) {
  auto options = run_for(end_time, end_time);
  options.step_fraction = 0.005;
  return options;
}

void check_discs(const std::string& name, const oracles::DiscImpact& c) {
  Scene s = floating(0.0, c.restitution);
  const Vec2 n = rotated({1.0, 0.0}, c.direction);
  add(s, disc(0.2, {}), c.mass1, c.velocity1);
  add(s, disc(0.3, 0.500001 * n), c.mass2, c.velocity2);
  Running r(s);
  const Momenta before = momenta(r);
  r.run(fine_run(0.01));
  const auto exact = c.after();
  expect_relative("E11", name + " v1.x", exact.first.x, r.velocity(0).x, 0.01);
  if (exact.first.y != 0.0) expect_relative("E11", name + " v1.y", exact.first.y, r.velocity(0).y, 0.01);
  expect_relative("E11", name + " v2.x", exact.second.x, r.velocity(1).x, 0.01);
  if (exact.second.y != 0.0) expect_relative("E11", name + " v2.y", exact.second.y, r.velocity(1).y, 0.01);
  expect_same_momenta("E11", name, before, momenta(r));
}

TEST(Collision, OfTwoDiscsIsNewtons) {
  const oracles::DiscImpact reference{1.0, 2.5, {3.0, 0.5}, {-1.0, 0.2}, 0.5, 0.8};
  EXPECT_NEAR(reference.after().first.x, -1.12306, 1e-5);
  EXPECT_NEAR(reference.after().second.y, 1.10098, 1e-5);
  check_discs("(a)", reference);
  check_discs("(a) second", {4.0, 0.7, {1.0, -2.0}, {-0.5, 3.0}, -0.9, 0.4});
}

TEST(Collision, OfALightAndAHeavyDiscIsElastic) {
  check_discs("(c)", {1.0, 1e5, {1.0, 0.0}, {0.0, 0.0}, 0.0, 1.0});
  check_discs("(c) second", {1e4, 1.0, {2.0, 0.0}, {-1.0, 0.0}, 0.0, 1.0});
}

void check_rod(const std::string& name, const oracles::RodImpact& c) {
  Scene s = floating(0.0, c.restitution);
  Body rod = scenes::block(0.5 * c.length, 0.5 * c.depth, {});
  add(s, rod, c.rod_mass, {0.0, 0.0});
  add(s, disc(0.05, {-c.arm, 0.5 * c.depth + 0.050001}), c.disc_mass, {0.0, -c.speed});
  Running r(s);
  const Momenta before = momenta(r);
  r.run(fine_run(0.001));
  expect_relative("E11", name + " disc", c.disc_speed(), -r.velocity(1).y, 0.01);
  expect_relative("E11", name + " rod", c.rod_speed(), -r.velocity(0).y, 0.01);
  expect_relative("E11", name + " rod's spin", c.rod_spin(), r.spin(0), 0.01);
  expect_same_momenta("E11", name, before, momenta(r));
}

TEST(Collision, OfADiscAndAFreeRodTurnsIt) {
  const oracles::RodImpact reference{1.0, 4.0, 2.0, 0.1, 0.7, 3.0, 0.8};
  EXPECT_NEAR(reference.disc_speed(), -0.340378, 1e-6);
  EXPECT_NEAR(reference.rod_spin(), 1.74933, 1e-5);
  check_rod("(b)", reference);
  check_rod("(b) second", {3.0, 2.0, 1.2, 0.2, 0.25, 1.0, 0.3});
}

// Twenty discs in a closed box, thrown about without gravity. Springs of 1e6 N/m, 1 kg each.
Scene box_of_discs(double friction) {
  Scene s = floating(friction, 1.0);
  s.contact.point_stiffness = 1e6;
  scenes::add_box(s, 1.1, 1.1);
  std::uint32_t random = 2008;
  for (int i = 0; i < 20; ++i) {
    const auto draw = [&] { return (random = 1664525u * random + 1013904223u) / 4294967296.0 - 0.5; };
    const Vec2 place{-0.44 + 0.22 * (i % 5), -0.4 + 0.22 * (i / 5)};
    const double vx = 6.0 * draw(), vy = 6.0 * draw();
    add(s, disc(0.09, place), 1.0, {vx, vy});
  }
  return s;
}

struct BoxRun {
  double largest_rise = 0.0, largest_fall = 0.0, last = 0.0;  // of the energy, over the first
  double largest_regain = 0.0;                                // above the least so far
  std::size_t collisions = 0;
};

// Kinetic energy and that of the springs in contact, at outputs shorter than a contact.
BoxRun run_box(const Scene& s, double until, double step_fraction) {
  Running r(s);
  auto options = run_for(until, 1e-3);
  options.step_fraction = step_fraction;
  const auto energy = [&] { return r.energies().kinetic + r.energies().elastic; };
  const double first = energy();
  double least = first;
  std::set<std::pair<Index, Index>> touching;
  BoxRun run;
  r.run(options, [&](const Sample&) {
    const double now = energy();
    run.largest_rise = std::max(run.largest_rise, now / first - 1.0);
    run.largest_fall = std::max(run.largest_fall, 1.0 - now / first);
    run.largest_regain = std::max(run.largest_regain, (now - least) / first);
    least = std::min(least, now), run.last = now / first;
    const auto& points = r.state.contacts.points;
    std::set<std::pair<Index, Index>> closed;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!points.open(i)) closed.emplace(points.corner_body[i], points.edge_body[i]);
    for (const auto& pair : closed) run.collisions += touching.count(pair) == 0 ? 1 : 0;
    touching = std::move(closed);
    return Wish::go_on;
  });
  return run;
}

TEST(BoxOfDiscs, KeepsItsEnergyOverTenThousandCollisions) {
  const BoxRun run = run_box(box_of_discs(0.0), 16.0, 0.0125);
  EXPECT_GE(run.collisions, 10000u);
  std::printf("E17 collisions %zu\n", run.collisions);
  expect_absolute("E17", "greatest gain of energy", 0.0, run.largest_rise, 1e-3);
  expect_absolute("E17", "greatest loss of energy", 0.0, run.largest_fall, 1e-3);
  expect_absolute("E17", "energy at the end", 1.0, run.last, 1e-3);
}

TEST(BoxOfDiscs, NeverGainsEnergyWithFriction) {
  for (const double friction : {0.2, 0.8}) {
    const BoxRun run = run_box(box_of_discs(friction), 2.0, 0.05);
    EXPECT_LT(run.last, 0.95);
    expect_absolute("E17", "mu=" + text(friction) + " greatest gain of energy", 0.0, run.largest_regain,
                    1e-3);
  }
}

// Blocks and discs thrown at each other, with friction: nothing outside holds them.
Scene cluster(double friction, double restitution) {
  Scene s = floating(friction, restitution);
  s.contact.point_stiffness = 1e7;
  for (int i = 0; i < 8; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 8;
    const Vec2 place = rotated({1.0 + 0.1 * (i % 3), 0.0}, angle);
    Body body = i % 2 == 0 ? disc(0.2, place) : scenes::block(0.2, 0.1, place, 0.3 * i);
    body.velocity = -2.0 * place + Vec2{0.3, 0.0};
    body.spin = 1.5 * i;
    s.bodies.push_back(body);
  }
  return s;
}

TEST(IsolatedCluster, KeepsItsMomenta) {
  for (const double friction : {0.0, 0.5}) {
    Running r(cluster(friction, friction == 0.0 ? 1.0 : 0.6));
    const Momenta before = momenta(r);
    r.run(run_for(1.0));
    Momenta now = momenta(r);
    expect_same_momenta("E17", "cluster mu=" + text(friction), before, now);
  }
}

}  // namespace
}  // namespace dougong::engine
