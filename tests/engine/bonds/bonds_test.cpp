#include "engine/bonds/bonds.h"

#include <gmock/gmock.h>
#include <Eigen/SparseCholesky>

#include <cmath>
#include <numbers>

#include "engine/contact/stiffness.h"
#include "engine/modes.h"
#include "engine/settle.h"
#include "tests/engine/reference.h"
#include "tests/scenes/running.h"

namespace dougong::engine {
namespace {

using scenes::angular_momentum;
using scenes::momentum;
using scenes::run_for;
using scenes::Running;
using testing::expect_relative;
using ::testing::HasSubstr;

// A cantilever of `count` bonded blocks along x, held by a terrain at its left end.
struct Cantilever {
  double length = 4.0, depth = 0.4, modulus = 1e9, density = 2000.0;
  int count = 16;

  Scene scene() const {
    Scene s = scenes::scene(0.6, modulus);
    s.materials[0].density = density;
    s.gravity = {};
    const double w = length / count;
    for (int i = 0; i < count; ++i) {
      s.bodies.push_back(scenes::block(0.5 * w, 0.5 * depth, {(i + 0.5) * w, 0.0}));
      s.bodies.back().name = "block " + std::to_string(i);
      const Owner left = i == 0 ? Owner{true, 0} : Owner{false, static_cast<std::size_t>(i - 1)};
      s.bonds.push_back(bond(left, {false, static_cast<std::size_t>(i)}, i * w));
    }
    Terrain wall;
    wall.name = "wall";
    wall.shape = make_rectangle(0.5, 2.0);
    wall.position = {-0.25, 0.0};
    s.terrains.push_back(wall);
    return s;
  }
  Bond bond(Owner a, Owner b, double x) const {
    Bond bond;
    bond.name = "bond at " + std::to_string(x);
    bond.a = a, bond.b = b;
    bond.start = {x, -0.5 * depth}, bond.end = {x, 0.5 * depth};
    bond.shear_stiffness = 1e3 * modulus * count / length;  // Euler and Bernoulli know no shear
    bond.damping_ratio = 0.5;
    return bond;
  }
  double bending_stiffness() const { return modulus * std::pow(depth, 3) / 12.0; }
};

// Tip deflection under its own weight q = rho d g: q L^4 / (8 E I). A chain of n rigid blocks that bend at
// their faces, the first held rigidly at its outer face, has its own closed form; both agree as n grows.
double chain_deflection(const Cantilever& c, double g) {
  const double w = c.length / c.count, q = c.density * c.depth * g;
  double tip = 0.0;
  for (int i = 0; i < c.count; ++i) {
    const double x = i * w, arm = c.length - x, moment = 0.5 * q * arm * arm;
    const double flexibility = (i == 0 ? 0.5 : 1.0) * w / c.bending_stiffness();
    tip += moment * flexibility * arm;
  }
  return tip;
}

// Displacements under a small uniform gravity, from the tangent stiffness.
Eigen::VectorXd sagged(const Running& r, double g) {
  const auto n = static_cast<Eigen::Index>(r.bodies());
  Eigen::VectorXd load = Eigen::VectorXd::Zero(3 * n);
  for (Eigen::Index i = 0; i < n; ++i) load[n + i] = -r.model.mass[static_cast<std::size_t>(i)] * g;
  const Eigen::SparseMatrix<double> k = tangent_stiffness(r.model, r.state);
  return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(k).solve(load);
}

TEST(BondedCantilever, BendsUnderItsWeightAsTheBeamDoes) {
  for (const int count : {4, 16, 64}) {
    Cantilever c;
    c.count = count;
    const Running r(c.scene());
    const Eigen::VectorXd u = sagged(r, 0.1);
    const double tip = -(u[2 * count - 1] + 0.5 * c.length / count * u[3 * count - 1]);
    expect_relative("bonds", "tip of " + std::to_string(count) + " blocks", chain_deflection(c, 0.1), tip,
                    1e-3);
  }
  Cantilever fine;
  fine.count = 64;
  const double beam =
      fine.density * fine.depth * 0.1 * std::pow(fine.length, 4) / 8.0 / fine.bending_stiffness();
  EXPECT_NEAR(chain_deflection(fine, 0.1) / beam, 1.0, 2e-3) << "the chain itself converges to the beam";
}

// The same by letting it come to rest: the forces are those of the tangent.
TEST(BondedCantilever, ComesToRestWhereItsTangentSays) {
  Cantilever c;
  c.count = 4;
  Scene s = c.scene();
  s.gravity = {0.0, -0.1};
  Running r(s);
  const double before = r.position(3).y;
  SettleOptions options;
  options.unbalanced_ratio = 1e-7;
  ASSERT_TRUE(settle(r.model, r.state, options).settled);
  expect_relative("bonds", "settled tip block", sagged(Running(c.scene()), 0.1)[7], r.position(3).y - before,
                  1e-3);
}

// First frequency (1.8751/L)^2 sqrt(EI/(rho A)) of Euler and Bernoulli, order 2 in the blocks' length.
TEST(BondedCantilever, HasTheFrequencyOfTheBeamToOrderTwo) {
  const auto error = [](int count) {
    Cantilever c;
    c.count = count;
    c.depth = 0.04;  // slender: the blocks' rotary inertia, which the beam has not, is 5e-5 of it all
    const Scene s = c.scene();
    const double exact =
        std::pow(1.8751040687 / c.length, 2) * std::sqrt(c.bending_stiffness() / (c.density * c.depth));
    // The lowest mode moves across: turn the beam upright so that "horizontal" excites it.
    Scene upright = s;
    for (Body& b : upright.bodies) b.position = {0.0, b.position.x}, b.angle = std::numbers::pi / 2;
    for (Bond& b : upright.bonds) b.start = {-b.start.y, b.start.x}, b.end = {-b.end.y, b.end.x};
    upright.terrains[0].position = {0.0, -0.25}, upright.terrains[0].angle = std::numbers::pi / 2;
    Running u(upright);
    const auto modes = horizontal_modes(u.model, u.state);
    return std::abs(std::sqrt(modes.at(0).angular_frequency_squared) / exact - 1.0);
  };
  const double coarse = error(10), fine = error(20);
  EXPECT_LT(fine, 5e-3);
  EXPECT_GT(std::log2(coarse / fine), 1.7);
}

// Of the first block on the ground, on either side of x = 0.
Bond bed_joint(double half_length) {
  Bond b;
  b.name = "bed joint";
  b.a = {true, 0}, b.b = {false, 0};
  b.start = {-half_length, 0.0}, b.end = {half_length, 0.0};
  b.damping_ratio = 1.0;
  return b;
}

// Two blocks, the upper one pulled off by a field of gravity that points up.
Scene hanging(double strength, double pull, double fracture_energy = 0.0) {
  Scene s = scenes::scene(0.6, 1e9);
  s.gravity = {0.0, pull};
  s.bodies.push_back(scenes::block(0.5, 0.5, {0.0, 0.5}));
  s.terrains.push_back(scenes::ground());
  Bond b = bed_joint(0.5);
  b.tensile_strength = strength;
  b.fracture_energy = fracture_energy;
  s.bonds.push_back(b);
  return s;
}

TEST(Bond, HoldsItsStrengthAndNoMore) {
  const double stress = 2400.0 * 9.81;  // of 1 m3 on 1 m2
  // A load that comes at once doubles its effect without damping; with the ratio 1 it overshoots a little.
  Running holds(hanging(1.3 * stress, 9.81)), breaks(hanging(0.95 * stress, 9.81));
  holds.run(run_for(1.0)), breaks.run(run_for(1.0));
  EXPECT_LT(holds.position().y, 0.501);
  EXPECT_EQ(holds.state.bonds.broken, 0u);
  EXPECT_GT(breaks.position().y, 3.0);
  EXPECT_EQ(breaks.state.bonds.broken, 2u);
}

TEST(Bond, GivesItsEnergyToTheFracture) {
  const double strength = 2e4, energy = 50.0;
  Running r(hanging(strength, 60.0, energy));
  const double start = r.energies().balance();
  r.run(run_for(0.5));
  ASSERT_EQ(r.state.bonds.broken, 2u);
  const Energies e = r.energies();
  EXPECT_NEAR(e.fracture, energy * 1.0, 0.02 * energy) << "G_f times 1 m2";
  EXPECT_NEAR(e.balance(), start, 1e-3 * e.kinetic);
}

TEST(Bond, OfDuctileSteelYieldsAndStaysOpen) {
  Scene s = hanging(1e9, 9.81);
  s.bonds[0].tensile_strength = std::numeric_limits<double>::infinity();
  s.bonds[0].yield_strength = 3e4;
  Running r(s);
  r.run(run_for(0.5));
  EXPECT_LT(r.position().y - 0.5, 1e-4) << "23.5 kPa do not make it yield";
  r.model.gravity.y = 35.0;  // 84 kPa: it flows
  r.run(run_for(0.05));
  const double wide = r.state.bonds.history[0].plastic;
  EXPECT_GT(wide, 0.01);
  EXPECT_EQ(r.state.bonds.broken, 0u);
  EXPECT_NEAR(r.energies().fracture, wide * 3e4, 0.02 * wide * 3e4);
  r.model.gravity.y = -9.81;
  r.run(run_for(1.0));
  EXPECT_GE(r.state.bonds.history[0].plastic, wide);
  EXPECT_NEAR(r.position().y - 0.5, 0.0, 2e-5) << "the faces meet; the stretched bar hangs slack";
}

TEST(Bond, ShearsOffAtItsCohesionAndThenRubs) {
  const auto slid = [](double cohesion) {
    Scene s = scenes::scene(0.4, 1e9);
    s.gravity = {8.0, -9.81};
    s.bodies.push_back(scenes::block(1.0, 0.1, {0.0, 0.1}));
    s.terrains.push_back(scenes::ground());
    Bond b = bed_joint(1.0);
    b.cohesion = cohesion;
    b.friction_coefficient = 0.4;
    s.bonds.push_back(b);
    Running r(s);
    r.run(run_for(1.0));
    return std::pair(r.position().x, r.state.bonds.broken);
  };
  const double per_area = 2400.0 * 0.2;
  const double needed = per_area * (8.0 - 0.4 * 9.81);
  EXPECT_LT(slid(2.2 * needed).first, 1e-3);
  const auto [far, broken] = slid(0.3 * needed);
  EXPECT_EQ(broken, 2u);
  EXPECT_NEAR(far, 0.5 * (8.0 - 0.4 * 9.81), 0.02) << "as Coulomb says from then on";
}

// Once the bond has gone, the faces touch like any others.
TEST(Bond, LeavesAContactBehind) {
  Scene s = hanging(1e3, 9.81);
  Running r(s);
  r.run(run_for(0.3));
  ASSERT_EQ(r.state.bonds.broken, 2u);
  r.model.gravity.y = -9.81;
  r.run(run_for(3.0));
  EXPECT_NEAR(r.position().y, 0.5, 1e-3);
  EXPECT_NEAR(r.velocity().y, 0.0, 1e-6);
}

// A block on a table's top, bonded to it, pushed sideways.
Scene on_a_table(double cohesion, double friction) {
  Scene s = scenes::scene(friction, 1e9);
  s.bodies.push_back(scenes::block(0.2, 0.1, {0.0, 0.1}));
  s.bodies[0].velocity = {4.0, 0.0};
  s.terrains.push_back(scenes::ground(1.0));
  Bond b = bed_joint(0.2);
  b.cohesion = b.tensile_strength = cohesion;
  b.friction_coefficient = 0.9;
  s.bonds.push_back(b);
  return s;
}

TEST(Bond, ThatBrokeDoesNothingAnyMore) {
  Running bonded(on_a_table(10.0, 0.1));
  Scene without = on_a_table(10.0, 0.1);
  without.bonds.clear();
  Running free(without);
  bonded.run(run_for(1.0)), free.run(run_for(1.0));
  EXPECT_EQ(bonded.state.bonds.broken, 2u);
  EXPECT_NEAR(bonded.position().x, free.position().x, 0.01) << "the material's friction, not the bond's";
  EXPECT_LT(bonded.position().y, -1.0) << "it has fallen off the table";
  EXPECT_NEAR(bonded.position().y, free.position().y, 0.02);
  EXPECT_NEAR(plan_steps(bonded.model, bonded.state, run_for(1.0)).step,
              plan_steps(free.model, free.state, run_for(1.0)).step, 1e-9);
}

// Validation case B07: without strength to speak of the joint is that of a dry block, b/h.
TEST(Bond, ThatCracksTurnsAboutTheEdge) {
  const auto falls = [](double acceleration) {
    Scene s = scenes::scene(0.8, 1e9);
    s.bodies.push_back(scenes::block(0.5, 3.0, {0.0, 3.0}));
    s.terrains.push_back(scenes::ground());
    Bond b = bed_joint(0.5);
    b.tensile_strength = 1.0;
    b.cohesion = 1e6;
    s.bonds.push_back(b);
    Running r(s);
    EXPECT_TRUE(settle(r.model, r.state).settled);
    for (int k = 1; k <= 20; ++k) {
      r.model.gravity.x = acceleration * 9.81 * k / 20.0;
      r.run(run_for(0.1));
    }
    const RunOutcome end = r.run(run_for(6.0));
    EXPECT_EQ(end.outcome, Outcome::completed) << end.detail;
    return std::abs(r.angle()) > 0.5;
  };
  EXPECT_FALSE(falls(0.162));
  EXPECT_TRUE(falls(0.171));
}

// Of the points that bear, by what the bodies' material would give them.
double share_of_damping(const Running& r) {
  const ContactPoints& points = r.state.contacts.points;
  double least = std::numeric_limits<double>::infinity();
  for (const ContactPair& pair : r.state.contacts.pairs()) {
    if (!pair.active) continue;
    const auto frames = frames_of(r.model, r.state);
    const Index i = pair.first_point;
    const PointStiffness material = point_stiffness(r.model, frames, pair.manifold, pair.manifold.features[0],
                                                    pair.manifold.length, pair.bodies);
    const PointStiffness law = points.stiffness(i);
    least = std::min(least,
                     law.normal_damping / material.normal_damping * std::sqrt(material.normal / law.normal));
  }
  return least;
}

TEST(Bond, ThatYieldedHasItsCrackDampedAsItself) {
  Scene s = hanging(1e9, 35.0);
  s.bonds[0].tensile_strength = std::numeric_limits<double>::infinity();
  s.bonds[0].yield_strength = 3e4;
  s.bonds[0].damping_ratio = 0.03;
  Running r(s);
  const double sound = plan_steps(r.model, r.state, run_for(1.0)).bound;
  r.run(run_for(0.02));
  r.model.gravity.y = -9.81;
  r.run(run_for(1.0));
  EXPECT_GT(r.state.bonds.history[0].plastic, 0.0);
  EXPECT_NEAR(share_of_damping(r), 0.03, 1e-6);
  EXPECT_GT(plan_steps(r.model, r.state, run_for(1.0)).bound, 0.5 * sound);
}

TEST(Bond, ThatBrokeAfterwardsLeavesItsCrackToTheMaterials) {
  Scene s = hanging(1e5, 0.0, 250.0);
  s.bonds[0].damping_ratio = 0.03;
  s.bodies[0].velocity.y = 0.2;  // 48 J, of 250 that break it
  Running r(s);
  r.run(run_for(0.01));
  ASSERT_EQ(r.state.bonds.broken, 0u);
  EXPECT_NEAR(share_of_damping(r), 0.03, 1e-6);
  r.model.gravity.y = 60.0;
  for (int k = 0; k < 100 && r.state.bonds.broken < 2; ++k) r.run(run_for(0.001));
  ASSERT_EQ(r.state.bonds.broken, 2u);
  r.run(run_for(0.001));
  EXPECT_NEAR(share_of_damping(r), 1.0, 1e-6) << "it is still near";
  r.model.gravity.y = -60.0;
  r.run(run_for(0.5));
  EXPECT_NEAR(share_of_damping(r), 1.0, 1e-6);
}

// A block on the ground, bonded to it at a tenth of its face.
Scene partly_bonded() {
  Scene s = hanging(1e6, -9.81);
  s.bonds[0].start = {0.3, 0.0}, s.bonds[0].end = {0.4, 0.0};
  s.bonds[0].yield_strength = 1e4;
  return s;
}

TEST(Bond, OnAPartOfTheFaceLeavesTheRestDampedByTheMaterials) {
  Running r(partly_bonded());
  r.run(run_for(0.1));
  EXPECT_NEAR(share_of_damping(r), 1.0, 1e-6);
}

TEST(Bond, OnAPartOfTheFaceLeavesTheRestInContact) {
  Running r(partly_bonded());
  r.run(run_for(1.0));
  EXPECT_NEAR(r.position().y, 0.5, 1e-4);
  EXPECT_NEAR(r.angle(), 0.0, 1e-4);
}

TEST(Bond, ThatIsWeakerThanItsYieldStrengthBreaks) {
  const double stress = 2400.0 * 9.81;
  Scene s = hanging(0.5 * stress, 9.81);
  s.bonds[0].yield_strength = 0.7 * stress;
  Running r(s);
  r.run(run_for(0.5));
  EXPECT_EQ(r.state.bonds.broken, 2u);
}

// Verlet's velocities at the ends of steps hold a quarter of a vibration's energy too much at half the bound.
TEST(Bonds, ThatVibrateAtHalfTheBoundKeepTheLedgerToRounding) {
  Scene s = hanging(1e9, 9.81);
  s.bonds[0].damping_ratio = 0.0;
  Running r(s);
  const double start = r.energies().balance();
  double swung = 0.0, error = 0.0, stagger = 0.0;
  const RunOutcome end = r.run(run_for(0.05, 2e-4), [&](const Sample&) {
    const Energies e = r.energies();
    swung = std::max(swung, e.elastic), error = std::max(error, std::abs(e.balance() - start));
    stagger = std::max(stagger, std::abs(e.stagger));
    return Wish::go_on;
  });
  EXPECT_EQ(end.outcome, Outcome::completed) << end.detail;
  EXPECT_GT(stagger, 1e-3 * swung);
  EXPECT_LT(error, 1e-9 * swung);
}

// Five blocks on each other, bonded by that law, on a ground that shakes with so much (m/s2).
Scene shaken_stack(double a, Bond law) {
  Scene s = scenes::scene(0.6, 1e9);
  for (int i = 0; i < 5; ++i) s.bodies.push_back(scenes::block(0.25, 0.5, {0.0, 0.5 + i}));
  s.terrains.push_back(scenes::ground(
      200.0, {}, 0.0,
      scenes::horizontal_motion([a](double t) { return a * std::sin(6.28 * t); },
                                [a](double t) { return a / 6.28 * (1.0 - std::cos(6.28 * t)); },
                                [a](double t) { return a / 6.28 * (t - std::sin(6.28 * t) / 6.28); })));
  law.damping_ratio = 0.05;
  for (std::size_t i = 0; i < 5; ++i) {
    law.name = "joint " + std::to_string(i);
    law.a = i == 0 ? Owner{true, 0} : Owner{false, i - 1};
    law.b = {false, i};
    law.start = {-0.25, static_cast<double>(i)}, law.end = {0.25, static_cast<double>(i)};
    s.bonds.push_back(law);
  }
  return s;
}

// Five bonded blocks shaken to pieces: what the cracked faces stored passes to the contacts.
TEST(Bonds, ThatBreakUnderShakingKeepTheLedger) {
  Bond law;
  law.tensile_strength = 1e5, law.cohesion = 2e5;
  Running r(shaken_stack(20.0, law));
  ASSERT_TRUE(settle(r.model, r.state).settled);
  const double start = r.energies().balance();
  const RunOutcome end = r.run(run_for(2.0));
  ASSERT_EQ(end.outcome, Outcome::completed) << end.detail;
  EXPECT_GE(r.state.bonds.broken, 2u);
  const Energies e = r.energies();
  EXPECT_GT(e.fracture, 0.0);
  EXPECT_NEAR(e.balance(), start, 0.02 * e.input);
}

// Torn off while it turns: both points are pulled when the first breaks, so they store nothing in
// compression, but the corner beyond them overlaps. It must bear the block when it comes down.
TEST(Bond, ThatTearsWhileItsCornerIsPressedLeavesTheCornerHard) {
  Scene s = scenes::scene(0.6, 1e9);
  s.bodies.push_back(scenes::block(0.5, 0.5, {0.0, 0.5}));
  s.bodies[0].velocity = {0.0, 0.2};
  s.bodies[0].spin = 0.5;
  s.terrains.push_back(scenes::ground(20.0));
  Bond b;
  b.name = "torn";
  b.a = {true, 0}, b.b = {false, 0};
  b.start = {-0.5, 0.0}, b.end = {0.5, 0.0};
  b.tensile_strength = 1e4;
  s.bonds.push_back(b);
  Running r(s);
  const RunOutcome end = r.run(run_for(1.0));
  ASSERT_EQ(end.outcome, Outcome::completed) << end.detail;
  EXPECT_GE(r.state.bonds.broken, 1u);
  EXPECT_LT(r.state.deepest_ratio, 1e-3) << "of a block 1 m wide that comes down at 0.2 m/s";
}

TEST(Bonds, KeepMomentumAndEnergy) {
  Cantilever c;
  c.count = 4;
  Scene s = c.scene();
  s.bonds.erase(s.bonds.begin());  // free of the wall
  s.terrains.clear();
  for (std::size_t i = 0; i < 4; ++i) s.bodies[i].velocity = {0.0, 0.5 * static_cast<double>(i)};
  for (Bond& b : s.bonds) b.damping_ratio = 0.0;
  Running r(s);
  const Vec2 linear = momentum(r);
  const double angular = angular_momentum(r, {});
  const Energies start = r.energies();
  DriveOptions options = run_for(1.0);
  options.step_fraction = 0.1;
  r.run(options);
  EXPECT_NEAR(norm(momentum(r) - linear), 0.0, 1e-9 * r.model.mass[0]);
  EXPECT_NEAR(angular_momentum(r, {}), angular, 1e-9 * r.model.mass[0]);
  EXPECT_NEAR(r.energies().balance(), start.balance(), 2e-3 * start.kinetic);
  EXPECT_NEAR(r.energies().fracture, 0.0, 1e-3 * start.kinetic);
}

// A block of 2.4 t that comes down at 0.5 m/s on a joint without weight: its 300 J, less what the joint
// stores at its strength, are the work of f_c A over the closing that stays.
TEST(Bond, IsCrushedAtItsStrengthTimesItsArea) {
  Scene s = hanging(1e9, 0.0);
  s.bonds[0].damping_ratio = 0.0;
  s.bonds[0].compressive_strength = 1e5;
  s.bodies[0].velocity.y = -0.5;
  Running r(s);
  DriveOptions options = run_for(0.02);
  options.step_fraction = 0.05;
  const double start = r.energies().balance();
  r.run(options);
  const double stiffness = 1e9 / 0.5, force = 1e5, stored = 0.5 * force * force / stiffness;
  const double closing = (300.0 - stored) / force;
  for (const BondHistory& point : r.state.bonds.history) EXPECT_NEAR(point.crushed, closing, 1e-3 * closing);
  EXPECT_NEAR(r.energies().fracture, force * closing, 2e-3 * force * closing);
  EXPECT_NEAR(r.energies().balance(), start, 1e-3 * start);
  EXPECT_EQ(r.state.bonds.broken, 0u);
}

// Under weight alone it stands below its strength; above it falls with what the strength leaves of gravity.
TEST(Bond, BearsTheWeightOfItsStrengthAndNoMore) {
  const double stress = 2400.0 * 9.81, time = 0.2;
  Scene strong = hanging(1e9, -9.81), weak = strong;
  strong.bonds[0].compressive_strength = stress / 0.98;
  weak.bonds[0].compressive_strength = stress / 1.25;
  Running stands(strong), sinks(weak);
  EXPECT_TRUE(settle(stands.model, stands.state).settled);
  stands.run(run_for(time)), sinks.run(run_for(time));
  for (const BondHistory& point : stands.state.bonds.history) EXPECT_EQ(point.crushed, 0.0);
  EXPECT_LT(0.5 - stands.position().y, 2e-5);
  const double fallen = 0.5 * (1.0 - 1.0 / 1.25) * 9.81 * time * time;
  EXPECT_NEAR(0.5 - sinks.position().y, fallen, 0.05 * fallen);
}

// Weight of 1.5 F_c, F_c = f_c A/2, on two points at +-L/(2 sqrt 3): one bears F_c, the other 0.5 F_c, and
// their moment is (2 F_c - N) L/(2 sqrt 3), that of a = 0.0321 g at the centroid 3 m up.
TEST(Bond, ThatIsPressedBendsToTheMomentOfItsBlocksOfStress) {
  const double weight = 2400.0 * 6.0 * 9.81, strength = weight / 0.75, point = 0.5 * strength;
  const double limit = (2.0 * point - weight) / (2.0 * std::sqrt(3.0)) / (3.0 * 2400.0 * 6.0);
  const auto falls = [&](double acceleration) {
    Scene s = scenes::scene(0.8, 1e10);
    s.bodies.push_back(scenes::block(0.5, 3.0, {0.0, 3.0}));
    s.terrains.push_back(scenes::ground());
    Bond b = bed_joint(0.5);
    b.compressive_strength = strength;
    s.bonds.push_back(b);
    Running r(s);
    EXPECT_TRUE(settle(r.model, r.state).settled);
    for (int k = 1; k <= 20; ++k) {
      r.model.gravity.x = acceleration * k / 20.0;
      r.run(run_for(0.05));
    }
    EXPECT_EQ(r.run(run_for(4.0)).outcome, Outcome::completed);
    return std::abs(r.angle()) > 0.05;
  };
  EXPECT_FALSE(falls(0.96 * limit));
  EXPECT_TRUE(falls(1.04 * limit));
}

// A column of five blocks shaken until its lowest joints crush: what the ledger books is what is missing.
TEST(Bonds, ThatCrushUnderShakingKeepTheLedger) {
  Bond law;
  law.compressive_strength = 5e5;
  Running r(shaken_stack(4.0, law));
  ASSERT_TRUE(settle(r.model, r.state).settled);
  const double start = r.energies().balance();
  const RunOutcome end = r.run(run_for(2.0));
  ASSERT_EQ(end.outcome, Outcome::completed) << end.detail;
  double crushed = 0.0, work = 0.0;
  for (std::size_t i = 0; i < r.state.bonds.history.size(); ++i) {
    crushed += r.state.bonds.history[i].crushed;
    work += r.state.bonds.history[i].crushed * r.model.bond_points[i].law.crushing;
  }
  EXPECT_GT(crushed, 1e-6);
  const Energies e = r.energies();
  EXPECT_NEAR(e.fracture, work, 0.02 * work);
  EXPECT_NEAR(e.balance(), start, 0.02 * e.input);
}

// A strength that is never reached gives what none gives, bit for bit.
TEST(Bond, ThatIsNotCrushedDoesNotKnowItsStrength) {
  const auto end_of = [](double strength) {
    Scene s = hanging(2e4, 60.0, 50.0);
    s.bodies[0].velocity = {0.1, -0.3};
    s.bodies[0].spin = 0.2;
    s.bonds[0].compressive_strength = strength;
    Running r(s);
    r.run(run_for(0.5));
    return std::vector<double>(r.state.y.begin(), r.state.y.end());
  };
  EXPECT_EQ(end_of(1e12), end_of(std::numeric_limits<double>::infinity()));
}

TEST(Bonds, RefuseWhatMakesNoSense) {
  const auto refused = [](auto change) {
    Scene s = hanging(1e5, 9.81);
    change(s.bonds[0]);
    return scenes::refusal_of(s);
  };
  EXPECT_EQ(refused([](Bond&) {}), "accepted");
  EXPECT_THAT(refused([](Bond& b) { b.b.index = 3; }), HasSubstr("bed joint: there is no body number 3"));
  EXPECT_THAT(refused([](Bond& b) { b.end = b.start; }), HasSubstr("no length"));
  EXPECT_THAT(refused([](Bond& b) { b.normal_stiffness = 0.0; }), HasSubstr("normal stiffness"));
  EXPECT_THAT(refused([](Bond& b) { b.tensile_strength = -1.0; }), HasSubstr("tensile strength"));
  EXPECT_THAT(refused([](Bond& b) { b.compressive_strength = 0.0; }), HasSubstr("compressive strength"));
  EXPECT_THAT(refused([](Bond& b) { b.tensile_strength = 0.0, b.fracture_energy = 1.0; }),
              HasSubstr("fracture"));
}

}  // namespace
}  // namespace dougong::engine
