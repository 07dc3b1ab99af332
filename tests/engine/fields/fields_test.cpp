// Fields: what is compiled, the forces and energies, the tree against the direct sum, the bounds.
#include "engine/fields/fields.h"

#include <gmock/gmock.h>

#include <limits>
#include <string>

#include "engine/dynamics.h"
#include "engine/fields/tree_error.h"
#include "tests/engine/allocations.h"
#include "tests/scenes/points.h"

namespace dougong::engine {
namespace {

using scenes::cloud;
using scenes::point;
using scenes::refusal_of;
using scenes::Running;
using scenes::space;
using ::testing::HasSubstr;

std::vector<Vec2> forces_of(const Running& r) {
  std::vector<Vec2> forces(r.bodies());
  Tree scratch;
  add_field_forces(r.model.fields, frames_of(r.model, r.state), scratch, forces);
  return forces;
}

TEST(FieldTerms, AreLeftOutWhereASceneLacksThem) {
  Scene s = cloud(5);
  for (Body& body : s.bodies) body.charge = 0.0;
  s.fields.coulomb_constant = 9e9, s.fields.electric_field = {0.0, 100.0};
  EXPECT_TRUE(compile(s).fields.empty());
  s.bodies[2].charge = 1e-6;
  EXPECT_EQ(compile(s).fields.pairs.size(), 0u);  // one charge has no partner
  EXPECT_EQ(compile(s).fields.uniform.bodies, std::vector<std::uint32_t>{2});
  s.bodies[4].charge = 1e-6;
  ASSERT_EQ(compile(s).fields.pairs.size(), 1u);
  EXPECT_EQ(compile(s).fields.pairs[0].bodies, (std::vector<std::uint32_t>{2, 4}));
  s.fields.gravitational_constant = 1.0;
  EXPECT_EQ(compile(s).fields.pairs.size(), 2u);
}

TEST(FieldTerms, NameTheBodyOrConstantThatIsWrong) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Scene s = cloud(3);
  s.bodies[1].charge = nan;
  EXPECT_THAT(refusal_of(s), HasSubstr("point 1: charge"));
  s = cloud(3), s.bodies[2].linear_drag = -1.0;
  EXPECT_THAT(refusal_of(s), HasSubstr("point 2: linear drag"));
  s = cloud(3), s.bodies[0].quadratic_drag = nan;
  EXPECT_THAT(refusal_of(s), HasSubstr("point 0: quadratic drag"));
  s = cloud(3), s.fields.softening = -0.1;
  EXPECT_THAT(refusal_of(s), HasSubstr("softening"));
  s = cloud(3), s.fields.gravitational_constant = -1.0;
  EXPECT_THAT(refusal_of(s), HasSubstr("gravitational constant"));
  s = cloud(3), s.fields.electric_field.x = nan;
  EXPECT_THAT(refusal_of(s), HasSubstr("electric field"));
}

TEST(FieldForces, AreNewtonsCoulombsAndTheUniformFields) {
  Scene s = space();
  s.fields = {2.0, 5.0, 0.0, 0.0, {3.0, -1.0}};
  s.bodies = {point(2.0, {0, 0}, {}, 0.5), point(3.0, {3, 4}, {}, -2.0)};
  const auto f = forces_of(Running(s));
  const double pull = (2.0 * 2.0 * 3.0 + 5.0 * 0.5 * 2.0) / 25.0;
  EXPECT_NEAR(f[0].x, 0.6 * pull + 0.5 * 3.0, 1e-14);
  EXPECT_NEAR(f[0].y, 0.8 * pull - 0.5 * 1.0, 1e-14);
  EXPECT_NEAR(f[1].x, -0.6 * pull - 2.0 * 3.0, 1e-14);
  EXPECT_NEAR(f[1].y, -0.8 * pull + 2.0 * 1.0, 1e-14);
}

TEST(FieldForces, AreMinusTheGradientOfTheEnergy) {
  for (const double angle : {0.0, 0.4}) {
    Scene s = cloud(600);
    s.fields = {0.7, 1.3, 0.05, angle, {3.0, -1.0}};
    Running r(s);
    const auto f = forces_of(r);
    const double h = 1e-5;
    for (const std::size_t i : {0u, 17u, 599u})
      for (const std::size_t axis : {0u, 1u}) {
        double& q = r.state.q()[axis * r.bodies() + i];
        const double at = q;
        q = at + h;
        const double high = r.energies().field;
        q = at - h;
        const double low = r.energies().field;
        q = at;
        // The tree's energy is not smooth: a cell that opens makes a small step.
        const double force = axis ? f[i].y : f[i].x, part = angle == 0.0 ? 1e-7 : 1e-2;
        EXPECT_NEAR(-(high - low) / (2 * h), force, 2e-5 + part * std::abs(force)) << i;
      }
  }
}

TEST(FieldForces, AreOppositeToTheLastBitInTheDirectSum) {
  Scene s = space();
  s.fields = {0.7, 1.3, 0.1, 0.0, {}};
  s.bodies = {point(1.1, {0.3, 0.7}, {}, 0.7), point(7.3, {-0.1, 1.9}, {}, -0.3)};
  const auto f = forces_of(Running(s));
  EXPECT_EQ(f[0].x, -f[1].x);
  EXPECT_EQ(f[0].y, -f[1].y);
}

TEST(FieldForces, AllocateNothingAfterTheFirstEvaluation) {
  Scene s = cloud(600);
  s.fields = {1.0, 1.0, 0.01, 0.5, {0.1, 0.0}};
  s.bodies[3].linear_drag = 1.0;
  Running r(s);
  Dynamics dynamics(r.model, r.state);
  std::vector<double> a(3 * r.bodies());
  dynamics.accelerate(0.0, r.state.q(), r.state.v(), a, true);
  const std::size_t before = testing::allocations();
  dynamics.accelerate(0.0, r.state.q(), r.state.v(), a, true);
  EXPECT_EQ(testing::allocations(), before);
}

double relative_error(const std::vector<Vec2>& got, const std::vector<Vec2>& exact) {
  double error = 0.0, size = 0.0;
  for (std::size_t i = 0; i < got.size(); ++i) {
    const Vec2 d = got[i] - exact[i];
    error += dot(d, d), size += dot(exact[i], exact[i]);
  }
  return std::sqrt(error / size);
}

void check_ladder(Scene s, const char* name) {
  s.fields.opening_angle = 0.0;
  const auto exact = forces_of(Running(s));
  const double energy = Running(s).energies().field;
  const double allowed[] = {2e-2, 4e-3, 8e-4, 1.5e-4};
  const double angles[] = {0.8, 0.5, 0.3, 0.15};
  for (int k = 0; k < 4; ++k) {
    s.fields.opening_angle = angles[k];
    const Running r(s);
    const double error = relative_error(forces_of(r), exact);
    std::printf("tree %s angle %.2g force error %.2e energy error %.2e\n", name, angles[k], error,
                std::abs(r.energies().field / energy - 1.0));
    EXPECT_LT(error, allowed[k]) << name << " " << angles[k];
  }
}

TEST(Tree, ComesCloserToTheDirectSumTheNarrowerItsAngle) {
  Scene s = cloud(2000);
  s.fields = {1.0, 0.0, 0.02, 0.0, {}};
  check_ladder(s, "masses");
  s.fields = {0.0, 1.0, 0.02, 0.0, {}};
  check_ladder(s, "charges of both signs");
}

// What a run says of its tree: with every body compared the error of the ladder above; with picked ones near
// it.
TEST(TreeErrors, AreThoseOfTheForces) {
  for (const int count : {1500, 4000}) {
    Scene s = cloud(count);
    s.fields = {1.0, 0.0, 0.02, 0.0, {}};
    const auto exact = forces_of(Running(s));
    s.fields.opening_angle = 0.5;
    const Running r(s);
    const auto errors = tree_errors(r.model.fields, frames_of(r.model, r.state));
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_EQ(errors[0].field, "gravitation");
    EXPECT_EQ(errors[0].bodies, r.bodies());
    EXPECT_EQ(errors[0].compared, std::min(r.bodies(), most_compared));
    const double error = relative_error(forces_of(r), exact);
    EXPECT_NEAR(errors[0].relative, error, (r.bodies() > most_compared ? 0.3 : 1e-9) * error);
  }
}

TEST(TreeErrors, AreNoneWhereEveryPairIsSummed) {
  Scene s = cloud(600);
  s.fields = {1.0, 0.0, 0.02, 0.0, {}};
  const Running direct(s);
  EXPECT_TRUE(tree_errors(direct.model.fields, frames_of(direct.model, direct.state)).empty());
  s = cloud(100), s.fields.opening_angle = 0.5, s.fields.gravitational_constant = 1.0;
  const Running few(s);
  EXPECT_TRUE(tree_errors(few.model.fields, frames_of(few.model, few.state)).empty());
}

TEST(Tree, IsTheDirectSumForFewBodies) {
  Scene s = cloud(20);
  s.fields = {1.0, 1.0, 0.0, 0.0, {}};
  const auto exact = forces_of(Running(s));
  s.fields.opening_angle = 0.7;
  const auto tree = forces_of(Running(s));
  for (std::size_t i = 0; i < exact.size(); ++i) EXPECT_EQ(exact[i], tree[i]);
}

TEST(Tree, TakesManyBodiesAtOnePlace) {
  Scene s = cloud(600);
  for (Body& body : s.bodies) body.position = {0.5, 0.5};
  s.bodies[0].position = {3.0, 0.5};
  s.fields = {1.0, 0.0, 0.1, 0.5, {}};
  const auto tree = forces_of(Running(s));
  s.fields.opening_angle = 0.0;
  EXPECT_LT(relative_error(tree, forces_of(Running(s))), 1e-10);
}

TEST(Tree, GivesTheSameBitsTwice) {
  Scene s = cloud(600);
  s.fields = {1.0, 1.0, 0.01, 0.5, {}};
  const auto a = forces_of(Running(s)), b = forces_of(Running(s));
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i], b[i]);
}

