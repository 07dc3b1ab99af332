#include "app/study/tradeoff/tradeoff.h"

#include <gmock/gmock.h>

#include <cmath>

#include "tests/app/study/tradeoff/tradeoff_cases.h"

namespace dougong::app {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

// --- which run to take ------------------------------------------------------------------------------

JudgedTrial made(const std::string& integrator, double part, double cost, double error,
                 TrialStatus status = TrialStatus::completed) {
  JudgedTrial t;
  t.way.solve.integrator = integrator;
  t.way.solve.step_fraction = part;
  t.status = status;
  t.cpu = cost;
  t.simulated = 1.0;
  t.error = error;
  return t;
}

TEST(Tradeoff, RecommendsTheCheapestRunWithinTheTolerance) {
  const std::vector<JudgedTrial> trials{made("a", 0.5, 1.0, 0.05), made("a", 0.1, 5.0, 0.009),
                                        made("b", 0.5, 2.0, 0.02), made("b", 0.1, 4.0, 0.008),
                                        made("c", 0.5, 9.0, 1e-6)};
  EXPECT_EQ(cheapest_within(0.01, trials), 3u);
  EXPECT_EQ(cheapest_within(0.1, trials), 0u);
  EXPECT_EQ(cheapest_within(1e-3, trials), 4u);
  EXPECT_EQ(cheapest_within(1e-9, trials), std::nullopt);
}

TEST(Tradeoff, DoesNotTrustARunThatIsRightByLuck) {
  const std::vector<JudgedTrial> trials{made("a", 0.5, 1.0, 0.001), made("a", 0.25, 2.0, 0.02),
                                        made("a", 0.1, 5.0, 0.005)};
  EXPECT_EQ(cheapest_within(0.01, trials), 2u) << "half the step errs more: the first was lucky";
}

TEST(Tradeoff, HoldsAFinerRunThatFailedAgainstACoarserOneButNotOneThatWasTooDear) {
  const auto with_finer = [](TrialStatus status) {
    return std::vector<JudgedTrial>{made("a", 0.5, 1.0, 0.001), made("a", 0.1, 5.0, NAN, status)};
  };
  EXPECT_EQ(cheapest_within(0.01, with_finer(TrialStatus::failed)), std::nullopt);
  EXPECT_EQ(cheapest_within(0.01, with_finer(TrialStatus::not_run)), 0u);
}

Tradeoff known_to(double resolution, double spread) {
  Tradeoff t;
  t.motion = 2.0;
  t.models.push_back({1.0, {}, resolution, 0.0});
  t.ensemble.differences = {spread * t.motion, spread * t.motion};
  return t;
}

TEST(Tradeoff, AsksForNoLessThanIsKnown) {
  EXPECT_DOUBLE_EQ(known_to(1e-6, 1e-6).target(), 0.01) << "what was asked for";
  EXPECT_DOUBLE_EQ(known_to(0.03, 1e-6).target(), 0.03) << "what the reference resolves";
  EXPECT_TRUE(known_to(1e-6, 0.2).chaotic());
  EXPECT_DOUBLE_EQ(known_to(1e-6, 0.2).target(), 0.4) << "twice the spread of a chaotic motion";
  EXPECT_FALSE(known_to(1e-6, 1e-4).chaotic()) << "a hundred times what it began with";
}

TEST(Tradeoff, DoesNotPromiseTenTimesLessErrorThanIsKnown) {
  Tradeoff t = known_to(1e-6, 0.05);
  t.trials = {made("a", 0.5, 1.0, 0.04), made("a", 0.1, 5.0, 1e-5)};
  EXPECT_TRUE(t.recommended());
  EXPECT_FALSE(t.ten_times_better()) << "its runs are 5 % apart";
  t.ensemble.differences.clear();
  EXPECT_EQ(t.ten_times_better(), 1u);
}

// --- runs -------------------------------------------------------------------------------------------

double slope(const std::vector<JudgedTrial>& trials) {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const JudgedTrial& t : trials) {
    const double u = std::log(static_cast<double>(t.evaluations)), v = std::log(t.error);
    n += 1.0, x += u, y += v, xx += u * u, xy += u * v;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

Tradeoff order_of(const std::string& integrator) {
  Tradeoff t = traded(orbit, with({integrator}, {0.1, 0.05, 0.025}));
  std::erase_if(t.trials, [&](const auto& trial) { return trial.way.solve.integrator != integrator; });
  return t;
}

TEST(Tradeoff, ShowsTheOrdersOfTheMethodsOnAnOrbit) {
  for (const auto& [integrator, order] :
       {std::pair{"rk4", 4.0}, {"rk3", 3.0}, {"velocity-verlet", 2.0}, {"leapfrog", 2.0}}) {
    const Tradeoff t = order_of(integrator);
    ASSERT_EQ(t.trials.size(), 3u) << integrator;
    EXPECT_NEAR(-slope(t.trials), order, 0.25) << integrator;
  }
}

TEST(Tradeoff, MeasuresByAReferenceThatIsFinerThanAnyRun) {
  const Tradeoff t = traded(orbit, with({"rk4", "rk8"}, {0.1, 0.05}));
  EXPECT_LT(t.resolution(), 1e-8);
  for (const JudgedTrial& trial : t.trials) EXPECT_GT(trial.error, t.resolution());
  EXPECT_EQ(t.models.size(), 1u);
  EXPECT_NEAR(t.motion, 2.0, 0.01) << "from periapsis 0.7 to apoapsis 1.3";
}

TEST(Tradeoff, SaysWhichIntegratorsDoNotApplyUnlessTheyWereChosen) {
  const Tradeoff all = traded(orbit, with({}, {0.1})), chosen = traded(orbit, with({"rk4"}, {0.1}));
  EXPECT_THAT(all.left_out, ElementsAre("moreau-jean: nothing touches"));
  EXPECT_THAT(all.trials, Not(Contains(::testing::Truly([](const JudgedTrial& t) {
                return t.way.solve.integrator == "moreau-jean";
              }))));
  EXPECT_TRUE(chosen.left_out.empty());
}

TEST(Tradeoff, KeepsWhatIsRefused) {
  const Tradeoff t = traded(orbit, with({"explicit-euler", "rk4"}, {0.1}));
  const JudgedTrial& euler = t.trials.at(t.own == 0 ? 1 : 0);
  EXPECT_EQ(euler.way.solve.integrator, "explicit-euler");
  EXPECT_EQ(euler.status, TrialStatus::refused);
  EXPECT_THAT(euler.reason, HasSubstr("no stable step"));
  EXPECT_TRUE(std::isnan(euler.error));
}

TEST(Tradeoff, KeepsAStepAboveTheBound) {
  std::string resting = box_that_lands;
  resting.replace(resting.find("0.51 m"), 6, "0.499 m");
  const Tradeoff t = traded(resting, with({"velocity-verlet"}, {1.5, 0.5}));
  EXPECT_EQ(t.trials.at(0).status, TrialStatus::refused);
  EXPECT_THAT(t.trials.at(0).reason, HasSubstr("above the stability bound"));
}

TEST(Tradeoff, KeepsWhatFails) {
  std::string coarse = orbit;
  coarse.replace(coarse.find("rate = \"5 Hz\""), 13, "rate = \"1 Hz\"");
  const Tradeoff t = traded(coarse, with({"symplectic-euler"}, {0.9, 0.1}));
  const auto it = std::ranges::find(t.trials, TrialStatus::failed, &Trial::status);
  ASSERT_NE(it, t.trials.end());
  EXPECT_THAT(it->reason, HasSubstr("energy"));
  EXPECT_GT(it->steps, 0u);
}

TEST(Tradeoff, TellsTheErrorOfTheStepsFromThatOfTheStiffness) {
  TradeoffChoice choice = with({"velocity-verlet"}, {0.5, 0.25});
  choice.ladder.stiffnesses = {10.0};
  const Tradeoff t = traded(box_that_lands, choice);
  ASSERT_EQ(t.models.size(), 2u) << "the scene's own stiffness is always there";
  EXPECT_GT(t.models[1].error, 0.0);
  for (const JudgedTrial& trial : t.trials) {
    if (trial.way.stiffness == 1.0)
      EXPECT_EQ(trial.error, trial.numerical);
    else
      EXPECT_LE(std::abs(trial.error - t.models[1].error), trial.numerical * (1.0 + 1e-9))
          << "the triangle of run, its model and the scene's";
  }
}

TEST(Tradeoff, StiffensAPresetThatIsNamedWithoutASection) {
  TradeoffChoice choice = with({"velocity-verlet"}, {0.5});
  choice.ladder.stiffnesses = {100.0};
  const Tradeoff t = traded(box_that_lands, choice);
  const auto stiff = std::ranges::find_if(t.trials, [](const auto& r) { return r.way.stiffness == 100.0; });
  const auto own = std::ranges::find_if(
      t.trials, [](const auto& r) { return r.way.stiffness == 1.0 && r.way.solve.step_fraction == 0.5; });
  ASSERT_TRUE(stiff != t.trials.end() && own != t.trials.end());
  EXPECT_GT(stiff->steps, 5 * own->steps) << "ten times the frequency";
}

TEST(Tradeoff, RunsWhatTheSceneItselfAsksForToo) {
  const Tradeoff t = traded(orbit, with({"rk4"}, {0.1}));
  EXPECT_EQ(t.trials.at(t.own).way.solve.integrator, "rk8") << "what the dial says of a smooth scene";
  SceneDescription d = read_scene(orbit, "s.toml");
  d.solve.integrator = "leapfrog", d.solve.step = 0.02;
  const Tradeoff named = run_tradeoff(d, shipped_records, with({"rk4"}, {0.1}));
  EXPECT_EQ(named.trials.at(named.own).way.solve.step, 0.02);
}

// Three bodies let go at the corners of a triangle of sides 3, 4, 5 meet closely again and again (Burrau).
const std::string three_bodies = R"toml(
gravity = "none"
[[body]]
shape = "circle"
radius = "0.01 m"
mass = "3 kg"
position = ["1 m", "3 m"]
collides = false
[[body]]
shape = "circle"
radius = "0.01 m"
mass = "4 kg"
position = ["-2 m", "-1 m"]
collides = false
[[body]]
shape = "circle"
radius = "0.01 m"
mass = "5 kg"
position = ["1 m", "-1 m"]
collides = false
[fields]
gravitational_constant = "1 m3/(kg s2)"
softening = "0.05 m"
[solve]
duration = "40 s"
[output]
rate = "5 Hz"
)toml";

TEST(Tradeoff, FindsWhetherAMotionIsChaotic) {
  TradeoffChoice choice = with({"rk8"}, {0.1});
  choice.members = 4;
  const Tradeoff wild = traded(three_bodies, choice), tame = traded(orbit, choice);
  EXPECT_EQ(wild.ensemble.differences.size(), 4u);
  EXPECT_TRUE(wild.chaotic()) << wild.spread();
  EXPECT_GE(wild.target(), 2.0 * wild.spread());
  EXPECT_FALSE(tame.chaotic()) << tame.spread();
  EXPECT_GT(tame.spread(), 1e-7) << "members do differ";
}

TEST(Tradeoff, DrawsTheSameMembersAgain) {
  TradeoffChoice choice = with({"rk8"}, {0.1});
  choice.members = 2;
  EXPECT_EQ(traded(orbit, choice).ensemble.differences, traded(orbit, choice).ensemble.differences);
}

TEST(Tradeoff, SaysWhenThereIsNoReference) {
  TradeoffChoice choice = with({"rk4"}, {0.1});
  choice.budget = 1e-12;
  try {
    traded(orbit, choice);
    FAIL() << "a budget of a picosecond";
  } catch (const NoReference& error) {
    EXPECT_THAT(error.what(), HasSubstr("the budget"));
  }
}

TEST(Tradeoff, RefusesASceneInWhichNothingMoves) {
  EXPECT_THROW(traded("gravity = \"none\"\n[[body]]\nshape = \"circle\"\nradius = \"1 m\"\n[solve]\n"
                      "duration = \"1 s\"\n",
                      with({"rk4"}, {0.1})),
               std::invalid_argument);
}

TEST(Tradeoff, KeepsWhatWasRunBeforeAnInterruption) {
  const Tradeoff t = traded(orbit, with({"rk4"}, {0.2, 0.1, 0.05}),
                            [](const TradeoffProgress& at) { return at.now != "rk4, step 10 ms"; });
  EXPECT_TRUE(t.interrupted);
  EXPECT_TRUE(t.trials.front().completed());
  EXPECT_EQ(t.trials.back().status, TrialStatus::not_run);
  EXPECT_EQ(t.trials.back().reason, "interrupted");
  EXPECT_TRUE(t.recommended());
}

TEST(Tradeoff, NamesABodyThatIsNotThere) {
  TradeoffChoice choice = with({"rk4"}, {0.1});
  choice.bodies = {"plant"};
  try {
    traded(orbit, choice);
    FAIL() << "there is no plant";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("did you mean \"planet\"?"));
  }
}

}  // namespace
}  // namespace dougong::app
