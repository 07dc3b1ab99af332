#include "seismic/conditioning/condition.h"

#include <gmock/gmock.h>

#include "seismic/constants.h"
#include "seismic/measures/peaks.h"
#include "seismic/measures/response_spectrum.h"
#include "tests/seismic/test_data.h"

namespace dougong::seismic {
namespace {

using ::testing::AnyOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using testing::input_error;

Record record_of(std::vector<double> a, const std::string& component, double dt = 0.01) {
  Record record;
  record.acceleration = std::move(a);
  record.interval = dt;
  record.component = component;
  record.axis = axis_of(component);
  record.provenance.file = component + ".txt";
  record.provenance.event = "SYN";
  return record;
}

RecordSet set_of(std::vector<Record> records) {
  RecordSet set;
  set.components = std::move(records);
  return set;
}

std::vector<double> with_offset(std::vector<double> a, double offset) {
  for (double& value : a) value += offset;
  return a;
}

TEST(Condition, BringsTheGroundBackToRestWhereItWas) {
  const auto motion = condition(set_of({record_of(with_offset(testing::record_a(), 0.4), "EW")}));
  const auto h = integrate(motion.horizontal, motion.interval);
  EXPECT_NEAR(h.velocity.back(), 0.0, 1e-6);
  EXPECT_NEAR(h.displacement.back(), 0.0, 2e-5);
  EXPECT_LT(peak(h.displacement, 0.01).value, 0.2);
  EXPECT_EQ(motion.residual_velocity, h.velocity.back());
  EXPECT_EQ(motion.horizontal.front(), 0.0);
  EXPECT_NEAR(motion.lead, 5.0, 1e-12);
  EXPECT_EQ(motion.horizontal.size(), 4001u + 1000u);
  EXPECT_LT(motion.ground_motion().closing_acceleration(), 1e-5);
}

TEST(Condition, LeavesTheSpectrumOfTheShakingAlone) {
  const auto a = testing::record_a();
  const auto motion = condition(set_of({record_of(a, "EW")}));
  for (const double period : {0.2, 0.5, 1.0, 2.0}) {
    const double before = spectral_point(a, 0.01, period).pseudo_acceleration;
    EXPECT_CLOSE(spectral_point(motion.horizontal, 0.01, period).pseudo_acceleration, before, 0.02) << period;
  }
}

TEST(Condition, SaysEveryStepWithItsNumbers) {
  ConditioningOptions options;
  options.interval = 0.005;
  options.target_pga = 2.0;
  const auto motion = condition(set_of({record_of(with_offset(testing::record_a(), 0.4), "EW")}), options);
  const std::vector<std::string> starts = {
      "offset: whole-record mean removed (EW 0.3998 m/s2)",
      "taper: half cosine over 2 s",
      "filter: Butterworth band pass 0.1-25 Hz, order 4, forward and backward over 30 s",
      "pads: cut back to 5 s",
      "resampled: from 0.01 s to 0.005 s",
      "scale: all components times",
      "integrated: from rest"};
  ASSERT_EQ(motion.processing.size(), starts.size());
  for (std::size_t i = 0; i < starts.size(); ++i) EXPECT_THAT(motion.processing[i], HasSubstr(starts[i]));
}

TEST(Condition, ScalesAllComponentsByTheFactorOfTheHorizontalOne) {
  ConditioningOptions options;
  options.filter = false;
  options.offset = OffsetRemoval::none;
  options.taper_fraction = 0.0;
  options.target_pga = 3.0;
  const auto up = testing::Syn(7, 0.5).samples(0.01);
  const auto motion = condition(set_of({record_of(testing::record_a(), "EW"), record_of(up, "UD")}), options);
  EXPECT_CLOSE(peak(motion.horizontal, 0.01).value, 3.0, 1e-12);
  ASSERT_TRUE(motion.vertical.has_value());
  EXPECT_CLOSE(motion.scale_factor, 3.0 / 2.634698442, 1e-9);
  EXPECT_CLOSE((*motion.vertical)[500], up[500] * motion.scale_factor, 1e-12);
  options.vertical = false;
  EXPECT_FALSE(condition(set_of({record_of(testing::record_a(), "EW"), record_of(up, "UD")}), options)
                   .vertical.has_value());
}

TEST(Condition, TheAppliedMotionHasTheTargetPga) {
  ConditioningOptions options;
  options.target_pga = 0.35 * standard_gravity;
  const auto motion = condition(set_of({record_of(testing::record_a(), "EW")}), options);
  EXPECT_CLOSE(peak(motion.horizontal, 0.01).value, 0.35 * standard_gravity, 1e-12);
}

TEST(Condition, RequiresATargetForADimensionlessRecord) {
  Record shape = record_of(testing::record_a(), "EW");
  shape.dimensionless = true;
  EXPECT_THAT(input_error([&] { condition(set_of({shape})); }),
              HasSubstr("expected a target PGA (option pga)"));
  ConditioningOptions options;
  options.scale_factor = 2.0;
  EXPECT_THAT(input_error([&] { condition(set_of({shape}), options); }), HasSubstr("found a scale factor"));
  options = {};
  options.target_pga = 1.0;
  EXPECT_CLOSE(peak(condition(set_of({shape}), options).horizontal, 0.01).value, 1.0, 1e-12);
}

TEST(Condition, TellsEveryWrongOptionAtOnce) {
  ConditioningOptions options;
  options.high_pass = 80.0;
  options.target_pga = -1.0;
  options.order = 13;
  const std::string text =
      input_error([&] { condition(set_of({record_of(testing::record_a(), "EW")}), options); });
  EXPECT_THAT(text, HasSubstr("Nyquist frequency, 50 Hz, found 80 Hz"));
  EXPECT_THAT(text, HasSubstr("a positive target PGA, found -1"));
  EXPECT_THAT(text, HasSubstr("a filter order from 1 to 12, found 13"));
}

TEST(Condition, RefusesACornerWhosePadsNoMemoryHolds) {
  ConditioningOptions options;
  options.high_pass = 1e-6;
  EXPECT_THAT(input_error([&] { condition(set_of({record_of(testing::record_a(), "EW")}), options); }),
              HasSubstr("at most 1e+07 samples, found 3e+06 s of zeros"));
  options.pad = 30.0;
  EXPECT_EQ(condition(set_of({record_of(testing::record_a(), "EW")}), options).horizontal.size(), 5001u);
}

TEST(Condition, RefusesAVerticalComponentAsHorizontalMotion) {
  EXPECT_THAT(input_error([] { condition(set_of({record_of(testing::record_a(), "UD")})); }),
              HasSubstr("expected a horizontal component, found UD"));
}

TEST(Condition, LeavesOutTheUpperCornerWhereItCannotBe) {
  const auto coarse = condition(set_of({record_of(testing::record_a(0.02), "EW", 0.02)}));
  EXPECT_THAT(coarse.processing, Contains(HasSubstr("no upper corner: 25 Hz is above 0.9 of the Nyquist")));
  Record processed = record_of(testing::record_a(), "EW");
  processed.provenance.processed = true;
  EXPECT_THAT(condition(set_of({processed})).processing,
              Contains(HasSubstr("the publisher filtered the record")));
}

TEST(Condition, WarnsWhenTheGroundDoesNotReturn) {
  ConditioningOptions options;
  options.filter = false;
  const auto motion = condition(set_of({record_of(testing::record_a(), "EW")}), options);
  EXPECT_THAT(motion.warnings, Contains(HasSubstr("does not return")));
  const auto ground = motion.ground_motion();
  EXPECT_EQ(ground.at(ground.duration()).velocity.x, 0.0);  // closed all the same
}

TEST(Condition, CutsThePartAskedFor) {
  ConditioningOptions options;
  options.from = 2.0;
  options.to = 30.0;
  options.filter = false;
  const auto motion = condition(set_of({record_of(testing::record_a(), "EW")}), options);
  EXPECT_EQ(motion.horizontal.size(), 2801u);
  options.from = 50.0;
  EXPECT_THAT(input_error([&] { condition(set_of({record_of(testing::record_a(), "EW")}), options); }),
              HasSubstr("which lasts 40 s"));
}

TEST(Condition, RemovesThePreEventMeanWhenAskedTo) {
  auto a = with_offset(std::vector<double>(2000, 0.0), 0.25);
  for (std::size_t k = 1000; k < 1100; ++k) a[k] += 1.0;
  ConditioningOptions options;
  options.offset = OffsetRemoval::pre_event_mean;
  options.filter = false;
  const auto motion = condition(set_of({record_of(a, "EW")}), options);
  EXPECT_NEAR(motion.horizontal[700], 0.0, 1e-15);
  EXPECT_NEAR(motion.horizontal[1050], 1.0, 1e-15);
}

TEST(Condition, EndsAtRestWhereAskedTo) {
  ConditioningOptions options;
  options.filter = false;
  options.end = EndRule::at_rest;
  options.target_pga = 3.0;
  const auto motion = condition(set_of({record_of(testing::record_a(), "EW")}), options);
  EXPECT_NEAR(motion.residual_velocity, 0.0, 1e-12);
  EXPECT_NEAR(motion.residual_displacement, 0.0, 1e-11);
  EXPECT_THAT(motion.processing, Contains(HasSubstr("rest: EW ended at")));
  EXPECT_TRUE(motion.warnings.empty());
}

TEST(Condition, ByACausalFilterMovesNothingBeforeTheRecord) {
  auto a = std::vector<double>(1000, 0.0);
  a[500] = 1.0;
  ConditioningOptions options;
  options.offset = OffsetRemoval::none;
  options.taper_fraction = 0.0;
  options.kept_pad = 0.0;
  options.phase = FilterPhase::causal;
  const auto causal = condition(set_of({record_of(a, "EW")}), options);
  EXPECT_EQ(peak(std::span(causal.horizontal).first(500), 0.01).value, 0.0);
  EXPECT_THAT(causal.processing, Contains(HasSubstr("forward (causal)")));
  options.phase = FilterPhase::zero;
  const auto zero = condition(set_of({record_of(a, "EW")}), options);
  EXPECT_GT(peak(std::span(zero.horizontal).first(500), 0.01).value, 0.01);
}

TEST(Condition, TakesOffAPolynomialOfTheDegreeAskedFor) {
  ConditioningOptions options;
  options.baseline = BaselineCorrection::velocity_polynomial;
  options.baseline_degree = 4;
  EXPECT_THAT(condition(set_of({record_of(testing::record_a(), "EW")}), options).processing,
              Contains(HasSubstr("polynomial of velocity of degree 4 taken off EW")));
  options.baseline_degree = 0;
  EXPECT_THAT(input_error([&] { condition(set_of({record_of(testing::record_a(), "EW")}), options); }),
              HasSubstr("a degree of the baseline from 1 to 6, found 0"));
}

TEST(Condition, KeepsTheStagesThatChangedSomething) {
  ConditioningOptions options;
  options.keep_stages = true;
  const auto motion = condition(set_of({record_of(with_offset(testing::record_a(), 0.4), "EW")}), options);
  std::vector<std::string> steps;
  for (const ConditioningStage& stage : motion.stages) steps.push_back(stage.step);
  EXPECT_EQ(steps, (std::vector<std::string>{"read", "offset", "taper", "filter"}));
  EXPECT_EQ(motion.stages.back().acceleration, motion.horizontal);
  EXPECT_EQ(motion.stages.back().lead, 5.0);
}

TEST(BuildingWarnings, TellOfACoarseRecordAndOfCornersAtTheBuildingsFrequency) {
  const auto motion = condition(set_of({record_of(testing::record_a(0.02), "EW", 0.02)}));
  EXPECT_TRUE(building_warnings(motion, 0.5).empty());
  EXPECT_TRUE(building_warnings(motion, 0.2).empty());
  EXPECT_THAT(building_warnings(motion, 0.15), Contains(HasSubstr("too coarse for a building of 0.15 s")));
  EXPECT_THAT(building_warnings(motion, 9.0), Contains(HasSubstr("high-pass corner of 0.1 Hz")));
  EXPECT_TRUE(building_warnings(motion, 7.9).empty());
  ConditioningOptions options;
  options.low_pass = 3.0;
  const auto dull = condition(set_of({record_of(testing::record_a(), "EW")}), options);
  EXPECT_THAT(building_warnings(dull, 0.2), Contains(HasSubstr("low-pass corner of 3 Hz is below")));
}

TEST(Condition, OfARecordOfZerosIsZero) {
  const auto motion = condition(set_of({record_of(std::vector<double>(1000, 0.0), "EW")}));
  EXPECT_EQ(peak(motion.horizontal, 0.01).value, 0.0);
  EXPECT_EQ(motion.ground_motion().at(3.0).displacement.x, 0.0);
  ConditioningOptions options;
  options.target_pga = 1.0;
  EXPECT_THAT(
      input_error([&] { condition(set_of({record_of(std::vector<double>(1000, 0.0), "EW")}), options); }),
      HasSubstr("a record of zeros"));
}

}  // namespace
}  // namespace dougong::seismic
