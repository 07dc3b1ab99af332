// The hot loops give the same bits with every instruction set, and what one point alone gives.
#include "engine/kernels.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "engine/contact/contact_points.h"
#include "engine/sine_cosine.h"
#include "tests/engine/reference.h"
#include "tests/scenes/running.h"
#include "tests/scenes/running_bond.h"

namespace dougong::engine {
namespace {

using scenes::Running;

struct Answer {
  std::vector<PointBlock> blocks;
  std::vector<PairLoad> loads;
  ContactTotals totals;
};

Answer answer_of(const Kernels& kernels, const Running& r, bool commit, double step) {
  const auto blocks = r.state.contacts.points.blocks();
  Answer a{{blocks.begin(), blocks.end()}, std::vector<PairLoad>(r.state.contacts.points.load_count()), {}};
  const auto frames = frames_of(r.model, r.state);
  kernels.corner_edge_forces({a.blocks.data(), 0, a.blocks.size(), r.state.contacts.points.size(),
                              frames.data(), commit, a.loads.data(), 0.25, step},
                             a.totals);
  return a;
}

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

// A small wall in the middle of its shaking, every brick with a motion of its own.
Running shaken_wall() {
  scenes::RunningBond wall{.courses = 7, .bricks = 5};
  Running r(scenes::running_bond(wall, scenes::sine_motion(6.0, 2.0)));
  r.run(scenes::run_for(0.5));
  std::mt19937 random(5);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  for (double& v : r.state.v()) v += 0.3 * part(random);
  for (double& q : r.state.q()) q += 1e-4 * part(random);
  return r;
}

TEST(Kernels, GiveTheSameBitsWithEveryInstructionSet) {
  const Running r = shaken_wall();
  for (const bool commit : {false, true})
    for (const double step : {0.0, 1e-4}) {
      const Answer plain = answer_of(supported_kernels().front(), r, commit, step);
      EXPECT_GT(plain.totals.damping_power, 0.0);
      for (const Kernels& kernels : supported_kernels()) {
        const Answer a = answer_of(kernels, r, commit, step);
        EXPECT_TRUE(same_bits(a.loads, plain.loads)) << kernels.name;
        EXPECT_TRUE(same_bits(a.blocks, plain.blocks)) << kernels.name;
        EXPECT_EQ(a.totals.damping_power, plain.totals.damping_power) << kernels.name;
        EXPECT_EQ(a.totals.damping_work, plain.totals.damping_work) << kernels.name;
        EXPECT_EQ(a.totals.tangential_work, plain.totals.tangential_work) << kernels.name;
        EXPECT_EQ(a.totals.deepest_ratio, plain.totals.deepest_ratio) << kernels.name;
        EXPECT_EQ(a.totals.deepest_point, plain.totals.deepest_point) << kernels.name;
        EXPECT_EQ(a.totals.roused, plain.totals.roused) << kernels.name;
      }
    }
}

TEST(Kernels, GiveEveryPairTheForcesOfItsPoints) {
  const Running r = shaken_wall();
  const ContactPoints& points = r.state.contacts.points;
  const auto frames = frames_of(r.model, r.state);
  const Answer a = answer_of(best_kernels(), r, false, 0.0);
  int touching = 0;
  for (std::size_t i = 0; i < points.size(); i += 2) {
    PairLoad sum;
    for (const std::size_t k : {i, i + 1}) {
      const PointGeometry g = geometry_of(points, k, frames);
      const Vec2 force = force_of(points, k, frames);
      touching += g.overlap > 0.0 ? 1 : 0;
      sum.add(points.corner_is_b(k), force, cross(g.arm_corner, force), -cross(g.arm_edge, force));
    }
    EXPECT_EQ(a.loads[i / 2].fx, sum.fx) << i;
    EXPECT_EQ(a.loads[i / 2].fy, sum.fy) << i;
    EXPECT_EQ(a.loads[i / 2].torque_a, sum.torque_a) << i;
    EXPECT_EQ(a.loads[i / 2].torque_b, sum.torque_b) << i;
  }
  EXPECT_GT(touching, 40);
}

TEST(Kernels, PlaceBodiesAlikeWhateverTheirNumber) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-50.0, 50.0);
  for (const std::size_t n : {1u, 3u, 4u, 7u, 8u, 9u, 29u}) {
    std::vector<double> q(3 * n), v(3 * n);
    for (double& x : q) x = number(random);
    for (double& x : v) x = number(random);
    for (const Kernels& kernels : supported_kernels()) {
      std::vector<Frame> frames(n);
      kernels.place_bodies(q.data(), v.data(), n, 0, n, frames.data());
      for (std::size_t i = 0; i < n; ++i) {
        const SineCosine<double> turn = sine_cosine(q[2 * n + i]);
        const Frame& f = frames[i];
        const double expected[] = {q[i], q[n + i], turn.cosine,  turn.sine,
                                   v[i], v[n + i], v[2 * n + i], q[2 * n + i]};
        const double found[] = {f.x, f.y, f.c, f.s, f.vx, f.vy, f.spin, f.angle};
        for (int k = 0; k < 8; ++k) EXPECT_EQ(found[k], expected[k]) << kernels.name << " " << n << " " << k;
      }
    }
  }
}

}  // namespace
}  // namespace dougong::engine
