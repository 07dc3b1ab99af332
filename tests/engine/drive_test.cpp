#include "engine/drive.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "engine/settle.h"
#include "tests/engine/reference.h"
#include "tests/oracles/free_fall.h"
#include "tests/scenes/running.h"

namespace dougong::engine {
namespace {

using scenes::run_for;
using scenes::Running;
using ::testing::HasSubstr;

// A sine sampled every 0.01 s: what a record looks like to the driver.
class KnottedMotion final : public PrescribedMotion {
 public:
  explicit KnottedMotion(double interval) : interval_(interval) {}
  MotionSample at(double t) const override {
    const double w = 2.0 * std::numbers::pi;
    return {{(t - std::sin(w * t) / w) / w, 0.0}, {(1.0 - std::cos(w * t)) / w, 0.0}, {std::sin(w * t), 0.0}};
  }
  double knot_interval() const override { return interval_; }

 private:
  double interval_;
};

Scene shaken_block(double knot) {
  Scene s = scenes::block_on_ground(0.5, 0.2, 0.6, 1e9);
  s.terrains[0].motion = std::make_shared<KnottedMotion>(knot);
  return s;
}

// Three blocks that fall, hit, rub and topple: everything that a trajectory can show.
Scene tumble(double mirror = 1.0) {
  Scene s = scenes::scene(0.4, 1e8, 0.3);
  s.bodies = {scenes::block(0.25, 0.5, {0.0, 0.5}),
              scenes::block(0.4, 0.1, {0.2 * mirror, 1.121}, 0.05 * mirror),
              scenes::block(0.1, 0.1, {-0.15 * mirror, 1.6}, 0.3 * mirror)};
  s.bodies[2].velocity = {0.5 * mirror, -1.0};
  s.terrains.push_back(scenes::ground());
  return s;
}

// Outputs come often enough for the fall of the small block to be followed into its first contact.
DriveOptions tumble_for(double end_time, const std::string& integrator = "velocity-verlet") {
  DriveOptions options = run_for(end_time, 2e-4, integrator);
  return options;
}

TEST(Projectile, IsExactInFlight) {
  struct Case {
    oracles::Projectile p;
    double t;
  };
  const Case cases[] = {{{0.0, 20.0, 3.0, 4.0, 1.5, 9.81}, 2.0}, {{-7.0, 300.0, -2.0, 11.0, -4.0, 3.7}, 1.3}};
  for (const auto& [p, t] : cases)
    for (const char* integrator : {"velocity-verlet", "rk4", "symplectic-euler"}) {
      Scene s = scenes::scene(0.6);
      s.gravity.y = -p.g;
      s.bodies.push_back(scenes::block(0.5, 0.2, {p.x0, p.y0}));
      s.bodies[0].velocity = {p.vx, p.vy};
      s.bodies[0].spin = p.spin;
      Running r(s);
      r.run(run_for(t, 0.01, integrator));
      const bool euler = std::string(integrator) == "symplectic-euler";
      const std::string name = std::string(integrator) + " ";
      testing::expect_absolute("E01", name + "x", p.x(t), r.position().x, 1e-12 * (1.0 + std::abs(p.x(t))));
      testing::expect_absolute("E01", name + "y", p.y(t) + (euler ? p.symplectic_euler_offset(t, 0.01) : 0.0),
                               r.position().y, 1e-12 * (1.0 + std::abs(p.y(t)) * 10.0));
      testing::expect_absolute("E01", name + "vy", p.speed_up(t), r.velocity().y, 1e-12 * 20.0);
      testing::expect_absolute("E01", name + "angle", p.angle(t), r.angle(), 1e-12 * 10.0);
    }
}

TEST(Drive, CallsTheObserverAtZeroAndAtEveryOutputTime) {
  Running r(shaken_block(0.01));
  std::vector<double> times;
  const RunOutcome run =
      r.run(run_for(0.5, 0.02), [&](const Sample& s) { return times.push_back(s.state.time), Wish::go_on; });
  ASSERT_EQ(times.size(), 26u);
  for (std::size_t i = 0; i < times.size(); ++i) EXPECT_DOUBLE_EQ(times[i], 0.02 * static_cast<double>(i));
  EXPECT_EQ(run.outcome, Outcome::completed);
  EXPECT_DOUBLE_EQ(run.end_time, 0.5);
}

TEST(Drive, DividesTheKnotIntervalAndRoundsTheOutputToIt) {
  for (const double knot : {0.01, 0.005, 0.004, 0.02}) {
    Running r(shaken_block(knot));
    const StepPlan plan = plan_steps(r.model, r.state, run_for(0.1, 0.01));
    const double parts = knot / plan.step, bases = plan.output_interval / plan.base_interval;
    EXPECT_NEAR(parts, std::round(parts), 1e-9) << knot;
    EXPECT_NEAR(bases, std::round(bases), 1e-9) << knot;
    EXPECT_NEAR(knot / plan.base_interval, std::round(knot / plan.base_interval), 1e-9) << knot;
    EXPECT_LE(plan.step, 0.5 * plan.bound * (1.0 + 1e-9)) << knot;
  }
}

TEST(Drive, StopsWhenTheObserverAsksItTo) {
  for (const Wish wish : {Wish::stop, Wish::interrupt}) {
    Running r(shaken_block(0.01));
    const RunOutcome run =
        r.run(run_for(1.0), [&](const Sample& s) { return s.state.time > 0.195 ? wish : Wish::go_on; });
    EXPECT_EQ(run.outcome, wish == Wish::stop ? Outcome::stopped_by_criterion : Outcome::interrupted);
    EXPECT_NEAR(run.end_time, 0.2, 1e-12);
  }
}

TEST(Drive, RefusesAStepAboveTheBound) {
  Running r(shaken_block(0.01));
  DriveOptions options = run_for(0.1);
  options.step = 1.001 * plan_steps(r.model, r.state, options).bound;
  const std::string before = state_hash(r.state);
  const RunOutcome run = r.run(options);
  EXPECT_EQ(run.outcome, Outcome::step_too_large);
  EXPECT_THAT(run.detail, HasSubstr("stability bound"));
  EXPECT_EQ(run.steps, 0u);
  EXPECT_EQ(state_hash(r.state), before);
  options.step = 0.9 * run.bound;
  EXPECT_EQ(r.run(options).outcome, Outcome::completed);
}

// X04. Just below the bound a block that swings without loss on its springs keeps its energy.
TEST(Drive, IsStableUpToItsBound) {
  for (const auto& [b, h] : {std::pair{0.5, 0.2}, std::pair{0.1, 0.3}})
    for (const double part : {0.5, 0.9, 0.99}) {
      Scene s = scenes::scene(0.6, 1e9, 0.0);
      const double sunk = 2400.0 * 2.0 * h * 9.81 * h / 1e9;
      s.bodies.push_back(scenes::block(b, h, {0.0, h - 1.05 * sunk}));
      s.terrains.push_back(scenes::ground());
      Running r(s);
      const Energies start = r.energies();
      DriveOptions options = run_for(5.0);
      options.step = part * plan_steps(r.model, r.state, options).bound;
      options.output_interval = 100.0 * *options.step;
      double worst = 0.0;
      const RunOutcome run = r.run(options, [&](const Sample&) {
        worst = std::max(worst, std::abs(r.energies().balance() - start.balance()));
        return Wish::go_on;
      });
      EXPECT_EQ(run.outcome, Outcome::completed) << run.detail;
      EXPECT_DOUBLE_EQ(run.smallest_step, *options.step);
      testing::expect_absolute("X04", testing::text(part) + " of the bound: energy error over stored", 0.0,
                               worst / start.elastic, 1e-8);
    }
}

// X04. A million steps of a tenth of a microsecond add up to a fall.
TEST(Drive, AddsUpAMillionTinySteps) {
  for (const auto& [speed, gravity] : {std::pair{0.0, 9.81}, std::pair{3.0, 1.62}})
    for (const char* integrator : {"velocity-verlet", "rk4"}) {
      Scene s = scenes::scene(0.6);
      s.gravity.y = -gravity;
      s.bodies.push_back(scenes::block(0.5, 0.2, {0.0, 20.0}));
      s.bodies[0].velocity.y = speed;
      Running r(s);
      DriveOptions options = run_for(0.1, 0.1, integrator);
      options.step = 1e-7;
      EXPECT_EQ(r.run(options).steps, 1000000u);
      const std::string name = std::string(integrator) + " v=" + testing::text(speed) + " ";
      testing::expect_relative("X04", name + "fallen in 1e6 steps of 1e-7 s", speed * 0.1 - 0.005 * gravity,
                               r.position().y - 20.0, 1e-9);
      testing::expect_relative("X04", name + "speed", speed - 0.1 * gravity, r.velocity().y, 1e-9);
    }
}

TEST(Drive, SaysWhichBodysMotionIsNotFinite) {
  Scene s = shaken_block(0.01);
  s.bodies.push_back(scenes::block(0.1, 0.1, {5.0, 3.0}));
  s.bodies[0].name = "sound", s.bodies[1].name = "broken";
  Running r(s);
  r.state.v()[1] = std::numeric_limits<double>::quiet_NaN();
  const RunOutcome run = r.run(run_for(0.1));
  EXPECT_EQ(run.outcome, Outcome::diverged);
  EXPECT_THAT(run.detail, HasSubstr("broken"));
  EXPECT_LE(run.end_time, 0.01 + 1e-12);
}

TEST(Drive, SaysWhichBodiesHavePassedIntoEachOther) {
  Scene s = scenes::block_on_ground(0.5, 0.2, 0.6, 1e9);
  s.bodies[0].position.y -= 0.15;
  Running r(s);
  const RunOutcome run = r.run(run_for(0.1));
  EXPECT_EQ(run.outcome, Outcome::diverged);
  EXPECT_THAT(run.detail, HasSubstr("block and ground"));
}

TEST(Drive, CountsTheReductionsOfItsStep) {
  Scene s = scenes::scene(0.6, 1e9);
  s.bodies = {scenes::block(0.5, 0.5, {0.0, 0.5}), scenes::block(0.05, 0.05, {3.0, 0.0535})};
  s.terrains.push_back(scenes::ground());
  Running r(s);
  const RunOutcome run = r.run(run_for(0.2, 1e-3));
  EXPECT_EQ(run.outcome, Outcome::completed);
  EXPECT_GE(run.step_reductions, 1u);
  EXPECT_LT(run.smallest_step, run.step);
  Running steady(scenes::block_on_ground(0.5, 0.5, 0.6, 1e9));
  EXPECT_EQ(steady.run(run_for(0.2)).step_reductions, 0u);
}

TEST(Drive, FindsAFastBodysContactBeforeItCloses) {
  for (const std::string integrator : {"velocity-verlet", "symplectic-euler", "rk4"}) {
    engine::Scene scene = scenes::scene(0.6);
    scene.terrains.push_back(scenes::ground());
    scene.bodies.push_back(scenes::block(0.5, 0.5, {0.0, 1.5}));
    scene.bodies[0].velocity = {0.0, -10.0};
    Running falling(scene);
    double highest_speed = 0.0;
    const RunOutcome run = falling.run(run_for(0.5, 0.01, integrator), [&](const Sample& sample) {
      highest_speed = std::max(highest_speed, sample.state.v()[1]);
      return Wish::go_on;
    });
    EXPECT_EQ(run.outcome, Outcome::completed) << integrator << ": " << run.detail;
    EXPECT_LT(highest_speed, 3.0) << integrator;  // two corners of damping ratio 1: hardly any rebound
    EXPECT_LT(falling.state.deepest_ratio, 0.01) << integrator;
    EXPECT_GT(run.step_reductions, 0u) << integrator;
  }
}

TEST(Drive, DoesNotTakeTheFreeSlotOfARoundContactForAnOverlap) {
  for (const bool disc_first : {false, true}) {
    engine::Scene scene = scenes::scene(0.6);
    scene.terrains.push_back(scenes::ground());
    Body disc;
    disc.name = "disc";
    disc.shape = make_circle(0.2);
    disc.position = {0.0, 0.6};
    scene.bodies.push_back(scenes::block(0.5, 0.2, {0.0, 0.2}));
    scene.bodies.insert(disc_first ? scene.bodies.begin() : scene.bodies.end(), disc);
    Running resting(scene);
    EXPECT_EQ(resting.run(run_for(0.2)).outcome, Outcome::completed) << disc_first;
    EXPECT_LT(resting.state.deepest_ratio, 1e-5) << disc_first;
  }
}

TEST(Drive, RefusesOptionsThatMakeNoSense) {
  Running r(shaken_block(0.01));
  const auto refused = [&](auto change) {
    DriveOptions options = run_for(0.1);
    change(options);
    EXPECT_THROW(r.run(options), std::invalid_argument);
  };
  refused([](DriveOptions& o) { o.end_time = -1.0; });
  refused([](DriveOptions& o) { o.end_time = std::numeric_limits<double>::infinity(); });
  refused([](DriveOptions& o) { o.output_interval = 0.0; });
  refused([](DriveOptions& o) { o.step_fraction = 1.0; });
  refused([](DriveOptions& o) { o.step = -1e-3; });
  refused([](DriveOptions& o) { o.tolerance = 0.0; });
  refused([](DriveOptions& o) { o.integrator = "leapfrogs"; });
}

TEST(Drive, IsNotChangedByBeingWatched) {
  for (const char* integrator : {"velocity-verlet", "symplectic-euler", "rk4"}) {
    Running watched(tumble()), alone(tumble());
    watched.run(tumble_for(0.4, integrator), [](const Sample&) { return Wish::go_on; });
    alone.run(tumble_for(0.4, integrator));
    EXPECT_EQ(state_hash(watched.state), state_hash(alone.state)) << integrator;
  }
}

TEST(Drive, GivesTheSameBitsTwice) {
  Running one(tumble()), two(tumble());
  one.run(tumble_for(0.6));
  two.run(tumble_for(0.6));
  EXPECT_EQ(state_hash(one.state), state_hash(two.state));
  Running other(tumble());
  other.run(tumble_for(0.5998));
  EXPECT_NE(state_hash(one.state), state_hash(other.state));
}

// X13. A mirrored scene is the same numbers with other signs; only the order in which a block's two
// corners are summed differs, and that rounds differently.
TEST(Drive, GivesTheMirroredAnswerToTheMirroredScene) {
  Running here(tumble(1.0)), there(tumble(-1.0));
  here.run(tumble_for(0.4));
  there.run(tumble_for(0.4));
  double worst = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    worst = std::max(worst, std::abs(here.position(i).x + there.position(i).x));
    worst = std::max(worst, std::abs(here.position(i).y - there.position(i).y));
    worst = std::max(worst, std::abs(here.angle(i) + there.angle(i)));
  }
  testing::expect_absolute("X13", "mirrored tumble: largest difference (m, rad)", 0.0, worst, 1e-6);
}

// X15. What the ground does steadily, and where the scene stands, is nobody's business.
TEST(Drive, DoesNotSeeASteadyMotionOfTheGround) {
  const double speed = 10.0;
  Scene still = tumble(), moving = tumble();
  moving.terrains[0].motion = scenes::horizontal_motion(
      [](double) { return 0.0; }, [=](double) { return speed; }, [=](double t) { return speed * t; });
  for (Body& body : moving.bodies) body.velocity.x += speed;
  Running a(still), b(moving);
  a.run(tumble_for(0.4));
  b.run(tumble_for(0.4));
  double worst = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    worst = std::max(worst, norm(b.position(i) - Vec2{speed * 0.4, 0.0} - a.position(i)));
    worst = std::max(worst, std::abs(b.angle(i) - a.angle(i)));
  }
  testing::expect_absolute("X15", "ground at 10 m/s: largest difference (m, rad)", 0.0, worst, 1e-6);
}

