#include "app/study/prepare.h"

#include <gmock/gmock.h>

#include <cmath>

#include "tests/app/study/study_cases.h"

namespace dougong::app::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string refusal(const std::vector<std::string>& words) {
  try {
    prepared(words);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

TEST(Prepare, GivesABuildingAtRestWithItsPeriodStepAndCost) {
  const Preparation p = prepared({"duration=1 s"});
  EXPECT_TRUE(p.settle.settled);
  EXPECT_LT(p.settle.unbalanced_ratio, 1e-3);
  EXPECT_EQ(p.contact_points, 32u) << "two corners at both ends of eight columns";
  EXPECT_GT(p.period, 0.05);
  EXPECT_GT(p.participation, 0.5);
  EXPECT_NEAR(p.plan.step, 0.5 * p.plan.bound, 0.02 * p.plan.bound);
  EXPECT_TRUE(std::isfinite(p.estimated_seconds));
  EXPECT_GT(p.estimated_seconds, 0.0);
}

TEST(Prepare, RunsForTheMotionAndItsFreeVibration) {
  const Preparation p = prepared({"layout=column", "drums=1", "free_vibration=3 s"});
  EXPECT_DOUBLE_EQ(p.duration, p.motion.ground->duration() + 3.0);
}

TEST(Prepare, TheEstimateDoesNotDependOnARareOutput) {
  const Preparation p = prepared_drum({"rate=0.01 Hz", "duration=90 s"});
  EXPECT_GT(p.estimated_seconds, 0.0);
  EXPECT_EQ(p.state.time, 0.0) << "the trial runs on a copy";
}

TEST(Prepare, SettlingCanBeLeftOut) {
  const Preparation p = prepared_drum({"settle=false"});
  EXPECT_FALSE(p.settle.settled);
  EXPECT_EQ(p.settle.duration, 0.0);
}

TEST(Prepare, SaysWhenTheContactsDoNotReachARockingRestitution) {
  const auto findings = [](const char* ratio) {
    std::string all;
    for (const structures::Finding& finding : prepared_drum({ratio}).findings) all += finding.message;
    return all;
  };
  EXPECT_THAT(findings("rocking_restitution=0.01"), HasSubstr("out of the contact law's reach"));
  EXPECT_THAT(findings("rocking_restitution=0.5"), Not(HasSubstr("reach")));
}

TEST(Prepare, RefusesAStepAboveTheBound) {
  EXPECT_THAT(refusal({"layout=column", "drums=1", "step=0.5 s"}),
              ::testing::AllOf(HasSubstr("solve.step: expected at most"), HasSubstr("found 0.5 s")));
}

TEST(Prepare, RefusesMoreOutputThanTheMachineCanHold) {
  EXPECT_THAT(refusal({"layout=column", "drums=200", "rate=1e6 Hz", "duration=1e5 s"}),
              HasSubstr("output.rate"));
}

TEST(Prepare, RefusesAVerticalMotionThatTheRecordDoesNotHave) {
  Scenario scenario = scenario_with({"layout=column", "drums=1", "vertical=true"});
  const MotionInput with = make_motion(scenario, DOUGONG_RECORDS_DIRECTORY);
  EXPECT_NE(with.ground->vertical(), nullptr) << "the shipped record has one";
  scenario.record.component = "77";
  EXPECT_THROW(make_motion(scenario, DOUGONG_RECORDS_DIRECTORY), seismic::InputError);
}

// --- the sheet of the motion -------------------------------------------------------------------------

TEST(MotionSheet, HoldsTheMotionAsApplied) {
  const MotionInput motion = make_motion(scenario_with({"pga=0.4 g"}), DOUGONG_RECORDS_DIRECTORY);
  const MotionSheet sheet = motion_sheet(motion, 0.5);
  ASSERT_EQ(sheet.times.size(), sheet.acceleration_x.size());
  ASSERT_EQ(sheet.times.size(), sheet.displacement_x.size());
  double peak = 0.0;
  for (const double a : sheet.acceleration_x) peak = std::max(peak, std::abs(a));
  EXPECT_NEAR(peak, 0.4 * seismic::standard_gravity, 1e-6);
  EXPECT_TRUE(sheet.acceleration_y.empty());
  EXPECT_NEAR(sheet.times[1] - sheet.times[0], sheet.interval, 1e-12);
}

TEST(MotionSheet, SaysWhereTheMotionComesFromAndWhatWasDoneToIt) {
  const MotionSheet sheet =
      motion_sheet(make_motion(scenario_with({"pga=0.4 g"}), DOUGONG_RECORDS_DIRECTORY), 0.0);
  std::map<std::string, std::string> provenance;
  for (const NamedValue& value : sheet.provenance) provenance[value.name] = value.value;
  EXPECT_EQ(provenance.at("SHA-256 of the file").size(), 64u);
  EXPECT_THAT(provenance.at("kind"), HasSubstr("synthetic"));
  EXPECT_FALSE(sheet.processing.empty());
  EXPECT_EQ(sheet.spectrum_at_period, 0.0) << "no period, no value at it";
}

TEST(MotionSheet, MarksTheSpectrumAtThePeriodOfTheBuilding) {
  const MotionInput motion = make_motion(scenario_with({}), DOUGONG_RECORDS_DIRECTORY);
  const MotionSheet probe = motion_sheet(motion, 0.0);
  const std::size_t middle = probe.spectrum_periods.size() / 2;
  EXPECT_NEAR(motion_sheet(motion, probe.spectrum_periods[middle]).spectrum_at_period,
              probe.spectrum_psa[middle], 1e-9 * probe.spectrum_psa[middle]);
}

// EN 1998-1:2004, 3.2.2.2: the plateau of type 1 on ground C is 2.5 S ag with S = 1.15, from 0.2 to 0.6 s.
TEST(MotionSheet, HoldsTheDesignSpectrumThatWasAskedFor) {
  const MotionSheet sheet =
      motion_sheet(make_motion(scenario_with({"design_spectrum=ec8: type=1, ground=C, ag=0.25 g"}),
                               DOUGONG_RECORDS_DIRECTORY),
                   0.0);
  EXPECT_THAT(sheet.design_name, HasSubstr("Eurocode 8"));
  ASSERT_EQ(sheet.design_periods.size(), sheet.design_psa.size());
  std::size_t plateau = 0;
  for (std::size_t i = 0; i < sheet.design_periods.size(); ++i) {
    if (sheet.design_periods[i] < 0.2 || sheet.design_periods[i] > 0.6) continue;
    EXPECT_NEAR(sheet.design_psa[i], 2.5 * 1.15 * 0.25 * 9.80665, 1e-9);
    ++plateau;
  }
  EXPECT_GT(plateau, 5u);
}

TEST(Prepare, RefusesADesignSpectrumThatIsNone) {
  try {
    make_motion(scenario_with({"design_spectrum=ec9: a=1"}), DOUGONG_RECORDS_DIRECTORY);
    FAIL();
  } catch (const ScenarioError& error) {
    EXPECT_THAT(error.what(),
                AllOf(HasSubstr("record.design_spectrum"), HasSubstr("ec9"), HasSubstr("gb50011")));
  }
}

TEST(MotionSheet, HoldsTheVerticalMotionWhenItIsAskedFor) {
  const MotionInput motion = make_motion(scenario_with({"vertical=true"}), DOUGONG_RECORDS_DIRECTORY);
  const MotionSheet sheet = motion_sheet(motion, 0.0);
  EXPECT_EQ(sheet.acceleration_y.size(), sheet.acceleration_x.size());
}

TEST(MotionSheet, TellsABuildingWhatDoesNotSuitIt) {
  const MotionInput motion = make_motion(scenario_with({}), DOUGONG_RECORDS_DIRECTORY);
  EXPECT_THAT(motion_sheet(motion, 0.05).processing,
              ::testing::Contains(HasSubstr("too coarse for a building")));
  EXPECT_THAT(motion_sheet(motion, 12.0).processing,
              ::testing::Contains(HasSubstr("high-pass corner of 0.1 Hz")));
  EXPECT_THAT(motion_sheet(motion, 0.5).processing,
              ::testing::Not(::testing::Contains(HasSubstr("building"))));
}

TEST(ConditioningOptions, AreThoseOfTheScenario) {
  const seismic::ConditioningOptions o = conditioning_options(
      scenario_with({"offset=pre-event", "pre_event=2 s", "baseline=velocity-polynomial", "baseline_degree=5",
                     "filter_phase=causal", "resample=spline", "end=at-rest"}));
  EXPECT_EQ(o.offset, seismic::OffsetRemoval::pre_event_mean);
  EXPECT_EQ(o.pre_event, 2.0);
  EXPECT_EQ(o.baseline, seismic::BaselineCorrection::velocity_polynomial);
  EXPECT_EQ(o.baseline_degree, 5);
  EXPECT_EQ(o.phase, seismic::FilterPhase::causal);
  EXPECT_EQ(o.resample_method, seismic::ResampleMethod::spline);
  EXPECT_EQ(o.end, seismic::EndRule::at_rest);
}

}  // namespace
}  // namespace dougong::app::testing
