#include "engine/bonds/joints.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "engine/modes.h"
#include "tests/engine/reference.h"
#include "tests/oracles/oscillator.h"
#include "tests/oracles/pendulum.h"
#include "tests/scenes/running.h"

namespace dougong::engine {
namespace {

using scenes::angular_momentum;
using scenes::momentum;
using scenes::run_for;
using scenes::Running;
using testing::expect_relative;
using ::testing::HasSubstr;

constexpr double degree = std::numbers::pi / 180.0;

Terrain anchor() {
  Terrain t;
  t.name = "anchor";
  t.shape = make_rectangle(0.1, 0.1);
  t.position = {0.0, 0.0};
  return t;
}

Joint joint(JointKind kind, Owner a, Owner b, Vec2 at_a, Vec2 at_b, double stiffness) {
  Joint j;
  j.name = "joint";
  j.kind = kind;
  j.a = a, j.b = b;
  j.anchor_a = at_a, j.anchor_b = at_b;
  j.stiffness = stiffness;
  return j;
}

constexpr Owner ground{true, 0}, first{false, 0}, second{false, 1};

// Hung from its corner (-b, h) at the origin, turned by `release` from rest.
Scene pinned(const oracles::PinnedRectangle& c, double stiffness) {
  Scene s = scenes::scene(0.0);
  s.gravity.y = -c.g;
  const double angle = c.rest_angle() + c.release;
  s.bodies.push_back(scenes::block(c.b, c.h, rotated({c.b, -c.h}, angle), angle));
  s.terrains.push_back(anchor());
  s.joints.push_back(joint(JointKind::pin, ground, first, {}, {-c.b, c.h}, stiffness));
  return s;
}

// The period from the time between two passages through rest in the same direction.
double measured_period(Running& r, double rest, double longest) {
  double before = r.angle() - rest, time_before = 0.0, first_passage = -1.0, period = 0.0;
  DriveOptions options = run_for(longest, 1e-3, "rk4");
  r.run(options, [&](const Sample& s) {
    const double now = s.state.q()[2] - rest;
    if (before < 0.0 && now >= 0.0) {
      const double passage = time_before + (s.state.time - time_before) * before / (before - now);
      if (first_passage < 0.0)
        first_passage = passage;
      else
        period = passage - first_passage;
    }
    before = now, time_before = s.state.time;
    return period > 0.0 ? Wish::stop : Wish::go_on;
  });
  return period;
}

TEST(PinnedRectangle, SwingsWithItsPeriod) {
  for (const auto& c : {oracles::PinnedRectangle{0.3, 0.5, 9.81, 60.0 * degree},
                        oracles::PinnedRectangle{0.2, 0.2, 9.81, 2.0 * degree},
                        oracles::PinnedRectangle{0.6, 0.1, 3.7, 150.0 * degree}}) {
    Running r(pinned(c, 1e11));
    const double period = measured_period(r, c.rest_angle(), 4.0 * c.period());
    expect_relative("E16", "b=" + std::to_string(c.b) + " released at " + std::to_string(c.release),
                    c.period(), period, 1e-6);
  }
  EXPECT_NEAR((oracles::PinnedRectangle{0.3, 0.5, 9.81, 60.0 * degree}.period()), 1.898269391, 1e-9);
}

TEST(PinnedRectangle, KeepsItsEnergy) {
  Running r(pinned({0.3, 0.5, 9.81, 60.0 * degree}, 1e8));
  const Energies start = r.energies();
  double worst = 0.0;
  r.run(run_for(5.0), [&](const Sample& s) {
    worst = std::max(worst, std::abs(energies_of(r.model, s.state).balance() - start.balance()));
    return Wish::go_on;
  });
  EXPECT_LT(worst, 1e-5 * r.model.mass[0] * 9.81 * 0.58);
}

// The gravity-tangent stiffness of the hanging block gives the small period.
TEST(PinnedRectangle, HasItsSmallPeriodAsAMode) {
  const oracles::PinnedRectangle c{0.3, 0.5, 9.81, 0.0};
  Running r(pinned(c, 1e9));
  r.state.q()[1] -= r.model.mass[0] * 9.81 / 1e9;
  const auto modes = horizontal_modes(r.model, r.state);
  ASSERT_FALSE(modes.empty());
  expect_relative("E16", "small period from the tangent", c.small_period(), modes[0].period(), 1e-4);
}

TEST(Spring, OscillatesAsItsDashpotSays) {
  for (const double ratio : {0.0, 0.2}) {
    Scene s = scenes::scene(0.0);
    s.gravity = {};
    s.bodies.push_back(scenes::block(0.2, 0.2, {1.0, 0.0}));
    s.terrains.push_back(anchor());
    s.terrains[0].position = {-1.0, 0.0};
    s.joints.push_back(joint(JointKind::spring, ground, first, {}, {}, 4e4));
    s.joints[0].rest_length = 1.9;
    const double mass = 2400.0 * 0.16, w = std::sqrt(4e4 / mass);
    s.joints[0].damping = 2.0 * ratio * std::sqrt(4e4 * mass);
    Running r(s);
    DriveOptions options = run_for(0.5, 0.5, "rk4");
    options.step = 2e-4;
    r.run(options);
    const auto exact = oracles::damped_oscillator(w, 2.0 * ratio * w, 0.5);
    EXPECT_NEAR(r.position().x - 0.9, 0.1 * exact.x, 1e-8);
    EXPECT_NEAR(r.velocity().x, 0.1 * exact.v, 1e-6);
  }
}

TEST(Distance, KeepsTheLengthOfAPendulum) {
  Scene s = scenes::scene(0.0);
  Body bob;
  bob.name = "bob";
  bob.shape = make_circle(0.05);
  bob.position = {1.2, 0.0};
  bob.mass = 2.0;
  s.bodies.push_back(bob);
  s.terrains.push_back(anchor());
  s.joints.push_back(joint(JointKind::distance, ground, first, {}, {}, 1e7));
  Running r(s);
  double worst = 0.0;
  r.run(run_for(3.0), [&](const Sample&) {
    worst = std::max(worst, std::abs(norm(r.position()) - 1.2));
    return Wish::go_on;
  });
  EXPECT_LT(worst, 2e-5) << "three times the weight over the stiffness";
  EXPECT_GT(worst, 1e-6);
}

TEST(Weld, MakesTwoHalvesTurnAsOne) {
  Scene s;
  s.gravity = {};
  for (const double x : {-0.5, 0.5}) s.bodies.push_back(scenes::block(0.5, 0.2, {x, 0.0}));
  s.joints.push_back(joint(JointKind::weld, first, second, {0.5, 0.0}, {-0.5, 0.0}, 1e9));
  s.joints[0].rotational_stiffness = 1e8;
  s.joints[0].damping_ratio = 0.5;
  s.bodies[0].velocity.y = 1.0;  // momentum of half the whole, off its centre
  Running r(s);
  r.run(run_for(2.0));
  const double m = 2400.0 * 0.4, inertia = 2.0 * m * ((1.0 + 0.16) / 12.0 + 0.25);
  const double spin = -0.5 * m * 1.0 / inertia;
  EXPECT_NEAR(r.spin(0), spin, 1e-4);
  EXPECT_NEAR(r.spin(1), spin, 1e-4);
  EXPECT_NEAR(r.velocity(0).y + r.velocity(1).y, 1.0, 1e-12);
}

// Two halves that turn against each other, I w' = -2 (k_r phi + c_r w): c_r/k_r is c/k of the dashpot given.
TEST(Weld, DampsItsTurningToo) {
  constexpr double k = 1e6, turning_k = 1e4, c = 2e4, spin = 0.1, t = 0.3;
  Scene s;
  s.gravity = {};
  for (const double sense : {1.0, -1.0}) {
    s.bodies.push_back(scenes::block(0.5, 0.2, {0.0, 0.0}));
    s.bodies.back().spin = sense * spin;
  }
  s.joints.push_back(joint(JointKind::weld, first, second, {}, {}, k));
  s.joints[0].rotational_stiffness = turning_k, s.joints[0].damping = c;
  Running r(s);
  r.run(run_for(t, t, "rk4"));
  const double inertia = 0.5 * 2400.0 * 0.4 * (1.0 + 0.16) / 12.0;
  const double w = std::sqrt(turning_k / inertia), ratio = 0.5 * c * turning_k / k / (inertia * w);
  const double damped = w * std::sqrt(1.0 - ratio * ratio);
  const double expected =
      spin * std::exp(-ratio * w * t) * (std::cos(damped * t) - ratio * w / damped * std::sin(damped * t));
  EXPECT_NEAR(r.spin(0), expected, 1e-4 * spin);
  EXPECT_NEAR(r.spin(1), -expected, 1e-4 * spin);
}

// Action and reaction at one place: linear and angular momentum of a free chain stay, dashpots or not.
TEST(Joints, KeepMomentum) {
  Scene s;
  s.gravity = {};
  for (int i = 0; i < 4; ++i) {
    s.bodies.push_back(scenes::block(0.3, 0.1, {0.7 * i, 0.05 * i * i}, 0.2 * i));
    s.bodies.back().velocity = {0.4 * i, 1.0 - i};
    s.bodies.back().spin = 0.7 - 0.5 * i;
  }
  const JointKind kinds[] = {JointKind::pin, JointKind::weld, JointKind::spring};
  for (std::size_t i = 0; i < 3; ++i) {
    s.joints.push_back(joint(kinds[i], {false, i}, {false, i + 1}, {0.35, 0.0}, {-0.35, 0.0}, 1e6));
    s.joints.back().rotational_stiffness = 1e4;
    s.joints.back().damping_ratio = 0.3;
  }
  Running r(s);
  const Vec2 linear = momentum(r);
  const double angular = angular_momentum(r, {});
  DriveOptions options = run_for(2.0);
  options.step_fraction = 0.05;
  r.run(options);
  const double scale = r.model.mass[0] * 4.0;
  EXPECT_NEAR(norm(momentum(r) - linear), 0.0, 1e-10 * scale);
  EXPECT_NEAR(angular_momentum(r, {}), angular, 1e-10 * scale);
  const double start = Running(s).energies().balance();
  EXPECT_NEAR(r.energies().balance(), start, 1e-3 * start);
  EXPECT_GT(r.energies().damping, 0.1 * start);
}

TEST(Joints, OfPinnedBodiesSwitchOffTheirContact) {
  Scene s;
  s.gravity = {};
  s.bodies.push_back(scenes::block(0.5, 0.1, {0.0, 0.0}));
  s.bodies.push_back(scenes::block(0.5, 0.1, {0.8, 0.0}));
  s.joints.push_back(joint(JointKind::pin, first, second, {0.4, 0.0}, {-0.4, 0.0}, 1e7));
  Running r(s);
  r.run(run_for(0.5));
  EXPECT_NEAR(norm(r.velocity(0)), 0.0, 1e-12);
  s.joints[0].kind = JointKind::spring;
  Running pushed(s);
  pushed.run(run_for(0.1));
  EXPECT_GT(norm(pushed.velocity(0)), 0.1) << "a spring does not";
}

TEST(Joints, RefuseWhatMakesNoSense) {
  const auto refused = [](auto change) {
    Scene s;
    s.bodies.push_back(scenes::block(0.5, 0.1, {0.0, 0.0}));
    s.bodies.push_back(scenes::block(0.5, 0.1, {1.0, 0.0}));
    s.joints.push_back(joint(JointKind::pin, first, second, {0.5, 0.0}, {-0.5, 0.0}, 1e7));
    change(s.joints[0]);
    return scenes::refusal_of(s);
  };
  EXPECT_EQ(refused([](Joint&) {}), "accepted");
  EXPECT_THAT(refused([](Joint& j) { j.b.index = 5; }), HasSubstr("joint: there is no body number 5"));
  EXPECT_THAT(refused([](Joint& j) { j.b = j.a; }), HasSubstr("with itself"));
  EXPECT_THAT(refused([](Joint& j) { j.stiffness = 0.0; }), HasSubstr("stiffness must be positive"));
  EXPECT_THAT(refused([](Joint& j) { j.kind = JointKind::weld; }), HasSubstr("rotational stiffness"));
  EXPECT_THAT(refused([](Joint& j) { j.damping = -1.0; }), HasSubstr("damping"));
  EXPECT_THAT(refused([](Joint& j) { j.rest_length = -1.0; }), HasSubstr("rest length"));
}

}  // namespace
}  // namespace dougong::engine
