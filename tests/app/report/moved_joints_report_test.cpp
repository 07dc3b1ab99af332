#include "app/report/moved_joints_report.h"

#include <gmock/gmock.h>

#include "app/report/results_file.h"
#include "tests/app/report/fixtures.h"

namespace dougong::app {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::vector<MovedJoint> joints{
    {"a / b",
     false,
     {0, 0},
     {1, 0},
     {0.0125, 3.21},
     {-0.04, 4.0},
     5e-4,
     -0.03,
     {2e4, 1.0},
     {0, 0},
     {-1500, 2.0}},
    {"b / c, top", true, {0, 1}, {1, 1}, {2e-5, 3.0}, {1e-6, 3.0}, 0, 0, {1e4, 1.0}, {500, 2.0}, {10, 2.0}}};

TEST(MovedJoints, AreTabledInThePrintedUnits) {
  const auto rows = moved_joint_rows(joints, 9);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_THAT(rows[0], ElementsAre("a / b", "dry", "12.5", "3.21", "0.500", "40.0", "4.00", "30.0", "20.00",
                                   "0.00", "1.50"));
  EXPECT_THAT(rows[1], ElementsAre("b / c, top", "bonded", "0.020", "3.00", "0.000", "0.001", "3.00", "0.000",
                                   "10.00", "0.50", "0.01"));
  EXPECT_EQ(moved_joint_rows(joints, 1).size(), 1u);
}

TEST(MovedJoints, AreWrittenExactly) {
  EXPECT_THAT(moved_joints_csv(joints),
              HasSubstr("\n\"b / c, top\",1,0,1,1,1,2e-05,3,1e-06,3,0,0,10000,1,500,2,10,2\n"));
}

TEST(MovedJoints, HaveASectionThatNamesTheWidestAndTheFarthest) {
  RunResult run;
  EXPECT_EQ(page_moved_joints(run, {}).code, "");
  run.moved_joints = joints;
  EXPECT_THAT(page_moved_joints(run, {}).code,
              HasSubstr("The widest opening is 12.5 mm, a / b at 3.21 s; the farthest slip 40.0 mm"));
}

TEST(MovedJoints, AreDrawnOnAScaleInMillimetres) {
  const RunResult run = fixtures::survived();
  EXPECT_THAT(moved_joints_figure(run.model, run.moved_joints).script, HasSubstr("mm"));
}

}  // namespace
}  // namespace dougong::app
