// M01: a granite boulder on a shaking table (docs/comparisons/m01-granite-boulder.md), every twelfth run.
#include "tests/scenes/granite_boulder.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace dougong {
namespace {

const std::filesystem::path motions = std::filesystem::path(DOUGONG_REAL_RECORDS) / "granite";

// Which half of the runs: two tests, to run at one time.
void expect_outcomes(std::size_t first) {
  if (!std::filesystem::exists(motions)) GTEST_SKIP() << "recordings not available: " << motions;
  scenes::Boulder block;
  block.young_modulus = 3e9;
  auto trials = scenes::read_boulder_trials(motions.string());
  int runs = 0, as_rigid = 0, as_tested = 0;
  for (std::size_t k = first; k < trials.size(); k += 24, ++runs) {
    scenes::run_boulder(block, trials[k]);
    as_rigid += trials[k].by_engine.overturned == trials[k].by_events.overturned;
    as_tested += trials[k].by_engine.overturned == trials[k].overturned;
  }
  testing::Test::RecordProperty("runs", runs);
  testing::Test::RecordProperty("as_the_rigid_block", as_rigid);
  testing::Test::RecordProperty("as_tested", as_tested);
  EXPECT_GE(as_rigid, runs - 1) << "of " << runs;
  EXPECT_GE(as_tested, runs - 2) << "of " << runs;
}

TEST(GraniteBoulder, OverturnsWhereTheTestsSay) {
  expect_outcomes(0);
}

TEST(GraniteBoulder, OverturnsWhereOtherTestsSay) {
  expect_outcomes(12);
}

}  // namespace
}  // namespace dougong
