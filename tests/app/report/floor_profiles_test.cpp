// The figures over the height of a building, of its damage and of its load path.
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