TEST(FieldBound, IsAboveTwoBodiesOwnFrequencyAndNotFar) {
  for (const double m2 : {1e-3, 1.0}) {
    const Running r(scenes::two_bodies(1.0, 1.0, m2, {0.4, 0.0}, {}));
    const double exact = 2.0 * (1.0 + m2) / (0.4 * 0.4 * 0.4);
    const double bound = spectral_bound(r.model, r.state, frames_of(r.model, r.state)).stiffness;
    EXPECT_GE(bound, exact * (1.0 - 1e-12));
    EXPECT_LE(bound, 1.1 * exact);
  }
}

TEST(FieldBound, CountsDragAtTheSpeedOfNow) {
  Scene s = space();
  s.bodies = {point(2.0, {}, {3.0, 4.0})};
  s.bodies[0].linear_drag = 0.6, s.bodies[0].quadratic_drag = 0.1;
  const Running r(s);
  const SpectralBound bound = spectral_bound(r.model, r.state, frames_of(r.model, r.state));
  EXPECT_EQ(bound.stiffness, 0.0);
  EXPECT_NEAR(bound.damping, (0.6 + 2 * 0.1 * 5.0) / 2.0, 1e-14);
}

TEST(FieldBound, CountsTheSpringOfAppliedForces) {
  Scene s = space();
  s.bodies = {point(2.0, {}, {}), point(0.5, {1.0, 0.0}, {})};
  s.bodies[0].applied_force = {3.0, 0.0}, s.bodies[1].applied_force = {0.0, 4.0};
  s.fields.applied_relief = 0.1;
  const Running r(s);
  EXPECT_NEAR(spectral_bound(r.model, r.state, frames_of(r.model, r.state)).stiffness,
              0.1 * (9.0 / 2.0 + 16.0 / 0.5), 1e-12);
}

