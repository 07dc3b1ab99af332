#include "engine/nonsmooth/block_lu.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "tests/engine/allocations.h"

namespace dougong::engine {
namespace {

struct Random {
  std::uint64_t state = 7;
  double operator()() {
    state = state * 6364136223846793005ull + 1442695040888963407ull;
    return static_cast<double>(state >> 11) / 9007199254740992.0 - 0.5;
  }
};

void put(Eigen::MatrixXd& dense, std::size_t row, std::size_t column, const Block& block) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      dense(static_cast<Eigen::Index>(3 * row + i), static_cast<Eigen::Index>(3 * column + j)) =
          block[3 * i + j];
}

// A grid of n x n bodies, each coupled to its neighbours: the fill is not trivial.
std::vector<BodyPair> grid_pairs(Index n) {
  std::vector<BodyPair> pairs;
  for (Index y = 0; y < n; ++y)
    for (Index x = 0; x < n; ++x) {
      if (x + 1 < n) pairs.push_back({y * n + x, y * n + x + 1});
      if (y + 1 < n) pairs.push_back({y * n + x, (y + 1) * n + x});
    }
  return pairs;
}

void fill(BlockLu& lu, std::size_t rows, const std::vector<BodyPair>& pairs, Eigen::MatrixXd& dense) {
  Random random;
  lu.set_zero();
  for (Index i = 0; i < rows; ++i) {
    Block& d = lu.diagonal(i);
    for (double& value : d) value = random();
    d[0] += 6.0, d[4] += 6.0, d[8] += 6.0;
    put(dense, i, i, d);
  }
  for (const BodyPair& p : pairs) {
    const BlockLu::OffDiagonal b = lu.off_diagonal(p.a, p.b);
    for (double& value : b.at_row) value = random();
    for (double& value : b.at_column) value = random();
    put(dense, p.a, p.b, b.at_row);
    put(dense, p.b, p.a, b.at_column);
  }
}

void check_solution(Index n) {
  const std::size_t rows = n * n;
  const auto pairs = grid_pairs(n);
  BlockLu lu;
  lu.analyse(rows, pairs);
  Eigen::MatrixXd dense =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(3 * rows), static_cast<Eigen::Index>(3 * rows));
  fill(lu, rows, pairs, dense);
  Random random{99};
  std::vector<PlaneVelocity> x(rows);
  Eigen::VectorXd right(static_cast<Eigen::Index>(3 * rows));
  for (std::size_t i = 0; i < rows; ++i) {
    x[i] = {random(), random(), random()};
    right.segment<3>(static_cast<Eigen::Index>(3 * i)) << x[i].x, x[i].y, x[i].spin;
  }
  ASSERT_TRUE(lu.factorise());
  lu.solve(x);
  const Eigen::VectorXd exact = dense.partialPivLu().solve(right);
  for (std::size_t i = 0; i < rows; ++i) {
    const auto e = exact.segment<3>(static_cast<Eigen::Index>(3 * i));
    EXPECT_NEAR(x[i].x, e[0], 1e-12);
    EXPECT_NEAR(x[i].y, e[1], 1e-12);
    EXPECT_NEAR(x[i].spin, e[2], 1e-12);
  }
}

TEST(BlockLu, SolvesWhatADenseFactorisationSolves) {
  check_solution(2);
  check_solution(7);
}

TEST(BlockLu, SaysThatABlockIsSingular) {
  BlockLu lu;
  lu.analyse(2, std::vector<BodyPair>{{0, 1}});
  lu.set_zero();
  EXPECT_FALSE(lu.factorise());
}

TEST(BlockLu, AllocatesOnlyWhenItFindsThePattern) {
  const auto pairs = grid_pairs(5);
  BlockLu lu;
  lu.analyse(25, pairs);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(75, 75);
  std::vector<PlaneVelocity> x(25);
  const std::size_t before = testing::allocations();
  fill(lu, 25, pairs, dense);
  lu.factorise();
  lu.solve(x);
  EXPECT_EQ(testing::allocations(), before);
}

}  // namespace
}  // namespace dougong::engine
