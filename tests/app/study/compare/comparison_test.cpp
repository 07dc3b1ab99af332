#include "app/study/compare/comparison.h"

#include <gmock/gmock.h>

#include <cmath>

#include "app/study/compare/differences.h"
#include "app/study/motion_input.h"
#include "tests/app/study/study_cases.h"

namespace dougong::app::testing {
namespace {

const std::filesystem::path records = DOUGONG_RECORDS_DIRECTORY;

/// A drum of stone, shaken for eleven seconds, unless `more` says otherwise.
ComparisonChoice choice_of(const std::vector<std::string>& vary, const std::vector<std::string>& more = {}) {
  ComparisonChoice choice;
  std::vector<std::string> words{"layout=column", "drums=1", "duration=11 s", "pga=0.6 g"};
  words.insert(words.end(), more.begin(), more.end());
  for (const std::string& word : words) choice.overrides.push_back(parse_override(word));
  choice.records = {{"record.name", "elcentro", "test"}};
  for (const std::string& text : vary) choice.variants = crossed(choice.variants, variants_of_key(text));
  return choice;
}

const RunStore empty_store{[](const Case&) { return false; }, [](const Case&) { return RunResult{}; },
                           [](const Case&, const RunResult&) {}};

Comparison run(const ComparisonChoice& choice, std::size_t jobs = 1, bool same_sa = false) {
  const ComparisonPlan plan = plan_comparison(choice);
  Comparison c{look_at_variants(plan, records), plan.records, {View::same_motion}, {}};
  std::vector<Case> cases = plan.cases;
  if (same_sa) {
    c.views.push_back(View::same_sa);
    const auto scaled = cases_of_same_sa(plan, c.variants, records);
    cases.insert(cases.end(), scaled.begin(), scaled.end());
  }
  run_cases(c, cases, records, jobs, "test", empty_store);
  return c;
}

const Difference& difference_in(const std::vector<Difference>& all, const std::string& metric,
                                std::size_t variant = 1, View view = View::same_motion) {
  for (const Difference& d : all)
    if (d.metric == metric && d.variant == variant && d.view == view) return d;
  throw std::out_of_range(metric);
}

ComparisonChoice two_of_the_same(const std::vector<std::string>& more) {
  ComparisonChoice choice = choice_of({}, more);
  choice.variants = {{"one", {}}, {"the same", {}}};
  return choice;
}

TEST(Comparison, OfTheSameBuildingTwiceFindsNoDifferenceAtAll) {
  for (const char* members : {"ensemble.n=1", "ensemble.n=6"}) {
    const Comparison c = run(two_of_the_same({members}));
    const auto differences = differences_of(c);
    ASSERT_FALSE(differences.empty());
    for (const Difference& d : differences) {
      if (d.metric == "first loss of support") continue;  // there is none
      EXPECT_EQ(d.interval.mean, 0.0) << d.metric;
      EXPECT_EQ(d.finding, Finding::not_different) << d.metric;
    }
    EXPECT_EQ(collapses_of(c).at(0).shares.difference, 0.0);
    EXPECT_EQ(collapses_of(c).at(0).finding, Finding::not_different);
  }
}

TEST(Comparison, IsTheSameOnAnyNumberOfThreads) {
  const ComparisonChoice choice = choice_of({"drums=1,2"}, {"ensemble.n=3"});
  const Comparison one = run(choice, 1), four = run(choice, 4);
  ASSERT_EQ(one.runs.size(), four.runs.size());
  for (std::size_t i = 0; i < one.runs.size(); ++i) {
    ASSERT_EQ(one.runs[i].sheet.members.size(), 3u);
    for (std::size_t m = 0; m < 3; ++m)
      EXPECT_EQ(one.runs[i].sheet.members[m].state_hash, four.runs[i].sheet.members[m].state_hash);
    EXPECT_EQ(one.runs[i].sheet.half_step.state_hash, four.runs[i].sheet.half_step.state_hash);
  }
}

/// `metrics` of given values, a record each, as if they had been run.
Comparison made_up(const std::vector<std::vector<double>>& reference,
                   const std::vector<std::vector<double>>& variant, double half_step_change = 0.0) {
  Comparison c;
  c.variants = {{"reference", "", 1.0}, {"variant", "", 1.0}};
  c.views = {View::same_motion};
  for (std::size_t v = 0; v < 2; ++v)
    for (std::size_t r = 0; r < reference.size(); ++r) {
      ComparedRun run{v, r, View::same_motion, 1.0, "", {}};
      run.sheet.metrics = {"peak drift"}, run.sheet.units = {"1"};
      for (const double value : (v == 0 ? reference : variant)[r])
        run.sheet.members.push_back({structures::VerdictKind::survived, "", {value}, true});
      run.sheet.half_step = run.sheet.members.front();
      run.sheet.half_step.values.front() += half_step_change;
      c.runs.push_back(run);
      if (v == 0) c.records.push_back("record");
    }
  return c;
}

TEST(Differences, PairByRecordAndMember) {
  // Members differ by far more than the variants: only pairs tell.
  const std::vector<double> wild{0.01, 0.09, 0.02, 0.30, 0.05, 0.16};
  std::vector<double> more = wild;
  for (std::size_t i = 0; i < more.size(); ++i) more[i] += 0.001 + 1e-5 * static_cast<double>(i);
  const Difference d = differences_of(made_up({wild}, {more})).at(0);
  EXPECT_EQ(d.pairs, 6u);
  EXPECT_EQ(d.finding, Finding::different);
  EXPECT_NEAR(d.interval.mean, 0.001025, 1e-12);
  EXPECT_GT(d.interval.low, 0.001);
  EXPECT_LT(d.interval.high, 0.00105);
}

TEST(Differences, OfOneRunAreUnprovenOrCoveredByTheNumericalError) {
  EXPECT_EQ(differences_of(made_up({{0.01}}, {{0.02}}, 0.001)).at(0).finding, Finding::unproven);
  const Difference covered = differences_of(made_up({{0.01}}, {{0.02}}, 0.011)).at(0);
  EXPECT_EQ(covered.finding, Finding::not_different);
  EXPECT_NEAR(covered.numerical, 0.011, 1e-12);
}

TEST(Differences, OfFiveRecordsSpeakOfRecords) {
  const Difference d =
      differences_of(made_up({{1}, {2}, {3}, {4}, {5}}, {{2}, {3.1}, {3.9}, {5.2}, {6}})).at(0);
  EXPECT_EQ(d.interval.resampled, Resampled::groups);
  EXPECT_EQ(d.finding, Finding::different);
}

TEST(Differences, LeaveOutFailedRunsAndWhatDidNotHappen) {
  Comparison c = made_up({{1, 2, 3, 4, 5, 6, 7}}, {{2, 3, 4, 5, 6, 7, 8}});
  c.runs[0].sheet.members[1].verdict = structures::VerdictKind::numerically_invalid;
  c.runs[1].sheet.members[2].values[0] = std::nan("");
  EXPECT_EQ(differences_of(c).at(0).pairs, 5u);
  EXPECT_EQ(collapses_of(c).at(0).counts.pairs(), 6u);
  EXPECT_EQ(collapses_of(c).at(0).left_out, 1u);
}

// A block rocks when the ground accelerates beyond width/height of g: at 0.6 g the tall one, of 0.5, and
// never the flat one, of 2.5.
TEST(Comparison, FindsThatAFlatBlockDriftsLessThanOneThatRocks) {
  const Comparison c = run(choice_of({"drum_height=2, 0.4 m"}, {"ensemble.n=6"}), 2);
  const auto differences = differences_of(c);
  const Difference& d = difference_in(differences, "peak drift");
  EXPECT_GT(d.reference.median, 1e-4);
  EXPECT_LT(d.variant_spread.median, 1e-6);
  EXPECT_EQ(d.finding, Finding::different);
  EXPECT_LT(d.interval.high, 0.0);
}

double sa_of(const Case& one, double period) {
  const MotionInput motion = make_motion(one.scenario, records);
  const auto& x = motion.ground->horizontal();
  return seismic::spectral_point(x.acceleration, x.interval, period).pseudo_acceleration;
}

TEST(Comparison, OfTheSecondViewGivesEveryVariantTheSameSpectralAcceleration) {
  for (const char* scale : {"record.pga=0.6 g", "record.scale=1.5"}) {
    ComparisonChoice choice = choice_of({"drums=1,4"});
    choice.overrides.back() = parse_override(scale);
    const ComparisonPlan plan = plan_comparison(choice);
    const auto variants = look_at_variants(plan, records);
    ASSERT_TRUE(periods_differ(variants));
    const auto scaled = cases_of_same_sa(plan, variants, records);
    ASSERT_EQ(scaled.size(), 1u) << "the reference is run once";
    EXPECT_NE(scaled[0].factor, 1.0);
    EXPECT_NEAR(sa_of(scaled[0], variants[1].period) / sa_of(plan.cases[0], variants[0].period), 1.0, 1e-9);
    EXPECT_NE(scaled[0].scenario.output.directory, plan.cases[1].scenario.output.directory);
  }
}

TEST(Comparison, OfTheSecondViewComparesWithTheReferenceAsItWasRun) {
  const Comparison c = run(choice_of({"drums=1,2"}), 2, true);
  ASSERT_EQ(c.runs.size(), 3u);
  EXPECT_EQ(c.find(View::same_sa, 0, 0), c.find(View::same_motion, 0, 0));
  EXPECT_NE(c.find(View::same_sa, 1, 0), c.find(View::same_motion, 1, 0));
  EXPECT_EQ(differences_of(c).size() % 2, 0u);
}

TEST(Comparison, RefusesVariantsOnAnotherMotionOrSeed) {
  for (const char* key : {"record.pga=0.1,0.2 g", "ensemble.seed=1,2", "conditioning.taper=0.05,0.1"})
    EXPECT_THROW(plan_comparison(choice_of({key})), ScenarioError) << key;
  EXPECT_THROW(plan_comparison(choice_of({"drums=2"})), ScenarioError) << "one is none";
}

TEST(Comparison, KnowsWhatItsRunsFollowFrom) {
  const auto inputs = [](const std::vector<std::string>& more) {
    return inputs_of(plan_comparison(choice_of({"drums=1,2"}, more)).cases.front(), records);
  };
  EXPECT_EQ(inputs({}), inputs({}));
  EXPECT_NE(inputs({}), inputs({"ensemble.n=2"}));
  EXPECT_NE(inputs({}), inputs({"pga=0.5 g"}));
}

}  // namespace
}  // namespace dougong::app::testing
