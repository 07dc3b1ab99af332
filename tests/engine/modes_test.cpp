#include "engine/modes.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "engine/settle.h"
#include "tests/scenes/running.h"

namespace dougong::engine {
namespace {

using scenes::Running;

Running settled(const Scene& s) {
  Running r(s);
  SettleOptions options;
  options.unbalanced_ratio = 1e-8;
  EXPECT_TRUE(settle(r.model, r.state, options).settled);
  return r;
}

// Contact forces and torques in the order of the coordinates, without dashpots.
Eigen::VectorXd forces_at(const Running& r) {
  ContactPoints points = r.state.contacts.points;
  std::vector<PairLoad> loads(points.load_count());
  contact_forces(points, frames_of(r.model, r.state), false, loads);
  std::vector<Vec2> forces(r.model.size());
  std::vector<double> torques(r.model.size());
  r.state.contacts.gather(loads, forces, torques);
  const std::size_t n = r.bodies();
  Eigen::VectorXd f(3 * n);
  for (std::size_t i = 0; i < n; ++i) {
    f[static_cast<Eigen::Index>(i)] = forces[i].x;
    f[static_cast<Eigen::Index>(n + i)] = forces[i].y;
    f[static_cast<Eigen::Index>(2 * n + i)] = torques[i];
  }
  return f;
}

// Two columns, a lintel and a block on it: no contact is at the point of opening.
Scene trilith() {
  Scene s = scenes::scene(0.6, 1e8);
  s.bodies = {scenes::block(0.2, 0.5, {-1.0, 0.5}), scenes::block(0.2, 0.5, {1.0, 0.5}),
              scenes::block(1.4, 0.1, {0.0, 1.1}), scenes::block(0.2, 0.2, {0.3, 1.4})};
  s.terrains.push_back(scenes::ground());
  return s;
}

// Three blocks, each on a wider one: no corner stands over another, where the length of contact has a kink.
Scene stepped_column() {
  Scene s = scenes::column(3, 0.25, 0.4, 0.6, 1e8);
  s.bodies[1].shape = make_rectangle(0.4, 0.8);
  s.bodies[2].shape = make_rectangle(0.3, 0.8);
  return s;
}

TEST(TangentStiffness, IsTheDerivativeOfTheForces) {
  for (const Scene& scene : {stepped_column(), trilith()}) {
    Running r = settled(scene);
    const Eigen::MatrixXd k(tangent_stiffness(r.model, r.state));
    const double scale = k.cwiseAbs().maxCoeff(), step = 1e-8;
    for (Eigen::Index c = 0; c < k.cols(); ++c) {
      const double here = r.state.q()[static_cast<std::size_t>(c)];
      r.state.q()[static_cast<std::size_t>(c)] = here + step;
      const Eigen::VectorXd above = forces_at(r);
      r.state.q()[static_cast<std::size_t>(c)] = here - step;
      const Eigen::VectorXd below = forces_at(r);
      r.state.q()[static_cast<std::size_t>(c)] = here;
      for (Eigen::Index row = 0; row < k.rows(); ++row)
        EXPECT_NEAR(k(row, c), -(above[row] - below[row]) / (2.0 * step), 1e-6 * scale) << row << "," << c;
    }
  }
}

// A block on two corners: sway and rocking are coupled through the springs at the base, with the
// weight's overturning moment. Two coordinates, by hand.
double sway_frequency_squared(double b, double h, double young_modulus, double density, double g) {
  const double m = density * 4.0 * b * h, i = m * (b * b + h * h) / 3.0;
  const double k = young_modulus / h * b, kt = k * 0.5 / 1.2;  // of each of the two corners
  const double kxx = 2.0 * kt, kxr = 2.0 * kt * h;
  const double krr = 2.0 * kt * h * h + 2.0 * k * b * b - m * g * h;
  const double a = m * i, bb = -(kxx * i + krr * m), c = kxx * krr - kxr * kxr;
  return (-bb - std::sqrt(bb * bb - 4.0 * a * c)) / (2.0 * a);
}

TEST(HorizontalModes, OfABlockAreThoseByHand) {
  for (const auto& [b, h, e] :
       {std::tuple{0.25, 1.0, 1e9}, std::tuple{0.5, 0.4, 1e8}, std::tuple{0.25, 2.0, 1e7}}) {
    const Running r = settled(scenes::block_on_ground(b, h, 0.6, e));
    const std::vector<Mode> modes = horizontal_modes(r.model, r.state);
    ASSERT_GE(modes.size(), 2u);
    const double by_hand = sway_frequency_squared(b, h, e, 2400.0, 9.81);
    EXPECT_NEAR(modes[0].angular_frequency_squared / by_hand, 1.0, 2e-3) << b << " " << h;
    EXPECT_NEAR(modes[0].period(), 2.0 * std::numbers::pi / std::sqrt(modes[0].angular_frequency_squared),
                1e-15);
    double participation = 0.0;
    for (const Mode& mode : modes) participation += mode.participation;
    EXPECT_NEAR(participation, 1.0, 1e-6);
  }
}

TEST(HorizontalModes, AreSlowedByTheWeight) {
  double last = 1.0;
  for (const double h : {0.5, 1.0, 2.0}) {
    Scene s = scenes::block_on_ground(0.25, h, 0.6, 1e7);
    const Running heavy = settled(s);
    s.gravity = {0.0, -9.81e-3};
    const Running light = settled(s);
    const double ratio = horizontal_modes(heavy.model, heavy.state)[0].angular_frequency_squared /
                         horizontal_modes(light.model, light.state)[0].angular_frequency_squared;
    EXPECT_LT(ratio, last) << h;
    last = ratio;
  }
  EXPECT_LT(last, 0.95);
}

// All modes at once against a dense decomposition.
TEST(HorizontalModes, AreTheLowestOnesThatAHorizontalMotionExcites) {
  const Running r = settled(scenes::column(4, 0.25, 0.3, 0.6, 1e9));
  const auto n = static_cast<Eigen::Index>(r.bodies());
  Eigen::MatrixXd k(tangent_stiffness(r.model, r.state));
  Eigen::VectorXd root(3 * n);
  for (Eigen::Index i = 0; i < n; ++i) {
    root[i] = root[n + i] = std::sqrt(r.model.mass[static_cast<std::size_t>(i)]);
    root[2 * n + i] = std::sqrt(r.model.inertia[static_cast<std::size_t>(i)]);
  }
  k = root.cwiseInverse().asDiagonal() * k * root.cwiseInverse().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> exact(0.5 * (k + k.transpose()));
  std::vector<double> excited;
  for (Eigen::Index j = 0; j < 3 * n; ++j) {
    const double participation = root.head(n).dot(exact.eigenvectors().col(j).head(n));
    if (participation * participation > 1e-4 * r.model.total_mass())
      excited.push_back(exact.eigenvalues()[j]);
  }
  const std::vector<Mode> modes = horizontal_modes(r.model, r.state, 12);
  ASSERT_GE(excited.size(), 2u);
  for (std::size_t j = 0; j < 2; ++j) {
    bool found = false;
    for (const Mode& mode : modes)
      found |= std::abs(mode.angular_frequency_squared / excited[j] - 1.0) < 1e-6;
    EXPECT_TRUE(found) << j;
  }
  EXPECT_NEAR(modes[0].angular_frequency_squared / excited[0], 1.0, 1e-6);
}

}  // namespace
}  // namespace dougong::engine
