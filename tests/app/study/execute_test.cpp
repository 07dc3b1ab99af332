#include "app/study/execute.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "app/study/moments.h"
#include "app/study/output_times.h"
#include "tests/app/study/study_cases.h"

namespace dougong::app::testing {
namespace {

using structures::VerdictKind;
using ::testing::HasSubstr;

TEST(Execute, EveryHistoryHasOneEntryAnOutputTime) {
  Preparation p = prepared_drum();
  const RunResult r = execute(p, "dougong run");
  const std::size_t n = r.response.times.size();
  EXPECT_EQ(n, 101u);
  for (const auto* column : {&r.energy.input, &r.energy.kinetic, &r.energy.gravity, &r.energy.elastic,
                             &r.energy.friction, &r.energy.damping, &r.energy.error})
    EXPECT_EQ(column->size(), n);
  EXPECT_EQ(r.numerics.overlap_ratio.size(), n);
}

TEST(Execute, KeepsTheMeanOverlapBesideTheDeepest) {
  Preparation p = prepared_drum();
  const Numerics n = execute(p, "").numerics;
  ASSERT_EQ(n.mean_overlap_ratio.size(), n.overlap_ratio.size());
  for (std::size_t i = 0; i < n.overlap_ratio.size(); ++i)
    EXPECT_LE(n.mean_overlap_ratio[i],
              n.overlap_ratio[i] * (1.0 + 1e-12));  // a mean of equal ones is rounded
  EXPECT_GT(n.mean_overlap_ratio.front(), 0.0);
}

// Not shaken, so the load goes at the end as it did at the start.
TEST(Execute, KeepsTheLoadPathOfTheStartAndOfTheEnd) {
  Preparation p = prepared({"layout=column", "drums=3", "duration=1 s", "pga=0.0001 g"});
  const RunResult r = execute(p, "");
  ASSERT_EQ(r.weight_joints.size(), 3u);
  ASSERT_EQ(r.end_joints.size(), 3u);
  for (const WeightJoint& at_rest : r.weight_joints) {
    const auto end = std::ranges::find(r.end_joints, at_rest.name, &WeightJoint::name);
    ASSERT_NE(end, r.end_joints.end()) << at_rest.name;
    EXPECT_NEAR(end->normal, at_rest.normal, 1e-3 * at_rest.normal);
    EXPECT_LT(end->a, 3u);
    EXPECT_NE(end->a, end->b);
  }
}

TEST(Execute, KeepsTheStatesAtTheirOwnRateAndWhereSomethingHappened) {
  Preparation p = prepared_drum();
  const RunResult r = execute(p, "");
  const auto& t = r.trajectory;
  EXPECT_EQ(t.poses.size(), 3 * t.times.size());
  EXPECT_EQ(t.accelerations.size(), t.times.size());
  EXPECT_GE(t.times.size(), 51u) << "50 a second";
  EXPECT_LE(t.times.size(), 51u + r.moments.size());
  for (const Moment& moment : r.moments)
    EXPECT_NEAR(t.times[nearest_step(t.times, moment.time)], moment.time, 0.0051) << moment.caption;
}

TEST(Execute, FewerStatesChangeNoNumberOfTheRun) {
  Preparation all = prepared_drum({"state_rate=100 Hz"}), few = prepared_drum({"state_rate=4 Hz"});
  const RunResult a = execute(all, ""), b = execute(few, "");
  EXPECT_EQ(a.trajectory.times, a.response.times) << "as often as the histories";
  EXPECT_LT(b.trajectory.times.size(), 10u);
  EXPECT_EQ(a.reproducibility.state_hash, b.reproducibility.state_hash);
  EXPECT_EQ(a.response.storeys.front().drift, b.response.storeys.front().drift);
  EXPECT_EQ(a.response.peak_base_shear.largest().value, b.response.peak_base_shear.largest().value);
  EXPECT_EQ(a.energy.kinetic, b.energy.kinetic);
  EXPECT_EQ(a.verdict.evidence, b.verdict.evidence);
  for (std::size_t k = 0; k < b.trajectory.times.size(); ++k) {
    const std::size_t same = nearest_step(a.trajectory.times, b.trajectory.times[k]);
    EXPECT_EQ(a.trajectory.times[same], b.trajectory.times[k]);
    EXPECT_EQ(a.trajectory.angle(same, 0), b.trajectory.angle(k, 0));
  }
}

TEST(OutputTimes, KeepTheFirstOfEachTickTheMomentsAndTheLast) {
  std::vector<double> times;
  for (int i = 0; i <= 100; ++i) times.push_back(0.01 * i);
  EXPECT_EQ(kept_steps(times, 100.0, {}).size(), 101u);
  EXPECT_EQ(kept_steps(times, 1000.0, {}).size(), 101u) << "no more than there are";
  EXPECT_THAT(kept_steps(times, 4.0, {}), ::testing::ElementsAre(0, 25, 50, 75, 100));
  EXPECT_THAT(kept_steps(times, 3.0, {}), ::testing::ElementsAre(0, 34, 67, 100));
  EXPECT_THAT(kept_steps(times, 0.5, {{0.123, "peak"}, {0.0, "start"}}), ::testing::ElementsAre(0, 12, 100));
  EXPECT_TRUE(kept_steps({}, 50.0, {}).empty());
}

TEST(Execute, NotesWhichBondsCrackHowAndWhen) {
  Preparation p =
      prepared({"layout=concrete-frame", "storeys=1", "bays=1", "pga=1.5 g", "duration=16 s", "rate=50 Hz"});
  const RunResult r = execute(p, "");
  std::size_t yielded = 0;
  for (const DrawnBond& bond : r.model.bonded) {
    EXPECT_EQ(bond.mode.empty(), bond.cracked == DrawnBond::never) << bond.name;
    yielded += bond.mode == "yield";
    EXPECT_GT(bond.cracked, 5.0) << "nothing cracks before the strong shaking";
  }
  EXPECT_GT(yielded, 0u);
  EXPECT_LT(yielded, r.model.bonded.size());
  EXPECT_LT(r.energy.relative_error, 1e-3) << "what cracks makes no energy";
  EXPECT_GT(r.energy.fracture.back(), 0.0);
}

TEST(Execute, TellsOnTheWayWhatAnInterruptionWouldLeave) {
  Preparation watched = prepared_drum(), stopped = prepared_drum();
  watched.scenario.output.save_every = 0.0;
  std::vector<RunResult> snapshots;
  const RunResult whole =
      execute(watched, "", {}, [&](const RunResult& so_far) { snapshots.push_back(so_far); });
  ASSERT_FALSE(snapshots.empty());
  const RunResult& snapshot = snapshots.back();
  const RunResult part =
      execute(stopped, "", [&](const Progress& p) { return p.time < snapshot.numerics.end_time; });
  EXPECT_TRUE(snapshot.partial);
  EXPECT_EQ(snapshot.trajectory.poses, part.trajectory.poses);
  EXPECT_EQ(snapshot.verdict.headline, part.verdict.headline);
  EXPECT_EQ(snapshot.numerics.steps, part.numerics.steps);
  EXPECT_EQ(snapshot.reproducibility.state_hash, part.reproducibility.state_hash);
  EXPECT_FALSE(whole.partial);
  Preparation unwatched = prepared_drum();
  EXPECT_EQ(whole.reproducibility.state_hash, execute(unwatched, "").reproducibility.state_hash);
}

TEST(Execute, TheEnergyErrorIsWhatTheColumnsLeaveOver) {
  Preparation p = prepared_drum();
  const EnergyHistory e = execute(p, "").energy;
  const auto balance = [&](std::size_t i) {
    return e.kinetic[i] + e.gravity[i] + e.elastic[i] + e.friction[i] + e.damping[i] - e.input[i];
  };
  for (std::size_t i = 0; i < e.error.size(); ++i) EXPECT_NEAR(e.error[i], balance(i) - balance(0), 1e-6);
  EXPECT_EQ(e.error.front(), 0.0);
  EXPECT_LT(e.relative_error, 0.01);
}

TEST(Execute, TheEnergyErrorIsMeasuredByWhatGravityGaveToo) {
  // A drum that falls from its neighbours' height turns over more than the ground puts in.
  Preparation p = prepared({"layout=column", "drums=3", "width=0.2 m", "pga=1 g", "duration=25 s"});
  const EnergyHistory e = execute(p, "").energy;
  const double gave = e.gravity.front() - *std::ranges::min_element(e.gravity);
  ASSERT_GT(gave, 2.0 * e.largest_input) << "the column must fall";
  double error = 0.0;
  for (const double value : e.error) error = std::max(error, std::abs(value));
  EXPECT_GE(e.relative_error, error / (gave + e.largest_input) * 0.999);
  EXPECT_LE(e.relative_error, error / gave);
}

TEST(Execute, TheStandingErrorIsMeasuredByTheInputUntilTheFirstLossOfSupport) {
  Preparation p = prepared({"layout=column", "drums=3", "width=0.2 m", "pga=1 g", "duration=25 s"});
  const RunResult r = execute(p, "");
  ASSERT_TRUE(r.response.first_loss_of_support);
  double error = 0.0, input = 0.0;
  for (std::size_t i = 0; r.response.times[i] <= *r.response.first_loss_of_support; ++i) {
    error = std::max(error, std::abs(r.energy.error[i]));
    input = std::max(input, std::abs(r.energy.input[i]));
  }
  EXPECT_DOUBLE_EQ(r.energy.standing_error, error / input);
  EXPECT_LT(r.energy.standing_error, 0.01);
  EXPECT_GE(r.energy.input_error, r.energy.standing_error * input / r.energy.largest_input);
  EXPECT_LT(r.energy.input_error, 0.02) << "gravity gives a hundred times the input";
  Preparation drum = prepared_drum();
  const RunResult stood = execute(drum, "");
  ASSERT_FALSE(stood.response.first_loss_of_support);
  EXPECT_GE(stood.energy.standing_error, stood.energy.relative_error * 0.999);
}

TEST(Execute, ARunEndsWhenTheDebrisHasHadItsTime) {
  const std::vector<std::string> falls{"layout=column", "drums=3", "width=0.2 m", "pga=1 g", "duration=25 s"};
  auto words = falls;
  words.push_back("after_collapse=1 s");
  Preparation p = prepared(words);
  const RunResult r = execute(p, "");
  ASSERT_TRUE(r.response.storeys.back().lost_at);
  double last = 0.0;
  for (const auto& storey : r.response.storeys) last = std::max(last, *storey.lost_at);
  EXPECT_GE(r.numerics.end_time, last + 1.0);
  EXPECT_LT(r.numerics.end_time, last + 2.1);  // s, it is looked for once a second
  EXPECT_EQ(r.numerics.outcome, "stopped by criterion");
  EXPECT_THAT(r.numerics.outcome_detail, HasSubstr("every storey was lost"));
  EXPECT_EQ(r.verdict.kind, VerdictKind::collapsed);
  EXPECT_FALSE(r.partial);

  words = falls;
  words.push_back("after_collapse=none");
  Preparation whole = prepared(words);
  EXPECT_EQ(execute(whole, "").numerics.outcome, "completed");
}

TEST(Execute, TheWeakestMotionIsNoNumericalFault) {
  Preparation p = prepared({"duration=1 s", "pga=1e-8 g"});
  EXPECT_EQ(execute(p, "").verdict.kind, VerdictKind::survived);
}

TEST(Execute, ProgressEndsWithThePeakDriftOfTheResponse) {
  Preparation p = prepared({"storeys=1", "duration=10 s", "pga=0.05 g"});
  Progress last;
  double before = -1.0;
  const RunResult r = execute(p, "", [&](const Progress& now) {
    EXPECT_GT(now.time, before);
    EXPECT_GE(std::abs(now.peak_drift), std::abs(last.peak_drift));
    before = now.time;
    last = now;
    return true;
  });
  EXPECT_DOUBLE_EQ(last.time, 10.0);
  EXPECT_DOUBLE_EQ(last.end_time, 10.0);
  ASSERT_NE(last.peak_drift, 0.0);
  EXPECT_NEAR(last.peak_drift, r.response.storeys[0].peak_drift.largest().value, 1e-12);
  EXPECT_EQ(last.energy_error, r.energy.relative_error);
}

TEST(Execute, AnInterruptedRunIsPartialAndUndecided) {
  Preparation p = prepared_drum();
  const RunResult r = execute(p, "", [](const Progress& now) { return now.time < 0.5; });
  EXPECT_TRUE(r.partial);
  EXPECT_EQ(r.verdict.kind, VerdictKind::undecided);
  EXPECT_NEAR(r.numerics.end_time, 0.5, 0.011);
  EXPECT_EQ(r.numerics.asked_time, 1.0);
  EXPECT_EQ(r.trajectory.times.back(), r.numerics.end_time);
}

TEST(Execute, ACompletedRunIsNotPartial) {
  Preparation p = prepared_drum();
  const RunResult r = execute(p, "dougong run x");
  EXPECT_FALSE(r.partial);
  EXPECT_EQ(r.reproducibility.command, "dougong run x");
  EXPECT_EQ(r.reproducibility.scenario_sha256.size(), 64u);
}

TEST(Execute, TheSamePreparationGivesTheSameState) {
  Preparation one = prepared_drum(), two = prepared_drum(), other = prepared_drum({"pga=0.6 g"});
  const std::string hash = execute(one, "").reproducibility.state_hash;
  EXPECT_EQ(hash, execute(two, "").reproducibility.state_hash);
  EXPECT_NE(hash, execute(other, "").reproducibility.state_hash);
}

TEST(Execute, AStepThatTheEngineRefusesIsAnErrorAndNoVerdict) {
  Preparation p = prepared_drum();
  p.drive.step = 1.0;
  try {
    execute(p, "");
    FAIL() << "a step above the bound was taken";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("solve.step"));
  }
}

// --- a building that has its verdict before anything shakes it ------------------------------------------

RunResult after_settle(Preparation& p, engine::Outcome outcome) {
  p.settle.settled = false;
  p.settle.outcome = outcome;
  p.settle.duration = 20.0;
  return execute(p, "");
}

TEST(BeforeShaking, NumbersThatFailInTheSettleAreNoCollapse) {
  Preparation p = prepared_drum();
  const RunResult r = after_settle(p, engine::Outcome::diverged);
  EXPECT_EQ(r.verdict.kind, VerdictKind::numerically_invalid);
  EXPECT_EQ(r.numerics.steps, 0u);
}

TEST(BeforeShaking, ABuildingThatOnlyCreepsIsUndecided) {
  Preparation p = prepared_drum();
  const RunResult r = after_settle(p, engine::Outcome::completed);
  EXPECT_EQ(r.verdict.kind, VerdictKind::undecided);
  EXPECT_THAT(r.verdict.headline, HasSubstr("not come to rest under its own weight"));
}

TEST(BeforeShaking, ABuildingThatFellInTheSettleCollapsed) {
  Preparation p = prepared_drum();
  p.state.y[1] -= 0.9;  // the drum is nearly a height lower
  const RunResult r = after_settle(p, engine::Outcome::completed);
  EXPECT_EQ(r.verdict.kind, VerdictKind::collapsed);
  EXPECT_THAT(r.verdict.headline, HasSubstr("does not stand under its own weight"));
}

TEST(BeforeShaking, ASofterBuildingThanItsWeightIsNotShaken) {
  Preparation p = prepared({"young_modulus=100 kPa", "duration=1 s"});
  const RunResult r = execute(p, "");
  EXPECT_EQ(r.verdict.kind, VerdictKind::numerically_invalid);
  EXPECT_EQ(r.numerics.end_time, 0.0);
}

// --- moments ----------------------------------------------------------------------------------------------

RunResult with_times(double end) {
  RunResult r;
  r.trajectory.times = {0.0, end};
  r.motion.times = {0.0, 3.0, 8.0};
  r.motion.acceleration_x = {0.0, -4.0, 2.0};
  structures::StoreyResponse storey;
  storey.name = "S1";
  storey.peak_drift.negative = {-0.02, 5.0};
  r.response.storeys = {storey};
  return r;
}

std::vector<std::string> captions(const RunResult& r) {
  std::vector<std::string> words;
  for (const Moment& moment : moments_of(r)) words.push_back(moment.caption);
  return words;
}

TEST(Moments, ComeInOrderOfTime) {
  RunResult r = with_times(10.0);
  r.response.storeys[0].lost_at = 6.0;
  r.response.first_loss_of_support = 5.5;
  EXPECT_THAT(captions(r), ::testing::ElementsAre("strongest shaking", "peak drift, S1",
                                                  "first loss of support", "S1 lost", "end"));
}

TEST(Moments, ThatLookTheSameAreShownOnce) {
  RunResult r = with_times(10.0);
  r.response.storeys[0].peak_drift.negative.time = 3.01;
  EXPECT_THAT(captions(r), ::testing::ElementsAre("strongest shaking", "end"));
}

TEST(Moments, EndWithTheRun) {
  EXPECT_THAT(captions(with_times(4.0)), ::testing::ElementsAre("strongest shaking", "end"));
}

TEST(Moments, ARunWithoutMotionHasOnlyAnEnd) {
  RunResult r = with_times(10.0);
  r.motion.acceleration_x = {0.0, 0.0, 0.0};
  r.response.storeys[0].peak_drift.negative = {};
  EXPECT_THAT(captions(r), ::testing::ElementsAre("end"));
}

}  // namespace
}  // namespace dougong::app::testing