// Two masses pulled apart from one spring are an oscillator: W = sum p x, W'' = lambda sum p^2/m.
TEST(AppliedForces, AreDeadLoadsOrOneSpringInTheirProportions) {
  Scene s = space();
  s.bodies = {point(2.0, {}, {}), point(0.5, {5.0, 0.0}, {})};
  s.bodies[0].applied_force = {3.0, 0.0}, s.bodies[1].applied_force = {0.0, -1.0};
  Running dead(s);
  dead.run(scenes::run_for(2.0));
  EXPECT_NEAR(dead.position(0).x, 0.5 * 1.5 * 4.0, 1e-10);
  EXPECT_NEAR(dead.position(1).y, -0.5 * 2.0 * 4.0, 1e-10);

  s.fields.applied_relief = 0.4, s.fields.applied_factor = 0.2;
  Running pulled(s);
  const double work = applied_work(pulled.model.fields.applied, frames_of(pulled.model, pulled.state)),
               w2 = 0.4 * (9.0 / 2.0 + 1.0 / 0.5), amplitude = 0.2 / 0.4 - work;
  const Vec2 first = pulled.position(0), second = pulled.position(1);
  DriveOptions options = scenes::run_for(2.0, 0.01, "rk4");
  options.step = 1e-3;
  pulled.run(options);
  const double done = amplitude * (1.0 - std::cos(2.0 * std::sqrt(w2))), share = done / (w2 / 0.4);
  EXPECT_NEAR(pulled.position(0).x - first.x, share * 3.0 / 2.0, 1e-9);
  EXPECT_NEAR(pulled.position(1).y - second.y, -share * 1.0 / 0.5, 1e-9);
  EXPECT_NEAR(pulled.energies().balance(), 0.5 * 0.4 * work * work - 0.2 * work, 1e-9);
}

