// The cases of blocks and balls (E03, E04, E06b, E11, E17, R01, R07, S01, S04, X02, X05, X12) with rigid
// contacts: moreau-jean.
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "tests/engine/reference.h"
#include "tests/oracles/bouncing_ball.h"
#include "tests/oracles/collisions.h"
#include "tests/oracles/incline.h"
#include "tests/oracles/sliding.h"
#include "tests/oracles/statics.h"
#include "tests/scenes/discs.h"
#include "tests/scenes/rocking.h"

namespace dougong::engine {
namespace {

using scenes::disc;
using scenes::greatest_drift;
using scenes::Running;
using testing::expect_absolute;
using testing::expect_relative;
using ::testing::HasSubstr;
using testing::text;

// A restitution of 2.5e-7.
constexpr double plastic = 1e3;

DriveOptions rigid(double end_time, double step, double output_interval = 0.01) {
  DriveOptions options = scenes::run_for(end_time, output_interval, "moreau-jean");
  options.step = step;
  return options;
}

std::string step_text(double step) {
  return "h=" + text(1e3 * step) + " ms ";
}

struct RockingErrors {
  double time = 0.0, amplitude = 0.0;  // relative, the worst
};

RockingErrors rocking_errors(const oracles::RockingBlock& c, std::size_t count, double damping_ratio,
                             double step) {
  const auto exact = c.impacts(0.5 * c.alpha(), static_cast<int>(count));
  Running r(scenes::tilted_block(c, 0.5 * c.alpha(), 30e9, damping_ratio));
  const auto measured =
      scenes::measured_impacts(r, rigid(exact.back().time + 1.0, step, std::max(5e-4, step)), count);
  RockingErrors worst;
  EXPECT_EQ(measured.size(), count);
  for (std::size_t i = 0; i < measured.size(); ++i) {
    worst.time = std::max(worst.time, std::abs(measured[i].time / exact[i].time - 1.0));
    worst.amplitude =
        std::max(worst.amplitude, std::abs(measured[i].amplitude_after / exact[i].amplitude_after - 1.0));
  }
  const std::string name =
      "b=" + text(c.b) + " h=" + text(c.h) + " xi=" + text(damping_ratio) + " " + step_text(step);
  std::printf("R01 moreau-jean %s worst time %.2e worst amplitude %.2e\n", name.c_str(), worst.time,
              worst.amplitude);
  return worst;
}

// Of the first order in the step: a hundredth of it errs by less than a thirtieth.
void check_rocking(const oracles::RockingBlock& c, std::size_t count, double damping_ratio) {
  const RockingErrors coarse = rocking_errors(c, count, damping_ratio, 1e-3);
  const RockingErrors fine = rocking_errors(c, count, damping_ratio, 1e-5);
  EXPECT_LT(coarse.time, 0.02);
  EXPECT_LT(fine.time, coarse.time / 30.0);
  EXPECT_LT(fine.time, 1e-4);
  EXPECT_LT(fine.amplitude, 5e-4);
}

TEST(RigidRockingBlock, TendsToHousnerWithItsStep) {
  check_rocking({0.25, 1.0, 9.81}, 8, plastic);
}
TEST(RigidRockingBlock, DoesSoWithTheDefaultMaterial) {
  check_rocking({0.25, 1.0, 9.81}, 8, 1.0);
}
TEST(RigidRockingBlock, DoesSoWithOtherProportionsToo) {
  check_rocking({0.2, 0.6, 9.81}, 4, plastic);
}

void check_incline(const oracles::Incline& c, double step) {
  const std::string name =
      "mu=" + text(c.friction) + " slope=" + text(c.slope * 180.0 / std::numbers::pi) + " ";
  Scene s = scenes::scene(c.friction);
  s.gravity.y = -c.g;
  s.terrains.push_back(scenes::ground(200.0, {}, -c.slope));
  s.bodies.push_back(scenes::block(c.b, c.h, rotated({0.0, c.h}, -c.slope), -c.slope));
  Running r(s);
  const Vec2 start = r.position(), down = rotated({1.0, 0.0}, -c.slope);
  double friction = 0.0;
  const auto slid = [&] { return dot(r.position() - start, down); };
  r.run(rigid(1.0, step), [&](const Sample& sample) {
    friction = std::abs(dot(sample.terrain_reaction, down)) / (r.model.mass[0] * c.g);
    return Wish::go_on;
  });
  if (c.sticks())
    expect_absolute("E03", "moreau-jean " + name + "creep", 0.0, slid(), 1e-9);
  else
    expect_relative("E03", "moreau-jean " + name + "slid", c.slid(1.0), slid(), 1e-5);
  expect_relative("E03", "moreau-jean " + name + "friction/W", c.friction_over_weight(), friction, 1e-4);
}

TEST(RigidBlockOnAnIncline, SlidesOrSticksAsCoulombSays) {
  for (const double mu : {0.2, 0.4, 0.46, 0.47, 0.6})
    check_incline({25.0 * std::numbers::pi / 180.0, mu, 0.5, 0.2, 9.81}, 1e-3);
}
TEST(RigidBlockOnAnIncline, DoesSoOnOtherSlopesToo) {
  check_incline({10.0 * std::numbers::pi / 180.0, 0.1, 0.3, 0.05, 9.81}, 2e-3);
  check_incline({10.0 * std::numbers::pi / 180.0, 0.18, 0.3, 0.05, 9.81}, 2e-3);
}

// Impacts lie in the middle of the steps that hold them: outputs as long as steps.
void check_bouncing(const oracles::BouncingBall& c, double radius, double step) {
  Scene s = scenes::scene(0.6, 30e9, damping_ratio_for_restitution(c.restitution));
  s.gravity.y = -c.g;
  s.bodies.push_back(disc(radius, {0.0, radius + c.clearance}));
  s.terrains.push_back(scenes::ground());
  Running r(s);
  std::vector<double> times;
  double last_speed = 0.0, rest = 0.0;
  r.run(rigid(c.rest_time() + 0.3, step, step), [&](const Sample& sample) {
    const double speed = r.velocity().y;
    if (last_speed < 0.0 && speed > 0.0) times.push_back(sample.state.time - 0.5 * step);
    if (r.position().y - radius > 1e-7) rest = sample.state.time;
    last_speed = speed;
    return Wish::go_on;
  });
  const std::string name = "moreau-jean e=" + text(c.restitution) + " " + step_text(step);
  ASSERT_GE(times.size(), 6u);
  for (int n = 0; n < 6; ++n)
    expect_relative("E04", name + "impact " + std::to_string(n + 1) + " t", c.impact_time(n),
                    times[static_cast<std::size_t>(n)], 1e-3);
  expect_relative("E04", name + "rests at", c.rest_time(), rest, 0.01);
  expect_absolute("E04", name + "speed at rest", 0.0, norm(r.velocity()), 1e-8);
  expect_absolute("E04", name + "gap at rest", 0.0, r.position().y - radius, 1e-9);
}

TEST(RigidBouncingBall, ImpactsAndComesToRestAsItsRestitutionSays) {
  check_bouncing({1.0, 0.7, 9.81}, 0.1, 1e-4);
}
TEST(RigidBouncingBall, DoesSoForOtherBallsToo) {
  check_bouncing({2.0, 0.6, 9.81}, 0.2, 1e-4);
}

Body thrown(Body body, double mass, oracles::Vector velocity) {
  body.mass = mass;
  body.velocity = {velocity.x, velocity.y};
  return body;
}

Scene floating(double friction, double restitution) {
  Scene s =
      scenes::scene(friction, 30e9, restitution == 1.0 ? 0.0 : damping_ratio_for_restitution(restitution));
  s.gravity = {};
  return s;
}

// Momenta over the same without signs.
void expect_kept_momenta(const std::string& name, const Running& before, const Running& after) {
  double turnover = 0.0;
  for (std::size_t i = 0; i < before.bodies(); ++i)
    turnover += before.model.mass[i] * norm(before.velocity(i)) * (1.0 + norm(before.position(i)));
  expect_absolute("E11", name + " linear momentum", 0.0, norm(momentum(after) - momentum(before)) / turnover,
                  1e-10);
  expect_absolute("E11", name + " angular momentum", 0.0,
                  std::abs(angular_momentum(after, {}) - angular_momentum(before, {})) / turnover, 1e-10);
}

void check_discs(const std::string& name, const oracles::DiscImpact& c) {
  Scene s = floating(0.0, c.restitution);
  const Vec2 n = rotated({1.0, 0.0}, c.direction);
  s.bodies = {thrown(disc(0.2, {}), c.mass1, c.velocity1),
              thrown(disc(0.3, 0.501 * n), c.mass2, c.velocity2)};
  Running r(s);
  const Running start = r;
  r.run(rigid(0.01, 1e-4));
  const auto exact = c.after();
  expect_absolute("E11", name + " v1.x", exact.first.x, r.velocity(0).x, 1e-6);
  expect_absolute("E11", name + " v1.y", exact.first.y, r.velocity(0).y, 1e-6);
  expect_absolute("E11", name + " v2.x", exact.second.x, r.velocity(1).x, 1e-6);
  expect_absolute("E11", name + " v2.y", exact.second.y, r.velocity(1).y, 1e-6);
  expect_kept_momenta(name, start, r);
}

// The normal turns a little between the discs' start and their impact.
TEST(RigidCollision, OfTwoDiscsIsNewtons) {
  check_discs("moreau-jean (a)", {1.0, 2.5, {3.0, 0.0}, {-1.0, 0.0}, 0.0, 0.8});
  check_discs("moreau-jean (c)", {1.0, 1e6, {1.0, 0.0}, {0.0, 0.0}, 0.0, 1.0});
}

void check_rod(const std::string& name, const oracles::RodImpact& c) {
  Scene s = floating(0.0, c.restitution);
  s.bodies = {thrown(scenes::block(0.5 * c.length, 0.5 * c.depth, {}), c.rod_mass, {0.0, 0.0}),
              thrown(disc(0.05, {-c.arm, 0.5 * c.depth + 0.0501}), c.disc_mass, {0.0, -c.speed})};
  Running r(s);
  const Running start = r;
  r.run(rigid(0.001, 1e-5, 1e-3));
  expect_relative("E11", name + " disc", c.disc_speed(), -r.velocity(1).y, 1e-6);
  expect_relative("E11", name + " rod", c.rod_speed(), -r.velocity(0).y, 1e-6);
  expect_relative("E11", name + " rod's spin", c.rod_spin(), r.spin(0), 1e-6);
  expect_kept_momenta(name, start, r);
}

TEST(RigidCollision, OfADiscAndAFreeRodTurnsIt) {
  check_rod("moreau-jean (b)", {1.0, 4.0, 2.0, 0.1, 0.7, 3.0, 0.8});
  check_rod("moreau-jean (b) second", {3.0, 2.0, 1.2, 0.2, 0.25, 1.0, 0.3});
}

// Blocks and discs thrown at each other with spin and friction.
Scene cluster(double friction, double restitution) {
  Scene s = floating(friction, restitution);
  for (int i = 0; i < 8; ++i) {
    const Vec2 place = rotated({1.0 + 0.1 * (i % 3), 0.0}, 2.0 * std::numbers::pi * i / 8);
    Body body = i % 2 == 0 ? disc(0.2, place) : scenes::block(0.2, 0.1, place, 0.3 * i);
    body.velocity = -2.0 * place + Vec2{0.3, 0.0};
    body.spin = 1.5 * i;
    s.bodies.push_back(body);
  }
  return s;
}

TEST(RigidCluster, KeepsItsMomentaAndNeverGainsEnergy) {
  for (const double friction : {0.0, 0.5})
    for (const double restitution : {1.0, 0.6}) {
      Running r(cluster(friction, restitution));
      const Running start = r;
      const double first = r.energies().kinetic;
      double least = first, regained = 0.0;
      const RunOutcome run = r.run(rigid(1.0, 1e-3), [&](const Sample&) {
        const double now = r.energies().kinetic;
        regained = std::max(regained, (now - least) / first), least = std::min(least, now);
        return Wish::go_on;
      });
      EXPECT_EQ(run.outcome, Outcome::completed) << run.detail;
      const std::string name = "moreau-jean mu=" + text(friction) + " e=" + text(restitution);
      expect_kept_momenta(name, start, r);
      expect_absolute("E17", name + " energy regained", 0.0, regained, 1e-3);
      if (friction > 0.0 || restitution < 1.0) {
        EXPECT_LT(least, 0.9 * first);
      }
    }
}

std::shared_ptr<const PrescribedMotion> sine(double a, double frequency) {
  const double w = 2.0 * std::numbers::pi * frequency;
  return scenes::horizontal_motion([=](double t) { return a * std::sin(w * t); },
                                   [=](double t) { return a / w * (1 - std::cos(w * t)); },
                                   [=](double t) { return a / w * (t - std::sin(w * t) / w); });
}

void check_harmonic(double amplitude, double frequency, double friction, double step) {
  const double w = 2.0 * std::numbers::pi * frequency, a = amplitude * 9.81;
  Scene s = scenes::block_on_ground(0.5, 0.05, friction);
  s.terrains[0].motion = sine(a, frequency);
  Running r(s);
  const oracles::HarmonicSlider exact(a, w, friction * 9.81, 2.0 / frequency);
  double low = 0.0, high = 0.0, path = 0.0, last = 0.0;
  r.run(rigid(2.0 / frequency, step, step), [&](const Sample& sample) {
    const double u = r.position().x - s.terrains[0].motion->at(sample.state.time).displacement.x;
    low = std::min(low, u), high = std::max(high, u), path += std::abs(u - last), last = u;
    return Wish::go_on;
  });
  const std::string name =
      "moreau-jean A=" + text(amplitude) + "g mu=" + text(friction) + " " + step_text(step);
  expect_relative("S01", name + "end", exact.displacement(2.0 / frequency), last, 0.01);
  expect_relative("S01", name + "range", exact.range(), high - low, 1e-3);
  expect_relative("S01", name + "path", exact.path(), path, 1e-3);
}

TEST(RigidHarmonicSliding, IsTheReference) {
  check_harmonic(0.5, 2.0, 0.3, 5e-4);
  check_harmonic(0.6, 1.0, 0.2, 5e-4);
}

void check_pulse(const oracles::PulseSlider& c, double step) {
  const double a = c.amplitude, d = c.duration;
  const auto displacement = [=](double t) { return t < d ? 0.5 * a * t * t : a * d * (t - 0.5 * d); };
  Scene s = scenes::block_on_ground(0.5, 0.05, c.friction_acceleration / 9.81);
  s.terrains[0].motion = scenes::horizontal_motion(
      [=](double t) { return t < d ? a : 0.0; }, [=](double t) { return a * std::min(t, d); }, displacement);
  Running r(s);
  r.run(rigid(1.2 * c.stops_at(), step));
  expect_relative("S04", "moreau-jean " + step_text(step) + "slid", c.slid(),
                  displacement(r.state.time) - r.position().x, 5e-3);
}

TEST(RigidPulseSliding, IsNewmarks) {
  check_pulse({0.6 * 9.81, 0.3, 0.2 * 9.81}, 1e-3);
  check_pulse({0.4 * 9.81, 0.2, 0.3 * 9.81}, 1e-3);
}

// No springs, so nothing has to settle: the load is there from the start.
void check_toppling(const oracles::Stack& c, bool by_acceleration) {
  const double alpha = c.toppling_tilt(), p = std::sqrt(0.75 * 9.81 / std::hypot(c.b, c.count * c.h));
  const double threshold = by_acceleration ? c.toppling_acceleration(1.0) : alpha;
  for (const double part : {0.995, 1.005}) {
    Running r(scenes::column(c.count, c.b, c.h, 0.7));
    r.model.gravity =
        by_acceleration ? Vec2{9.81 * part * threshold, -9.81} : rotated({0.0, -9.81}, part * threshold);
    bool toppled = false;
    const RunOutcome run = r.run(rigid(1.3 * std::acosh(200.0) / p, 1e-3), [&](const Sample&) {
      for (std::size_t k = 0; k < r.bodies(); ++k) toppled |= std::abs(r.angle(k)) > 0.5 * alpha;
      return toppled ? Wish::stop : Wish::go_on;
    });
    EXPECT_NE(run.outcome, Outcome::diverged) << run.detail;
    EXPECT_EQ(toppled, part > 1.0) << "n=" << c.count << " " << part;
    if (part < 1.0) {
      for (std::size_t k = 0; k < r.bodies(); ++k) EXPECT_LT(std::abs(r.angle(k)), 1e-9);
    }
  }
  std::printf("R07 moreau-jean b=%g h=%g n=%d %s %.6g stands at 0.995, falls at 1.005 of it\n", c.b, c.h,
              c.count, by_acceleration ? "a/g" : "tilt", threshold);
}

TEST(RigidStackOfBlocks, TopplesAtItsThresholds) {
  for (const int n : {1, 3})
    for (const bool by_acceleration : {true, false}) check_toppling({0.25, 1.0, n}, by_acceleration);
}
TEST(RigidStackOfBlocks, TopplesAtItsThresholdsWithOtherProportionsToo) {
  for (const bool by_acceleration : {true, false}) check_toppling({0.4, 0.8, 2}, by_acceleration);
}

Scene overhanging_stack(int count, double length, double height, double part) {
  Scene s = scenes::scene(0.7);
  s.terrains.push_back(scenes::ground(20.0));
  s.terrains[0].position.x = -10.0;
  double right = 0.0;
  for (int k = count; k >= 1; --k) {
    right += part * oracles::overhang_limit(length, k);
    s.bodies.push_back(
        scenes::block(0.5 * length, 0.5 * height, {right - 0.5 * length, (count - k + 0.5) * height}));
  }
  return s;
}

void check_overhang(int count, double length, double height, double duration) {
  const std::string name = "moreau-jean " + std::to_string(count) + " blocks ";
  Running stands(overhanging_stack(count, length, height, 0.99));
  const Running start = stands;
  const RunOutcome run = stands.run(rigid(duration, 1e-3, 1.0));
  EXPECT_EQ(run.outcome, Outcome::completed) << run.detail;
  expect_absolute("E06b", name + "drift in " + text(duration) + " s at 0.99", 0.0,
                  greatest_drift(stands, start), 1e-9);
  Running falls(overhanging_stack(count, length, height, 1.01));
  const Running before = falls;
  falls.run(rigid(4.0, 1e-3), [&](const Sample&) {
    return greatest_drift(falls, before) > 0.1 * length ? Wish::stop : Wish::go_on;
  });
  EXPECT_GT(greatest_drift(falls, before), 0.1 * length);
}

TEST(RigidHarmonicOverhang, StandsJustInsideItsLimitAndTopplesJustOutside) {
  check_overhang(8, 1.0, 0.2, 60.0);
}
TEST(RigidHarmonicOverhang, DoesSoWithOtherBlocksToo) {
  check_overhang(5, 0.6, 0.1, 60.0);
}

TEST(RigidStackOfBlocks, NeitherSinksNorCreepsInAnHour) {
  Running r(scenes::column(3, 0.25, 0.5, 0.6));
  const Running start = r;
  const RunOutcome run = r.run(rigid(3600.0, 0.01, 10.0));
  EXPECT_EQ(run.outcome, Outcome::completed) << run.detail;
  expect_absolute("X12", "moreau-jean drift of a stack of 3 in an hour", 0.0, greatest_drift(r, start), 1e-9);
}

void check_wall(double amplitude, double duration) {
  Scene s = scenes::wall(6, 8, 0.6);
  if (amplitude > 0.0) s.terrains[0].motion = sine(amplitude * 9.81, 2.0);
  Running r(s);
  const Running start = r;
  const RunOutcome run = r.run(rigid(duration, 1e-3));
  EXPECT_EQ(run.outcome, Outcome::completed) << run.detail;
  double drift = 0.0;
  const Vec2 way = s.terrains[0].motion ? s.terrains[0].motion->at(r.state.time).displacement : Vec2{};
  for (std::size_t i = 0; i < r.bodies(); ++i)
    drift = std::max(drift, norm(r.position(i) - start.position(i) - way));
  std::printf("wall 6 x 8 at %g g: %.1f iterations a step, worst residual %.1e of the speed\n", amplitude,
              static_cast<double>(run.impulses.iterations) / static_cast<double>(run.impulses.solves),
              run.impulses.worst_residual);
  expect_absolute("X05", "moreau-jean wall 6 x 8 at " + text(amplitude) + " g: drift", 0.0, drift, 1e-8);
}

TEST(RigidWall, DoesNotCreepAtRest) {
  check_wall(0.0, 10.0);
}
// After whole periods.
TEST(RigidWall, DoesNotCreepBelowItsFriction) {
  check_wall(0.3, 2.0);
}

TEST(RigidStackOfBlocks, RestsWhateverTheRatioOfItsMasses) {
  for (const auto& [lower, upper] : {std::pair{1.0, 1e6}, std::pair{1e6, 1.0}, std::pair{1.0, 1e5}}) {
    Scene s = scenes::column(2, 0.5, 0.25, 0.6);
    s.bodies[0].mass = lower, s.bodies[1].mass = upper;
    Running r(s);
    const Running start = r;
    EXPECT_EQ(r.run(rigid(60.0, 1e-3)).outcome, Outcome::completed);
    expect_absolute("X02", "moreau-jean " + text(upper) + " kg on " + text(lower) + " kg: drift in 60 s", 0.0,
                    greatest_drift(r, start), 1e-9);
  }
}

Scene rubble() {
  Scene s = scenes::scene(0.5, 30e9, 0.4);
  s.bodies = {disc(0.12, {0.45, 1.45}), scenes::block(0.25, 0.5, {0.0, 0.5}),
              scenes::block(0.4, 0.1, {0.2, 1.121}, 0.05), scenes::block(0.1, 0.1, {-0.15, 1.5}, 0.3),
              scenes::block(0.15, 0.1, {0.9, 0.25}, -0.7)};
  s.bodies[0].velocity = {-0.3, -0.5};
  s.bodies[3].velocity = {0.5, -1.0};
  s.terrains.push_back(scenes::ground(200.0, {}, 0.0, sine(3.0, 2.0)));
  return s;
}

TEST(RigidContact, ComesToTheSameBitsFromACopyOfItsState) {
  Running whole(rubble()), parts(rubble());
  whole.model.motions[0] = parts.model.motions[0] = nullptr;  // time begins again with every run
  whole.run(rigid(0.25, 1e-3, 0.25)), parts.run(rigid(0.25, 1e-3, 0.25));
  const State saved = parts.state;
  whole.run(rigid(0.5, 1e-3, 0.25));
  parts.run(rigid(0.1, 1e-3, 0.1));
  parts.state = saved;
  parts.run(rigid(0.5, 1e-3, 0.25));
  EXPECT_EQ(state_hash(whole.state), state_hash(parts.state));
}

TEST(RigidContact, BalancesItsEnergy) {
  Running r(rubble());
  EnergyTurnover turnover;
  const RunOutcome run = r.run(rigid(3.0, 1e-3), [&](const Sample&) {
    turnover.note(r.energies());
    return Wish::go_on;
  });
  EXPECT_EQ(run.outcome, Outcome::completed) << run.detail;
  EXPECT_GT(r.state.work.damping, 0.0);
  EXPECT_GT(r.state.work.tangential, 0.0);
  expect_absolute("E17", "moreau-jean energy balance of shaken rubble", 0.0, turnover.relative_error(),
                  1e-10);
  EXPECT_LT(r.state.deepest_ratio, 0.02);
}

TEST(RigidContact, HasNoStabilityBoundAndAStepOfOneMillisecond) {
  Running r(scenes::wall(3, 4, 0.6));
  const StepPlan plan = plan_steps(r.model, r.state, scenes::run_for(1.0, 0.01, "moreau-jean"));
  EXPECT_TRUE(std::isinf(plan.bound));
  EXPECT_DOUBLE_EQ(plan.step, 1e-3);
  EXPECT_DOUBLE_EQ(plan_steps(r.model, r.state, rigid(1.0, 5e-3)).step, 5e-3);
}

// Springs between bodies stay springs, and bound the step.
TEST(RigidContact, StandsBesideSprings) {
  Scene s = scenes::column(2, 0.25, 0.25, 0.6);
  Joint joint;
  joint.name = "tie", joint.kind = JointKind::spring;
  joint.a = {false, 0}, joint.b = {false, 1};
  joint.stiffness = 1e7;
  s.joints.push_back(joint);
  Running r(s);
  const double bound = plan_steps(r.model, r.state, scenes::run_for(1.0, 0.01, "moreau-jean")).bound;
  EXPECT_TRUE(std::isfinite(bound));
  EXPECT_EQ(r.run(scenes::run_for(1.0, 0.01, "moreau-jean")).outcome, Outcome::completed);
  EXPECT_NEAR(r.position(1).y, 0.75, 1e-6);
}

TEST(RigidContact, GivesWayToSpringsAndBack) {
  Running r(scenes::column(2, 0.5, 0.25, 0.6));
  r.run(scenes::run_for(0.05));
  r.run(rigid(0.5, 1e-3));
  EXPECT_NEAR(r.position(1).y, 0.75, 1e-4);
  EXPECT_LT(norm(r.velocity(1)), 1e-6);
  r.run(scenes::run_for(0.05));
  EXPECT_NEAR(r.position(1).y, 0.75, 1e-4);
}

TEST(RigidContact, RefusesLocalDamping) {
  Running r(scenes::block_on_ground(0.5, 0.25, 0.6));
  DriveOptions options = rigid(0.1, 1e-3);
  options.local_damping = 0.5;
  try {
    r.run(options);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("local damping"));
  }
}

}  // namespace
}  // namespace dougong::engine
