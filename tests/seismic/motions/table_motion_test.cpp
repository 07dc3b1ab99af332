#include "seismic/motions/table_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "seismic/input_error.h"
#include "seismic/motions/steady_motion.h"
#include "tests/seismic/test_data.h"

namespace dougong::seismic {
namespace {

using engine::Vec2;

/// A smooth movement from rest to rest: (1 - cos(pi t/T))/2.
TableMotion smooth(std::size_t n, double duration) {
  std::vector<Vec2> d;
  for (std::size_t k = 0; k <= n; ++k) {
    const double s = 0.5 - 0.5 * std::cos(M_PI * static_cast<double>(k) / static_cast<double>(n));
    d.push_back({s, -2.0 * s});
  }
  return {d, duration / static_cast<double>(n)};
}

TEST(TableMotion, GoesThroughItsTable) {
  const TableMotion motion = smooth(10, 2.0);
  EXPECT_NEAR(motion.at(1.0).displacement.x, 0.5, 1e-14);
  EXPECT_NEAR(motion.at(1.0).displacement.y, -1.0, 1e-14);
  EXPECT_DOUBLE_EQ(motion.at(2.0).displacement.x, 1.0);
  EXPECT_DOUBLE_EQ(motion.at(99.0).displacement.x, 1.0);
  EXPECT_EQ(motion.at(99.0).velocity, Vec2{});
}

TEST(TableMotion, IsOneMotion) {
  const TableMotion motion = smooth(10, 2.0);
  const double e = 1e-5;
  for (double t = 0.013; t < 1.98; t += 0.0371) {
    const Vec2 v = (0.5 / e) * (motion.at(t + e).displacement - motion.at(t - e).displacement);
    const Vec2 a = (0.5 / e) * (motion.at(t + e).velocity - motion.at(t - e).velocity);
    EXPECT_NEAR(motion.at(t).velocity.x, v.x, 1e-8) << t;
    EXPECT_NEAR(motion.at(t).acceleration.x, a.x, 1e-4) << t;
  }
}

TEST(TableMotion, StartsAndEndsAtRest) {
  const TableMotion motion = smooth(7, 1.0);
  EXPECT_NEAR(motion.at(1e-12).velocity.x, 0.0, 1e-10);
  EXPECT_NEAR(motion.at(1.0 - 1e-12).velocity.x, 0.0, 1e-10);
}

TEST(TableMotion, ConvergesWithOrderFour) {
  const auto error = [](std::size_t n) {
    const TableMotion motion = smooth(n, 1.0);
    double most = 0.0;
    for (double t = 0.0; t < 1.0; t += 0.00137)
      most = std::max(most, std::abs(motion.at(t).displacement.x - (0.5 - 0.5 * std::cos(M_PI * t))));
    return most;
  };
  EXPECT_NEAR(std::log2(error(16) / error(32)), 4.0, 0.3);
}

TEST(TableMotion, RefusesATableThatIsNone) {
  EXPECT_THROW(TableMotion({{}}, 1.0), std::invalid_argument);
  EXPECT_THROW(TableMotion({{}, {}}, 0.0), std::invalid_argument);
}

TEST(SteadyMotion, MovesEvenly) {
  const SteadyMotion belt({2.0, -1.0});
  EXPECT_EQ(belt.at(3.0).displacement, (Vec2{6.0, -3.0}));
  EXPECT_EQ(belt.at(3.0).velocity, (Vec2{2.0, -1.0}));
}

class MotionTableFile : public ::testing::Test {
 protected:
  MotionTable read(const std::string& text) const {
    return read_motion_table(testing::write_file("motion-table.csv", text));
  }
  std::string error(const std::string& text) const {
    try {
      read(text);
    } catch (const InputError& wrong) {
      return wrong.what();
    }
    return "";
  }
};

TEST_F(MotionTableFile, IsReadWithItsHeadAndComments) {
  const MotionTable table = read("time,x,y\n# a comment\n0,0,0\n0.5,1,2\n\n1.0,3,4\n");
  EXPECT_DOUBLE_EQ(table.interval, 0.5);
  ASSERT_EQ(table.displacements.size(), 3u);
  EXPECT_EQ(table.displacements[2], (Vec2{3, 4}));
  EXPECT_EQ(read("0 1\n1 2\n").displacements[1], (Vec2{2, 0}));
}

TEST_F(MotionTableFile, SaysWhatIsWrongWithIt) {
  EXPECT_NE(error("0,0\n0.1,x\n").find("csv:2"), std::string::npos);
  EXPECT_NE(error("0,0,0,0\n1,1,1,1\n").find("csv:1"), std::string::npos);
  EXPECT_NE(error("0,0\n0.1,nan\n").find("csv:2"), std::string::npos);
  EXPECT_NE(error("0,0\n0.1,1\n0.3,1\n").find("equal intervals"), std::string::npos);
  EXPECT_NE(error("1,0\n2,1\n").find("starts at time 0"), std::string::npos);
  EXPECT_NE(error("0,0\n").find("at least two rows"), std::string::npos);
}

}  // namespace
}  // namespace dougong::seismic
