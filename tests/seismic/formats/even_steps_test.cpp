#include "seismic/formats/even_steps.h"

#include <gmock/gmock.h>

#include <cmath>

namespace dougong::seismic {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// Rounded to a millisecond, as times are printed.
double printed(double t) {
  return std::round(t * 1000.0) / 1000.0;
}

std::vector<double> ramp(std::size_t count) {
  std::vector<double> values;
  for (std::size_t k = 0; k < count; ++k) values.push_back(static_cast<double>(k));
  return values;
}

TEST(EvenSteps, KeepsValuesWhoseTimesAreOnlyRounded) {
  std::vector<double> times;
  for (int k = 0; k < 1000; ++k) times.push_back(printed(k / 128.0));
  const auto series = to_even_steps(times, ramp(1000));
  ASSERT_TRUE(series);
  EXPECT_DOUBLE_EQ(series->interval, 1.0 / 128.0);
  EXPECT_EQ(series->values, ramp(1000));
  EXPECT_THAT(series->steps, IsEmpty());
  EXPECT_THAT(series->warnings, IsEmpty());
}

TEST(EvenSteps, TakesAShorterFirstStepForThePrintersAndSaysSo) {
  const auto series = to_even_steps({0.0, 0.005, 0.015, 0.025, 0.035}, {1, 2, 3, 4, 5});
  ASSERT_TRUE(series);
  EXPECT_DOUBLE_EQ(series->interval, 0.01);
  EXPECT_THAT(series->values, ElementsAre(1, 2, 3, 4, 5));
  EXPECT_THAT(series->warnings, ElementsAre(HasSubstr("the first step is 0.005 s")));
}

TEST(EvenSteps, KeepsValuesAlongTheMarksOfAFilmThatRanUnevenlyAndSaysSo) {
  std::vector<double> times;
  for (int k = 0; k < 12000; ++k) times.push_back(printed(0.0050005 * k + 0.09 * std::sin(0.0005 * k)));
  const auto series = to_even_steps(times, ramp(12000));
  ASSERT_TRUE(series);
  EXPECT_DOUBLE_EQ(series->interval, 0.005);
  EXPECT_THAT(series->values, SizeIs(12000));
  EXPECT_THAT(series->warnings, ElementsAre(HasSubstr("they stray from equal steps by up to 0.097 s")));
}

TEST(EvenSteps, ResamplesUnevenTimesLinearlyAndSaysSo) {
  const auto series = to_even_steps({0.0, 0.02, 0.03, 0.07, 0.08}, {0.0, 2.0, 3.0, 7.0, 6.0});
  ASSERT_TRUE(series);
  EXPECT_DOUBLE_EQ(series->interval, 0.01);
  ASSERT_THAT(series->values, SizeIs(9));
  for (std::size_t k = 0; k < 8; ++k) EXPECT_NEAR(series->values[k], static_cast<double>(k), 1e-12);
  EXPECT_NEAR(series->values[8], 6.0, 1e-12);
  EXPECT_THAT(series->steps,
              ElementsAre(HasSubstr("5 samples 0.01 to 0.04 s apart resampled to 9 every 0.01 s")));
}

TEST(EvenSteps, ResamplesToTheStepAskedFor) {
  const auto series = to_even_steps({0.0, 0.01, 0.02, 0.03, 0.04}, {0, 1, 2, 3, 4}, 0.02);
  ASSERT_TRUE(series);
  EXPECT_THAT(series->values, ElementsAre(0, 2, 4));
  EXPECT_THAT(series->steps, SizeIs(1));
}

TEST(EvenSteps, RefusesToStretchARecordWithoutBound) {
  EXPECT_FALSE(to_even_steps({0.0, 1e-6, 1.0, 3.0}, {0, 1, 2, 3}));
  EXPECT_FALSE(to_even_steps({0.0, 1e-6, 1.0, 3.0}, {0, 1, 2, 3}, 1e-9));
  EXPECT_TRUE(to_even_steps({0.0, 1e-6, 1.0, 3.0}, {0, 1, 2, 3}, 0.5));
}

TEST(EvenSteps, FindsTimesThatGoBackOrRepeat) {
  EXPECT_EQ(first_time_back({0.0, 0.1, 0.1, 0.2}), 2u);
  EXPECT_EQ(first_time_back({0.0, 0.1, 0.05}), 2u);
  EXPECT_EQ(first_time_back({0.0, 0.1, std::nan("")}), 2u);
  EXPECT_FALSE(first_time_back({0.0, 0.1, 0.2}));
}

}  // namespace
}  // namespace dougong::seismic