TEST(Drive, DoesNotSeeAnOffsetOfAThousandKilometres) {
  Scene near = tumble(), far = tumble();
  const Vec2 offset{1e6, 0.0};
  for (Body& body : far.bodies) body.position += offset;
  far.terrains[0].position += offset;
  Running a(near), b(far);
  a.run(tumble_for(0.4));
  b.run(tumble_for(0.4));
  double worst = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 pa{a.state.q()[i], a.state.q()[3 + i]}, pb{b.state.q()[i], b.state.q()[3 + i]};
    worst = std::max({worst, norm(pa - pb), std::abs(b.angle(i) - a.angle(i))});
  }
  testing::expect_absolute("X15", "offset of 1e6 m: largest difference (m, rad)", 0.0, worst, 1e-6);
}

TEST(Model, RefusesWhatCannotBeSimulated) {
  const auto refused = [](auto change) {
    Scene s = scenes::block_on_ground(0.5, 0.2, 0.6);
    s.bodies[0].name = "culprit";
    change(s);
    try {
      compile(s);
      ADD_FAILURE() << "accepted";
    } catch (const std::invalid_argument& e) {
      EXPECT_THAT(e.what(), HasSubstr("culprit"));
    }
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refused([](Scene& s) { s.bodies[0].mass = 0.0; });
  refused([](Scene& s) { s.bodies[0].inertia = 0.0; });
  refused([&](Scene& s) { s.bodies[0].inertia = nan; });
  refused([](Scene& s) { s.bodies[0].thickness = -1.0; });
  refused([](Scene& s) { s.bodies[0].material = 1; });
  refused([](Scene& s) { s.materials[0].density = 0.0; });
  refused([](Scene& s) { s.materials[0].young_modulus = -1.0; });
  refused([](Scene& s) { s.materials[0].friction_coefficient = -0.1; });
  refused([&](Scene& s) { s.bodies[0].position.x = nan; });
}

}  // namespace
}  // namespace dougong::engine
