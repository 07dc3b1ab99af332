#include "engine/stability.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cstdio>

#include "engine/integrators/table.h"
#include "tests/engine/collision/scenes.h"
#include "tests/scenes/running.h"

namespace dougong::engine {
namespace {

using scenes::Running;

struct Largest {
  double stiffness, damping;
};

// Largest eigenvalues of M^-1 K and M^-1 C with every contact point stuck, by a dense decomposition.
Largest exact_spectrum(const Running& r) {
  const auto n = static_cast<Eigen::Index>(r.bodies());
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(3 * n, 3 * n), c = k;
  const auto frames = frames_of(r.model, r.state);
  const ContactPoints& points = r.state.contacts.points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PointGeometry g = geometry_of(points, i, frames);
    const PointStiffness law = points.stiffness(i);
    const auto row = [&](Vec2 direction) {
      Eigen::VectorXd j = Eigen::VectorXd::Zero(3 * n);
      const auto add = [&](Index body, double sign, Vec2 arm) {
        if (r.model.is_terrain(body)) return;
        j[3 * body] += sign * direction.x / std::sqrt(r.model.mass[body]);
        j[3 * body + 1] += sign * direction.y / std::sqrt(r.model.mass[body]);
        j[3 * body + 2] += sign * cross(arm, direction) / std::sqrt(r.model.inertia[body]);
      };
      add(points.corner_body[i], 1.0, g.arm_corner);
      add(points.edge_body[i], -1.0, g.arm_edge);
      return j;
    };
    const Eigen::VectorXd jn = row(g.normal), jt = row(turned(g.normal));
    k += law.normal * jn * jn.transpose() + law.tangential * jt * jt.transpose();
    c += law.normal_damping * jn * jn.transpose() + law.tangential_damping * jt * jt.transpose();
  }
  const auto top = [](const Eigen::MatrixXd& m) {
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(m, Eigen::EigenvaluesOnly).eigenvalues().tail(1)[0];
  };
  return {top(k), top(c)};
}

Scene random_stack(unsigned seed) {
  std::mt19937 random(seed);
  Scene s = scenes::scene(0.6, 1e9, testing::uniform(random, 0.0, 2.0));
  double top = 0.0;
  for (int i = 0; i < 6; ++i) {
    const double b = testing::uniform(random, 0.1, 0.6), h = testing::uniform(random, 0.05, 0.4);
    s.bodies.push_back(scenes::block(b, h, {testing::uniform(random, -0.05, 0.05), top + h},
                                     testing::uniform(random, -1e-4, 1e-4)));
    s.bodies.back().thickness = testing::uniform(random, 0.2, 1.0);
    top += 2.0 * h;
  }
  s.terrains.push_back(scenes::ground());
  return s;
}

TEST(SpectralBound, IsNeverBelowTheExactSpectrumAndNotFarAbove) {
  double loosest = 1.0, tightest = 10.0;
  std::vector<Scene> all{scenes::wall(4, 6, 0.6), scenes::column(10, 0.25, 0.25, 0.6),
                         scenes::block_on_ground(1, 0.02, 0.6)};
  for (unsigned seed = 1; seed <= 30; ++seed) all.push_back(random_stack(seed));
  for (const Scene& s : all) {
    const Running r(s);
    const SpectralBound bound = spectral_bound(r.model, r.state, frames_of(r.model, r.state));
    const Largest exact = exact_spectrum(r);
    ASSERT_GT(exact.stiffness, 0.0);
    EXPECT_GE(bound.stiffness, exact.stiffness * (1.0 - 1e-12));
    EXPECT_GE(bound.damping, exact.damping * (1.0 - 1e-12));
    EXPECT_LT(bound.stiffness, 4.0 * exact.stiffness);
    for (const char* name : {"velocity-verlet", "symplectic-euler", "rk4"}) {
      const auto step = [&](double w2, double c) {
        return std::visit([&](const auto& i) { return i.stable_step(w2, c); }, make_integrator(name));
      };
      EXPECT_LE(step(bound.stiffness, bound.damping), step(exact.stiffness, exact.damping) * (1.0 + 1e-12));
    }
    const double ratio = std::sqrt(bound.stiffness / exact.stiffness);
    loosest = std::max(loosest, ratio), tightest = std::min(tightest, ratio);
  }
  std::printf("spectral bound over exact frequency: %.4f to %.4f\n", tightest, loosest);
}

TEST(SpectralBound, CountsAContactThatIsAboutToClose) {
  Scene s = scenes::block_on_ground(0.5, 0.2, 0.6);
  const Running touching(s);
  s.bodies[0].position.y += 1e-3;
  const Running near(s);
  EXPECT_NEAR(
      spectral_bound(near.model, near.state, frames_of(near.model, near.state)).stiffness,
      spectral_bound(touching.model, touching.state, frames_of(touching.model, touching.state)).stiffness,
      1e-2 * spectral_bound(near.model, near.state, frames_of(near.model, near.state)).stiffness);
}

TEST(SpectralBound, IsZeroWhereNothingTouches) {
  Scene s = scenes::scene(0.6);
  s.bodies.push_back(scenes::block(0.5, 0.2, {0.0, 5.0}));
  const Running r(s);
  EXPECT_EQ(spectral_bound(r.model, r.state, frames_of(r.model, r.state)).stiffness, 0.0);
}

}  // namespace
}  // namespace dougong::engine
