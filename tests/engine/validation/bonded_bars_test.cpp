// Validation cases B01 (cantilever), B03 (portal frame) and B07 (bonded wall): bars and walls of bonded
// blocks.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <cmath>
#include <numbers>

#include "engine/modes.h"
#include "engine/settle.h"
#include "tests/engine/reference.h"
#include "tests/oracles/portal.h"
#include "tests/scenes/bonded_bars.h"
#include "tests/scenes/running.h"

namespace dougong::engine {
namespace {

using scenes::add_bar;
using scenes::BondedBar;
using scenes::Running;
using testing::expect_relative;

constexpr Owner wall_owner{true, 0};

Scene held_by_a_wall() {
  Scene s = scenes::scene(0.6, 1e9);
  s.gravity = {};
  Terrain wall;
  wall.name = "wall";
  wall.shape = make_rectangle(1.0, 100.0);
  wall.position = {-0.5, 0.0};
  s.terrains.push_back(wall);
  return s;
}

// Displacements and turns under forces and moments [x | y | angle], from the tangent.
Eigen::VectorXd displaced(const Running& r, const Eigen::VectorXd& load) {
  return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(tangent_stiffness(r.model, r.state)).solve(load);
}

struct Cantilever {
  double length, depth, modulus, poisson_ratio, density;
  double shear_modulus() const { return 5.0 / 6.0 * 0.5 * modulus / (1.0 + poisson_ratio); }
  double second_moment() const { return depth * depth * depth / 12.0; }
  double tip(double force) const {
    return force * (length * length * length / (3.0 * modulus * second_moment()) +
                    length / (shear_modulus() * depth));
  }
};

Running cut(const Cantilever& c, int count) {
  Scene s = held_by_a_wall();
  const BondedBar bar{c.depth, c.modulus, c.shear_modulus(), c.density, count, {0.0, 0.0}, {c.length, 0.0}};
  add_bar(s, bar, &wall_owner, nullptr);
  return Running(s);
}

double tip_of(const Running& r, const Cantilever& c, double force) {
  const auto n = static_cast<Eigen::Index>(r.bodies());
  const double to_the_end = 0.5 * c.length / static_cast<double>(n);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(3 * n);
  load[2 * n - 1] = force, load[3 * n - 1] = force * to_the_end;
  const Eigen::VectorXd u = displaced(r, load);
  return u[2 * n - 1] + to_the_end * u[3 * n - 1];
}

// Frequencies (Hz) of the modes that move across the bar.
std::vector<double> frequencies_of(const Running& r) {
  const auto n = static_cast<Eigen::Index>(r.bodies());
  Eigen::VectorXd mass(3 * n);
  for (Eigen::Index i = 0; i < n; ++i) {
    mass[i] = mass[n + i] = r.model.mass[static_cast<std::size_t>(i)];
    mass[2 * n + i] = r.model.inertia[static_cast<std::size_t>(i)];
  }
  const Eigen::MatrixXd k(tangent_stiffness(r.model, r.state)), m(mass.asDiagonal());
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(k, m);
  std::vector<double> hertz;
  for (Eigen::Index j = 0; j < 3 * n && hertz.size() < 3; ++j) {
    const auto shape = modes.eigenvectors().col(j);
    if (shape.segment(n, n).norm() > shape.head(n).norm())
      hertz.push_back(std::sqrt(modes.eigenvalues()[j]) / (2.0 * std::numbers::pi));
  }
  return hertz;
}

struct KnownChain {
  int count;
  double tip;
  std::array<double, 3> hertz;
};

// Per number of blocks, the tip and the frequencies of the chain of rigid blocks itself.
constexpr KnownChain chains[] = {{5, 0.01642368, {5.082914, 29.39675, 75.67149}},
                                 {10, 0.01618944, {5.151685, 30.64264, 80.25189}},
                                 {20, 0.01613232, {5.169174, 30.97813, 81.57232}},
                                 {40, 0.01611876, {5.173565, 31.06352, 81.9142}},
                                 {80, 0.01611573, {5.174664, 31.08496, 82.00039}}};

constexpr Cantilever chains_of{10.0, 1.0, 25e9, 0.2, 2400.0};

TEST(BondedBar, BendsAndVibratesAsTheChainOfItsBlocks) {
  const Cantilever& c = chains_of;
  for (const KnownChain& known : chains) {
    const Running r = cut(c, known.count);
    const std::string name = "N = " + std::to_string(known.count) + " ";
    expect_relative("B01", name + "tip (m)", known.tip, tip_of(r, c, 1e5), 1e-5);
    const auto hertz = frequencies_of(r);
    for (std::size_t j = 0; j < 3; ++j)
      expect_relative("B01", name + "frequency " + std::to_string(j + 1) + " (Hz)", known.hertz[j], hertz[j],
                      1e-5);
  }
}

// The chain itself: at each face the moment bends, and the force shears, what its two half blocks hold.
double chain_tip(const Cantilever& c, int count, double force) {
  const double l = c.length / count;
  double tip = 0.0;
  for (int i = 0; i < count; ++i) {
    const double arm = c.length - i * l, spring = i == 0 ? 0.5 * l : l;
    tip +=
        force * spring * (arm * arm / (c.modulus * c.second_moment()) + 1.0 / (c.shear_modulus() * c.depth));
  }
  return tip;
}

TEST(BondedBar, BendsAsAnyOtherChainToo) {
  const Cantilever stocky{4.0, 1.2, 10e9, 0.3, 2000.0};
  EXPECT_NEAR(chain_tip(chains_of, 5, 1e5) / chains[0].tip, 1.0, 1e-6);
  for (const int count : {3, 12, 30})
    expect_relative("B01 stocky", "N = " + std::to_string(count) + " tip (m)", chain_tip(stocky, count, 2e5),
                    tip_of(cut(stocky, count), stocky, 2e5), 1e-6);
  expect_relative("B01", "tip of 80 blocks against Timoshenko (m)", chains_of.tip(1e5),
                  tip_of(cut(chains_of, 80), chains_of, 1e5), 2e-3);
}

// The distances between the frequencies of ever shorter blocks fall with the square of their length.
void check_order(const std::string& name, const Cantilever& c) {
  std::vector<double> first;
  for (const int count : {10, 20, 40, 80}) first.push_back(frequencies_of(cut(c, count))[0]);
  for (std::size_t i = 2; i < first.size(); ++i)
    testing::expect_absolute(name, "order of the first frequency", 2.0,
                             std::log2((first[i - 1] - first[i - 2]) / (first[i] - first[i - 1])), 0.1);
}

TEST(BondedBar, ConvergesWithOrderTwo) {
  check_order("B01", chains_of);
  check_order("B01 stocky", {4.0, 1.2, 10e9, 0.3, 2000.0});
  expect_relative("B01", "first frequency of 80 blocks against Timoshenko (Hz)", 5.17503,
                  frequencies_of(cut(chains_of, 80))[0], 2e-3);
}

oracles::Bar rectangular(double depth, double thickness) {
  return {depth * thickness, thickness * depth * depth * depth / 12.0};
}

// Two columns and a beam of bonded blocks, whose axes meet in a small rigid block at each corner.
double portal_stiffness(double height, double span, double column_depth, double beam_depth, int count) {
  Scene s = held_by_a_wall();
  s.terrains[0].shape = make_rectangle(100.0, 1.0);
  s.terrains[0].position = {0.0, -0.5};
  std::size_t corner[2];
  for (const int side : {0, 1}) {
    corner[side] = s.bodies.size();
    s.bodies.push_back(scenes::block(0.2, 0.2, {(side - 0.5) * span, height}));
    s.bodies.back().collides = false;
  }
  const auto at = [&](int side) { return Owner{false, corner[side]}; };
  const double modulus = 30e9;
  for (const int side : {0, 1}) {
    const Owner top = at(side);
    const double x = (side - 0.5) * span;
    add_bar(s, {column_depth, modulus, 0.0, 2400.0, count, {x, 0.0}, {x, height}}, &wall_owner, &top);
  }
  const Owner left = at(0), right = at(1);
  add_bar(s, {beam_depth, modulus, 0.0, 2400.0, 2 * count, {-0.5 * span, height}, {0.5 * span, height}},
          &left, &right);
  const Running r(s);
  const auto n = static_cast<Eigen::Index>(r.bodies());
  Eigen::VectorXd load = Eigen::VectorXd::Zero(3 * n);
  load[static_cast<Eigen::Index>(corner[0])] = 1.0;
  return 1.0 / displaced(r, load)[static_cast<Eigen::Index>(corner[0])];
}

// The bars are 1 m thick.
TEST(BondedPortal, IsAsStiffAsTheFrame) {
  const oracles::Portal published{3.0, 6.0, 30e9, rectangular(0.4, 0.4), rectangular(0.5, 0.4)};
  EXPECT_NEAR(published.stiffness() / 3.910644e7, 1.0, 1e-5);
  const auto check = [](double height, double span, double column_depth, double beam_depth) {
    const oracles::Portal frame{height, span, 30e9, rectangular(column_depth, 1.0),
                                rectangular(beam_depth, 1.0)};
    expect_relative("B03", "stiffness of " + testing::text(height) + " x " + testing::text(span) + " m (N/m)",
                    frame.stiffness(), portal_stiffness(height, span, column_depth, beam_depth, 40), 2e-3);
  };
  check(3.0, 6.0, 0.4, 0.5);
  check(4.0, 5.0, 0.3, 0.6);
  check(2.5, 8.0, 0.6, 0.4);
}

// A wall bonded to the ground, and the push to the side (of its weight) at which the joint first cracks.
struct Wall {
  double width, height, density, strength;
  double opens() const {  // g, 3 rho a H2/b = f + rho g H
    return (strength / (density * 9.81) + height) * width / (3.0 * height * height);
  }
};

Scene pushed(const Wall& w, double part) {
  Scene s = scenes::scene(0.8, 5e9);
  s.materials[0].density = w.density;
  s.gravity.x = part * 9.81;
  s.bodies.push_back(scenes::block(0.5 * w.width, 0.5 * w.height, {0.0, 0.5 * w.height}));
  s.terrains.push_back(scenes::ground());
  Bond joint;
  joint.name = "base";
  joint.a = {true, 0}, joint.b = {false, 0};
  joint.start = {-0.5 * w.width, 0.0}, joint.end = {0.5 * w.width, 0.0};
  joint.tensile_strength = w.strength, joint.cohesion = 1e8;
  s.bonds.push_back(joint);
  return s;
}

// What overturns as well has cracked before.
bool cracks(const Wall& w, double part) {
  Running r(pushed(w, part));
  SettleOptions options;
  options.unbalanced_ratio = 1e-6, options.longest_movement = 0.1 * w.width;
  const SettleReport report = settle(r.model, r.state, options);
  EXPECT_TRUE(report.settled || r.state.bonds.broken > 0) << part;
  return r.state.bonds.broken > 0;
}

void check_cracking(const std::string& name, const Wall& w) {
  double sound = 0.0, cracked = 3.0 * w.opens();
  while (cracked - sound > 1e-4 * cracked) {
    const double part = 0.5 * (sound + cracked);
    (cracks(w, part) ? cracked : sound) = part;
  }
  expect_relative(name, "push that opens the base (g)", w.opens(), 0.5 * (sound + cracked), 5e-3);
}

TEST(BondedWall, OpensWhereTheStressAtItsEdgeReachesTheStrength) {
  const Wall published{1.0, 6.0, 2000.0, 1e5};
  EXPECT_NEAR(published.opens(), 0.102749, 1e-6);
  check_cracking("B07", published);
  check_cracking("B07 decompression", {1.0, 6.0, 2000.0, 1e-3});
  check_cracking("B07 thick", {1.5, 4.0, 1800.0, 3e5});
}

}  // namespace
}  // namespace dougong::engine
