// The words, tables and pictures of a comparison, of invented runs.
#include <gmock/gmock.h>

#include <algorithm>

#include "app/report/comparison_events.h"
#include "app/report/comparison_figures.h"
#include "app/report/comparison_text.h"
#include "tests/app/report/fixtures.h"

namespace dougong::app {
namespace {

using testing::HasSubstr;

TEST(ComparisonFigures, HaveALetterForEveryVariant) {
  EXPECT_EQ(letter(0), "A");
  EXPECT_EQ(letter(25), "Z");
  EXPECT_EQ(letter(26), "AA");
  EXPECT_EQ(letter(53), "BB");
}

TEST(ComparisonText, SaysWhyADifferenceIsNone) {
  Difference d;
  d.metric = "peak drift", d.unit = "1", d.pairs = 1, d.finding = Finding::unproven;
  EXPECT_EQ(finding_text(d), "one run proves nothing");
  d.pairs = 3;
  EXPECT_EQ(finding_text(d), "too few runs to tell");
  d.finding = Finding::not_different;
  EXPECT_EQ(finding_text(d), "not distinguishable");
}

TEST(ComparisonText, PrintsDifferencesWithTheirSign) {
  Difference d;
  d.metric = "peak drift", d.unit = "1", d.pairs = 9;
  d.interval = {-0.0123, -0.02, 0.001, Resampled::values};
  EXPECT_EQ(interval_text(d), "−1.23 % (−2.00 % to +0.100 %)");
  EXPECT_TRUE(is_of_the_building(d));
  d.metric = "S1 peak drift";
  EXPECT_FALSE(is_of_the_building(d));
}

TEST(ComparisonText, WarnsOfManyDifferences) {
  Difference d;
  d.interval.resampled = Resampled::values;
  EXPECT_EQ(multiplicity_text(std::vector<Difference>(4, d)), "");
  EXPECT_THAT(multiplicity_text(std::vector<Difference>(40, d)), HasSubstr("about 2 would"));
}

TEST(ComparisonEvents, ShowAllVariantsAtTheSameMoments) {
  const std::vector<RunResult> runs{fixtures::survived(), fixtures::collapsed()};
  const std::vector<double> times = common_moments(runs, 6);
  ASSERT_GE(times.size(), 3u);
  EXPECT_LE(times.size(), 6u);
  EXPECT_EQ(times.front(), 0.0);
  for (const RunResult& run : runs) {
    const std::vector<Frame> frames = frames_at(run, times);
    ASSERT_EQ(frames.size(), times.size());
    const double interval = run.trajectory.times[1] - run.trajectory.times[0];
    for (std::size_t i = 0; i < times.size(); ++i)
      EXPECT_NEAR(frames[i].time, std::min(times[i], run.trajectory.times.back()), 0.51 * interval);
  }
  const SceneView view = common_view(runs, times);
  for (const RunResult& run : runs) {
    const SceneView own = view_of(run, frames_at(run, times));
    EXPECT_TRUE(view.box.holds(own.box.low) && view.box.holds(own.box.high));
    EXPECT_GE(view.largest, own.largest);
  }
}

// A member that stands beside one that falls in the middle of the record: the strip goes to the end.
TEST(ComparisonEvents, SayThatARunHasEnded) {
  RunResult ended = fixtures::collapsed();
  const double end = ended.trajectory.times.back();
  const std::vector<Frame> frames = frames_at(ended, {0.0, end, end + 5.0, end + 8.0});
  EXPECT_THAT(frames[1].caption, HasSubstr("end"));
  EXPECT_EQ(frames[2].caption, "the run has ended");
  EXPECT_EQ(frames[3].caption, "the run has ended");
  EXPECT_EQ(frames[3].time, end);
  EXPECT_EQ(frames_at(ended, {0.0, end + 5.0}).at(1).caption, "end") << "no earlier picture says so";
}

}  // namespace
}  // namespace dougong::app