TEST(AppliedForces, AreLeftOutWhereNoneAreAndNamedWhereWrong) {
  Scene s = cloud(3);
  EXPECT_TRUE(compile(s).fields.applied.bodies.empty());
  s.bodies[1].applied_force.y = std::numeric_limits<double>::infinity();
  EXPECT_THAT(refusal_of(s), HasSubstr("point 1: applied force"));
  s = cloud(3), s.fields.applied_relief = -1.0;
  EXPECT_THAT(refusal_of(s), HasSubstr("relief of applied forces"));
}

// A swarm that attracts, repels and collides. A Runge-Kutta method keeps a quadratic invariant such as the
// angular momentum only to its order.
TEST(IsolatedCluster, KeepsItsMomentumAboutAnyPoint) {
  Scene s = cloud(12, 3);
  s.materials[0].young_modulus = 1e6, s.materials[0].density = 100.0;
  for (std::size_t i = 0; i < 12; ++i) {
    Body& body = s.bodies[i];
    body.shape = make_circle(0.1), body.collides = true, body.mass.reset();
    body.position =
        Vec2{0.8 * static_cast<double>(i % 4), 0.8 * static_cast<double>(i / 4)} + 0.2 * body.position;
  }
  s.fields = {1.0, 1.0, 0.05, 0.0, {}};
  for (const char* integrator : {"velocity-verlet", "symplectic-euler", "rk4"}) {
    Running r(s);
    const Vec2 before = scenes::momentum(r), away{1e3, -20.0};
    const double spin = scenes::angular_momentum(r, {}), far = scenes::angular_momentum(r, away);
    const bool conserves = integrator != std::string("rk4");
    DriveOptions options = scenes::run_for(2.0, 0.05, integrator);
    if (!conserves) options.step_fraction = 0.1;
    const RunOutcome run = r.run(options);
    EXPECT_EQ(run.outcome, Outcome::completed) << integrator << ": " << run.detail;
    EXPECT_LT(norm(scenes::momentum(r) - before), 1e-11);
    const double allowed = conserves ? 1e-10 : 1e-5;
    EXPECT_NEAR(scenes::angular_momentum(r, {}), spin, allowed);
    EXPECT_NEAR(scenes::angular_momentum(r, away), far, std::max(allowed, 1e-8));
  }
}

TEST(PointMass, IsNotTouched) {
  Scene s = scenes::block_on_ground(0.5, 0.2, 0.6);
  s.gravity = {};
  s.bodies.push_back(point(1.0, {-3.0, 0.2}, {6.0, 0.0}));
  Running r(s);
  r.run(scenes::run_for(1.0));
  EXPECT_NEAR(r.position(1).x, 3.0, 1e-10);
  EXPECT_NEAR(r.position(0).x, 0.0, 1e-12);
}

TEST(EnergyOfFields, IsBookedAndBalances) {
  Scene s = scenes::two_bodies(1.0, 1.0, 0.5, {1.0, 0.0}, {0.0, 0.9});
  s.bodies[0].charge = 0.3, s.bodies[1].charge = -0.4;
  s.bodies[1].linear_drag = 0.05, s.bodies[0].quadratic_drag = 0.1;
  s.fields.coulomb_constant = 1.0, s.fields.electric_field = {0.2, -0.1};
  for (const char* integrator : {"velocity-verlet", "rk4"}) {
    Running r(s);
    const Energies start = r.energies();
    EXPECT_NEAR(start.field, -0.5 - 0.12 - 0.3 * 0.2 * (-1.0 / 3.0) + 0.4 * 0.2 * (2.0 / 3.0), 0.1);
    DriveOptions options = scenes::run_for(2.0, 0.01, integrator);
    options.step = 1e-3;
    const RunOutcome run = r.run(options);
    EXPECT_EQ(run.outcome, Outcome::completed) << run.detail;
    const Energies end = r.energies();
    EXPECT_GT(end.damping, 0.01);
    EXPECT_NEAR(end.balance(), start.balance(), integrator[0] == 'r' ? 1e-9 : 1e-5);
  }
}

}  // namespace
}  // namespace dougong::engine
