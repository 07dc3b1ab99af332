// Drawings of blocks are to scale, and the table and CSV of joints say what the run has.
#include "app/report/block_drawing.h"

#include <gmock/gmock.h>

#include <regex>

#include "app/report/report_output.h"
#include "app/report/weight_joints_report.h"
#include "app/study/prepare.h"
#include "structures/layouts/layout.h"

namespace dougong::app {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

double number_after(const std::string& script, const std::string& pattern) {
  std::smatch found;
  if (!std::regex_search(script, found, std::regex(pattern + "([-0-9.e]+)")))
    throw std::out_of_range(pattern);
  return std::stod(found[1]);
}

/// Pixels a metre along an axis: the part of the sheet between its margins over its range.
double scale_of(const Figure& figure, const char* range, const char* low, const char* high, int pixels) {
  const std::string& s = figure.script;
  const double from = number_after(s, std::string("set ") + range + " \\["),
               to = number_after(s, std::string("set ") + range + " \\[[-0-9.e]+:");
  const double share = number_after(s, std::string("set ") + high + " at screen ") -
                       number_after(s, std::string("set ") + low + " at screen ");
  return share * pixels / (to - from);
}

TEST(BlockDrawing, IsToScaleWithEqualAxes) {
  for (const char* layout : {"column", "brick-wall", "arch"}) {
    const ModelSheet model = model_sheet(structures::build_layout(layout));
    for (const char* scale : {"", "used (-)"}) {
      BlockDrawing drawing;
      drawing.title = layout, drawing.legend = {"one line"}, drawing.scale_title = scale;
      const Figure figure = block_figure(model, drawing);
      const double across = scale_of(figure, "xrange", "lmargin", "rmargin", figure.width),
                   up = scale_of(figure, "yrange", "bmargin", "tmargin", figure.height);
      EXPECT_NEAR(across / up, 1.0, 0.01) << layout;
    }
  }
}

TEST(BlockDrawing, MagnifiesTheGreatestMotionToATenthOfItsSize) {
  const ModelSheet model = model_sheet(structures::build_layout("column"));  // 6 m
  const double factor = drawn_magnification(model, {{0.0, 0.0}, {0.001, 0.0}});
  EXPECT_GT(factor * 0.001, 0.25 * 0.6);
  EXPECT_LE(factor * 0.001, 0.6);
  EXPECT_EQ(drawn_magnification(model, {{0.0, 0.0}}), 1.0);
}

const std::vector<WeightJoint> joints{
    {"a / b", false, {0, 0}, {1, 0}, 2e4, -1e3, 0.4, 5e5, 0, 0.4, "turning"},
    {"b / c, top", true, {0, 1}, {1, 1}, 1e4, 0, 0.1, 2e4, 1e3, 0.01, "tension"},
    {"d / e",
     false,
     {2, 0},
     {2, 0},
     1e3,
     0,
     1.0,
     std::numeric_limits<double>::infinity(),
     0,
     0.005,
     "turning"}};

TEST(WeightJoints, AreTabledInThePrintedUnits) {
  const auto rows = weight_rows(joints, 2);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_THAT(rows[0],
              ElementsAre("a / b", "dry", "20.00", "1.00", "0.400", "500.0", "0.0", "40.0", "turning"));
  EXPECT_THAT(rows[1],
              ElementsAre("b / c, top", "bonded", "10.00", "0.00", "", "20.0", "1.0", "1.0", "tension"));
  EXPECT_EQ(weight_rows(joints, 9).back()[5], "at a corner");
  EXPECT_EQ(greatest_compression(joints), "0.500 MPa in a / b");
  EXPECT_EQ(greatest_compression({}), "none");
}

TEST(WeightJoints, AreWrittenExactlyAndDrawn) {
  EXPECT_THAT(weight_joints_csv(joints),
              HasSubstr("\n\"b / c, top\",1,0,1,1,1,10000,0,0.1,20000,1000,0.01,tension,0,0,0,0\n"));
  const ModelSheet model = model_sheet(structures::build_layout("column"));
  EXPECT_THAT(weight_figure(model, joints).script, HasSubstr("set label '0.4' at screen"));
}

TEST(WeightJoints, HaveASectionOfThePageWhereThereAreAny) {
  RunResult run;
  EXPECT_EQ(page_weight(run, {}).code, "");
  run.weight_joints = joints;
  EXPECT_THAT(page_weight(run, {}).code, HasSubstr("The most used of 3 joints"));
}

}  // namespace
}  // namespace dougong::app
