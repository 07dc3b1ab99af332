// The figures over the height of a building, of its damage and of its load path.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "app/report/colour.h"
#include "app/report/figures.h"
#include "app/report/weight_joints_report.h"
#include "tests/app/report/fixtures.h"

namespace dougong::app {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

structures::CodeCheck check(const char* standard, const char* name, double limit, double found) {
  structures::CodeCheck c;
  c.standard = standard, c.limit_name = name, c.limit = limit, c.found = found;
  c.measure = "peak drift";
  return c;
}

TEST(FloorProfiles, StepAtTheStoreysHeights) {
  const RunResult run = fixtures::survived();
  const Figure figure = floor_profiles_figure(run);
  const structures::StoreyResponse& first = run.response.storeys.front();
  EXPECT_THAT(figure.data.at("drift_positive.txt"),
              HasSubstr(std::to_string(100.0 * first.peak_drift.positive.value).substr(0, 5)));
  EXPECT_EQ(figure.data.size(), 6u);
  EXPECT_THAT(draw(figure).svg, HasSubstr("Peak floor acceleration"));
}

TEST(FloorProfiles, ShowOfEveryStandardTheLimitNearestToWhatWasFound) {
  RunResult run = fixtures::survived();
  const double found = 0.004;
  run.screening.checks = {check("A", "far", 0.1, found), check("A", "near", 0.0042, found),
                          check("B", "on A's", 0.0043, found), check("C", "below", 0.003, found)};
  const std::string script = floor_profiles_figure(run).script;
  EXPECT_THAT(script, HasSubstr("A, near"));
  EXPECT_THAT(script, HasSubstr("C, below"));
  EXPECT_THAT(script, Not(HasSubstr("far")));
  EXPECT_THAT(script, Not(HasSubstr("on A's"))) << "it would lie on A's";
}

TEST(DamageMap, ColoursFromTheFirstToTheLastDamage) {
  RunResult run = fixtures::survived();
  run.model.bonded = {{"a", 0, {-0.1, 0}, {0.1, 0}, 3.4, DrawnBond::never, "tension"},
                      {"b", 1, {-0.1, 0}, {0.1, 0}, 7.2, 9.0, "shear"},
                      {"c", 2, {-0.1, 0}, {0.1, 0}}};
  const std::string script = damage_figure(run).script;
  EXPECT_THAT(script, HasSubstr("set label '3' at screen"));
  EXPECT_THAT(script, HasSubstr("set label '8' at screen"));
  EXPECT_THAT(script, HasSubstr(to_hex(ink::pale))) << "the sound one";
}

TEST(LoadPath, EndsItsScaleAboveTheLargestForce) {
  const RunResult run = fixtures::survived();  // 340 kN
  EXPECT_THAT(load_path_figure(run.model, run.weight_joints).script, HasSubstr("set label '400' at screen"));
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

// A column between a slab and the ground lets the thrust through; the slab's goes by its middle.
TEST(LoadPath, GoesFromBlockToBlockThroughTheJoints) {
  const RunResult run = fixtures::survived();
  const std::string script = load_path_figure(run.model, run.weight_joints).script;
  EXPECT_THAT(script, HasSubstr("set arrow from -2.85,0 to -2.85,2.8 nohead"));
  EXPECT_THAT(script, HasSubstr("set arrow from 0,2.8 to -2.85,2.8 nohead"));
  EXPECT_EQ(count_of(script, " nohead front"), 2u);
}

TEST(LoadPath, ShowsTensionInItsOwnColour) {
  RunResult run = fixtures::survived();
  run.weight_joints[1].normal = -2.5e5;
  const std::string script = load_path_figure(run.model, run.weight_joints).script;
  EXPECT_THAT(script, HasSubstr("1 joint in compression, 1 in tension (red)"));
  EXPECT_EQ(count_of(script, to_hex(ink::lost)), 2u) << "in the column and in the slab";
}

// The blocks where they are then, relative to the ground.
TEST(LoadPath, OfTheEndIsDrawnWhereTheBlocksAreThen) {
  RunResult run = fixtures::survived();
  ASSERT_TRUE(has_end_load_path(run));
  const std::size_t last = run.trajectory.times.size() - 1;
  run.trajectory.ground_displacement[last] = {0.5, 0.0};
  run.end_joints[0].through.x += 0.5;
  const auto at = run.trajectory.position(last, 0) - engine::Vec2{0.5, 0.0};
  EXPECT_THAT(end_load_path_figure(run).script,
              HasSubstr(fmt::format("set arrow from {:.6g},{:.6g} to -2.85,0 nohead", at.x, at.y)));
  run.end_joints.clear();
  EXPECT_FALSE(has_end_load_path(run));
}

TEST(Spectrum, HasTheDisplacementOnItsRightAxis) {
  RunResult run = fixtures::survived();
  run.motion.spectrum_periods = {0.5, 1.0}, run.motion.spectrum_psa = {4.0, 2.0};
  // Sd = PSa (T / 2 pi)^2
  EXPECT_THAT(spectrum_figure(run).data.at("displacement.txt"), HasSubstr("1 50.6606"));
}

TEST(Spectrum, HasTheDesignSpectrumThatWasAskedFor) {
  RunResult run = fixtures::survived();
  EXPECT_THAT(spectrum_figure(run).script, Not(HasSubstr("design.txt")));
  run.motion.design_name = "Eurocode 8, type 1, ground C";
  run.motion.design_periods = {0.2, 1.0}, run.motion.design_psa = {7.0, 3.0};
  const DrawnFigure drawn = draw(spectrum_figure(run));
  EXPECT_THAT(drawn.svg, HasSubstr("dashed: Eurocode 8, type 1, ground C"));
}

}  // namespace
}  // namespace dougong::app
