// Validation cases E03, E06, E14, S01 and S04: blocks that rest, slide and tip.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/integrators/table.h"
#include "engine/settle.h"
#include "tests/engine/reference.h"
#include "tests/oracles/incline.h"
#include "tests/oracles/ledge.h"
#include "tests/oracles/sliding.h"
#include "tests/oracles/statics.h"
#include "tests/scenes/running.h"

namespace dougong::engine {
namespace {

using scenes::run_for;
using scenes::Running;
using testing::expect_absolute;
using testing::expect_relative;
using testing::text;

constexpr double degree = std::numbers::pi / 180.0;

// The block lies in contact equilibrium: each corner sunk by its share of the weight.
Scene block_on_incline(const oracles::Incline& c, double young_modulus) {
  Scene s = scenes::scene(c.friction, young_modulus);
  s.gravity.y = -c.g;
  s.terrains.push_back(scenes::ground(200.0, {}, -c.slope));
  const double k = young_modulus / c.h * c.b, weight = 2400.0 * 4.0 * c.b * c.h * c.g;
  const double uphill = c.uphill_share() * weight * std::cos(c.slope) / k;
  const double downhill = (1.0 - c.uphill_share()) * weight * std::cos(c.slope) / k;
  const Vec2 centre = rotated({0.0, c.h - 0.5 * (uphill + downhill)}, -c.slope);
  s.bodies.push_back(scenes::block(c.b, c.h, centre, -c.slope - (downhill - uphill) / (2.0 * c.b)));
  return s;
}

// The springs of the faces hold the friction from the start: the uphill corner as much as it can up to
// a half, the downhill one the rest.
void load_friction(Running& r, const oracles::Incline& c) {
  scenes::touch(r);
  const double weight = r.model.mass[0] * c.g, friction = c.friction_over_weight() * weight;
  const double uphill = std::min(0.5 * friction, c.friction * c.uphill_share() * weight * std::cos(c.slope));
  const Vec2 slip =
      ((friction - uphill) / r.state.contacts.points.stiffness(0).tangential) * rotated({1, 0}, -c.slope);
  r.state.q()[0] += slip.x, r.state.q()[1] += slip.y;
}

void check_incline(const oracles::Incline& c) {
  const std::string name = "mu=" + text(c.friction) + " slope=" + text(c.slope / degree);
  Running r(block_on_incline(c, 30e9));
  load_friction(r, c);
  const Vec2 start = r.position(), down = rotated({1.0, 0.0}, -c.slope);
  r.run(run_for(1.0));
  const double slid = dot(r.position() - start, down);
  if (c.sticks())
    expect_absolute("E03", name + " creep", 0.0, slid, 1e-5);
  else
    expect_relative("E03", name + " slid", c.slid(1.0), slid, 0.005);

  double friction = 0.0, normal = 0.0, uphill = 0.0;
  for (const auto& f : scenes::point_forces(r.model, r.state)) {
    friction += std::abs(f.tangential), normal += f.normal;
    if (dot(f.place + r.model.origin - r.position(), down) < 0.0) uphill += f.normal;
  }
  const double weight = r.model.mass[0] * c.g;
  expect_relative("E03", name + " friction/W", c.friction_over_weight(), friction / weight, 0.005);
  expect_relative("E03", name + " uphill share", c.uphill_share(), uphill / normal, 0.005);
  if (!c.sticks()) return;
  r.run(run_for(4.0));
  expect_absolute("E03", name + " creep in 4 s more", 0.0, dot(r.position() - start, down) - slid, 1e-6);
}

TEST(BlockOnAnIncline, SlidesOrSticksAsCoulombSays) {
  for (const double mu : {0.2, 0.4, 0.46, 0.47, 0.6}) check_incline({25.0 * degree, mu, 0.5, 0.2, 9.81});
}

TEST(BlockOnAnIncline, DoesSoOnOtherSlopesToo) {
  check_incline({10.0 * degree, 0.1, 0.3, 0.05, 9.81});
  check_incline({10.0 * degree, 0.18, 0.3, 0.05, 9.81});
  check_incline({40.0 * degree, 0.5, 0.6, 0.1, 3.7});
}

Scene block_on_ledge(const oracles::Ledge& c, double friction) {
  Scene s = scenes::scene(friction);
  s.gravity.y = -c.g;
  Terrain ledge = scenes::ground(20.0);
  ledge.position.x = -10.0;  // its edge at x = 0
  s.terrains.push_back(ledge);
  s.bodies.push_back(scenes::block(c.b, c.h, {c.d, c.h}));
  return s;
}

void check_ledge(const oracles::Ledge& c, double friction) {
  Running r(block_on_ledge(c, friction));
  const double targets[] = {5.0, 10.0, 20.0};
  std::size_t next = 0;
  double last_angle = 0.0, last_time = 0.0, last_spin = 0.0;
  r.run(run_for(0.6, 1e-3), [&](const Sample& sample) {
    const double angle = -r.angle(), time = sample.state.time, spin = -r.spin();
    if (next < 3 && angle >= targets[next] * degree) {
      const double part = (targets[next] * degree - last_angle) / (angle - last_angle);
      const std::string name = "d=" + text(c.d) + " " + text(targets[next]) + " deg ";
      expect_relative("E06", name + "t", c.time_to(targets[next] * degree),
                      last_time + part * (time - last_time), 0.01);
      expect_relative("E06", name + "omega", c.spin(targets[next] * degree),
                      last_spin + part * (spin - last_spin), 0.01);
      ++next;
    }
    last_angle = angle, last_time = time, last_spin = spin;
    return next == 3 ? Wish::stop : Wish::go_on;
  });
  EXPECT_EQ(next, 3u) << "did not tip";
}

TEST(BlockOnALedge, TipsAboutTheEdge) {
  const oracles::Ledge c{0.5, 0.1, 0.05, 9.81};
  expect_relative("E06", "oracle t 20 deg", 0.35731, c.time_to(20.0 * degree), 1e-5);
  check_ledge(c, 0.7);
  check_ledge({0.4, 0.15, 0.1, 9.81}, 0.9);
}

TEST(BlockOnALedge, StaysWithItsCentreInside) {
  for (const double d : {-0.05, -0.01}) {
    Running r(block_on_ledge({0.5, 0.1, d, 9.81}, 0.7));
    r.run(run_for(2.0));
    expect_absolute("E06", "d=" + text(d) + " angle after 2 s", 0.0, r.angle(), 1e-4);
    EXPECT_LT(std::abs(r.spin()), 1e-9);
  }
}

Scene resting_block(const oracles::RestingBlock& c, double b, double h) {
  Scene s = scenes::scene(0.6, 30e9, 0.0);
  s.gravity.y = -c.g;
  s.contact.point_stiffness = c.stiffness;
  s.contact.tangential_ratio = 1e-6;
  s.bodies.push_back(scenes::block(b, h, {0.0, h - c.penetration()}));
  s.bodies[0].mass = c.mass;
  s.terrains.push_back(scenes::ground());
  return s;
}

void check_resting(const oracles::RestingBlock& c) {
  const double b = 0.25, h = 0.5;  // tall: its rocking is slower than its bouncing
  Running r(resting_block(c, b, h));
  expect_relative("E14", "critical step velocity-verlet", c.verlet_step(),
                  plan_steps(r.model, r.state, run_for(0.1)).bound, 1e-5);
  expect_relative("E14", "critical step rk4", c.rk4_step(),
                  plan_steps(r.model, r.state, run_for(0.1, 0.01, "rk4")).bound, 1e-5);
  r.run(run_for(0.5));
  double reaction = 0.0;
  for (const auto& f : scenes::point_forces(r.model, r.state)) reaction += f.normal;
  expect_relative("E14", "penetration", c.penetration(), h - r.position().y, 1e-9);
  expect_relative("E14", "reaction", c.reaction(), reaction, 1e-9);
}

TEST(RestingBlock, SinksByItsWeightAndHasItsCriticalStep) {
  check_resting({1000.0, 1e8, 9.81});
  check_resting({70.0, 3e6, 9.81});
}

// With springs along the faces too, sway and rocking are coupled and Gershgorin's bound is not exact.
TEST(RestingBlock, HasASafeStepWithTangentialSpringsToo) {
  const oracles::RestingBlock c{1000.0, 1e8, 9.81};
  Scene s = resting_block(c, 0.25, 0.5);
  s.contact.tangential_ratio.reset();
  const Running r(s);
  const double bound = plan_steps(r.model, r.state, run_for(0.1)).bound;
  EXPECT_LT(bound, c.verlet_step());
  EXPECT_GT(bound, 0.6 * c.verlet_step());
  std::printf("E14 with tangential springs: bound over vertical critical step %.4f\n",
              bound / c.verlet_step());
}

Scene sliding_block(double friction, std::shared_ptr<const PrescribedMotion> motion) {
  Scene s = scenes::block_on_ground(0.5, 0.05, friction);
  s.bodies[0].position.y -= 0.05 * 2400.0 * 0.1 * 9.81 / (30e9);  // h W / (2 b E): in equilibrium
  s.terrains[0].motion = std::move(motion);
  return s;
}

void check_harmonic(double amplitude, double frequency, double friction, int cycles,
                    double residual_tolerance, const std::string& integrator = "velocity-verlet") {
  const double w = 2.0 * std::numbers::pi * frequency, a = amplitude * 9.81;
  const auto displacement = [=](double t) { return a / w * (t - std::sin(w * t) / w); };
  Running r(sliding_block(
      friction,
      scenes::horizontal_motion([=](double t) { return a * std::sin(w * t); },
                                [=](double t) { return a / w * (1 - std::cos(w * t)); }, displacement)));
  const oracles::HarmonicSlider exact(a, w, friction * 9.81, cycles / frequency);
  const double limit = friction * r.model.mass[0] * 9.81;
  double first_slip = 0.0, low = 0.0, high = 0.0, path = 0.0, last = 0.0;
  std::vector<double> at_cycle_ends;
  const double interval = 2e-4 / frequency;
  std::size_t count = 0;
  r.run(run_for(cycles / frequency, interval, integrator), [&](const Sample& sample) {
    const double t = sample.state.time, u = r.position().x - displacement(t);
    if (first_slip == 0.0 && std::abs(sample.terrain_reaction.x) > 0.99999 * limit) first_slip = t;
    low = std::min(low, u), high = std::max(high, u), path += std::abs(u - last), last = u;
    if (count > 0 && count % 5000 == 0) at_cycle_ends.push_back(u);
    ++count;
    return Wish::go_on;
  });
  const std::string name =
      integrator + " A=" + text(amplitude) + "g f=" + text(frequency) + " mu=" + text(friction) + " ";
  expect_relative("S01", name + "first slip", exact.first_slip(), first_slip, 0.01);
  ASSERT_EQ(at_cycle_ends.size(), static_cast<std::size_t>(cycles));
  for (int i = 1; i <= cycles; ++i)
    expect_relative("S01", name + "end of cycle " + std::to_string(i), exact.displacement(i / frequency),
                    at_cycle_ends[static_cast<std::size_t>(i - 1)], residual_tolerance);
  expect_relative("S01", name + "range", exact.range(), high - low, 0.01);
  expect_relative("S01", name + "path", exact.path(), path, 0.01);
}

TEST(HarmonicSliding, IsTheReference) {
  const oracles::HarmonicSlider exact(0.5 * 9.81, 4.0 * std::numbers::pi, 0.3 * 9.81, 2.5);
  expect_relative("S01", "oracle: first slip", 0.0512082, exact.first_slip(), 1e-6);
  for (int i = 1; i <= 5; ++i)
    expect_relative("S01", "oracle: end of cycle", -0.001927, exact.displacement(0.5 * i), 3e-4);
  check_harmonic(0.5, 2.0, 0.3, 5, 0.01);
}
// Every slip ends, and turns back, where the sub-steps end: none leaves an anchor behind.
TEST(HarmonicSliding, IsTheReferenceByAdaptiveStepsToo) {
  check_harmonic(0.5, 2.0, 0.3, 2, 0.01, "dormand-prince");
  check_harmonic(0.5, 2.0, 0.3, 1, 0.01, "rk8");
}
TEST(HarmonicSliding, IsTheReferenceForOtherGroundsToo) {
  check_harmonic(0.6, 1.0, 0.2, 2, 0.01);
}

void check_pulse(const oracles::PulseSlider& c) {
  const double a = c.amplitude, d = c.duration;
  const auto displacement = [=](double t) { return t < d ? 0.5 * a * t * t : a * d * (t - 0.5 * d); };
  Running r(
      sliding_block(c.friction_acceleration / 9.81,
                    scenes::horizontal_motion([=](double t) { return t < d ? a : 0.0; },
                                              [=](double t) { return a * std::min(t, d); }, displacement)));
  double stopped = 0.0;
  r.run(run_for(1.2 * c.stops_at(), 1e-3), [&](const Sample& sample) {
    const double ground = a * std::min(sample.state.time, d);
    if (stopped == 0.0 && sample.state.time > d && ground - r.velocity().x < 1e-4 * ground)
      stopped = sample.state.time;
    return Wish::go_on;
  });
  const std::string name = "A=" + text(a / 9.81) + "g T=" + text(d) + " ";
  expect_relative("S04", name + "slid", c.slid(), displacement(r.state.time) - r.position().x, 0.02);
  expect_relative("S04", name + "stops at", c.stops_at(), stopped, 0.02);
}

TEST(PulseSliding, IsNewmarks) {
  const oracles::PulseSlider reference{0.6 * 9.81, 0.3, 0.2 * 9.81};
  expect_relative("S04", "oracle: slid", 0.52974, reference.slid(), 1e-5);
  check_pulse(reference);
  check_pulse({0.4 * 9.81, 0.2, 0.3 * 9.81});
}

}  // namespace
}  // namespace dougong::engine
