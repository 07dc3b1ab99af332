// `dougong tradeoff` as a person meets it.
#include "tests/app/box_that_lands.h"
#include "tests/app/cli/program_test.h"

namespace dougong::app {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class TradeoffCommand : public ProgramTest {
 protected:
  void SetUp() override { write("box.toml", "title = \"a box that lands\"\n" + box_that_lands); }
  Ran trade(std::vector<std::string> more) const {
    std::vector<std::string> words{"tradeoff", "box.toml", "--ensemble", "2"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
};

TEST_F(TradeoffCommand, LeavesItsResultsAndSaysWhichRunToTake) {
  const Ran ran = trade({"--out", "out", "--integrators", "velocity-verlet,rk4", "--steps", "0.5,0.25",
                         "--stiffness", "10", "--target", "5 %"});
  EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
  EXPECT_THAT(ran.out, AllOf(HasSubstr("reference"), HasSubstr("resolves"), HasSubstr("2 runs that began"),
                             HasSubstr("contacts x 10: another model"), HasSubstr("0.25 of the bound"),
                             HasSubstr("Recommended, within 5"), HasSubstr("Ten times less error")));
  for (const char* name : {"tradeoff.csv", "tradeoff.png", "tradeoff.svg", "scene.toml"})
    EXPECT_TRUE(exists(std::string("out/") + name)) << name;
  EXPECT_THAT(read("out/tradeoff.csv"),
              AllOf(StartsWith("kind,integrator,stiffness"), HasSubstr("\nrun,rk4,10,0.25,")));
}

TEST_F(TradeoffCommand, HasAFolderOfItsOwnName) {
  EXPECT_EQ(trade({"--integrators", "rk4", "--steps", "0.5", "--stiffness", "1"}).exit_code, 0);
  EXPECT_TRUE(exists("box-tradeoff/tradeoff.csv"));
}

TEST_F(TradeoffCommand, ShowsWhatFailedAmongTheRest) {
  const Ran ran = trade({"--out", "out", "--integrators", "velocity-verlet", "--steps", "1.5,0.5",
                         "--stiffness", "1", "--set", "body.box.position=[\"0 m\", \"0.499 m\"]"});
  EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
  EXPECT_THAT(ran.out, HasSubstr("refused: a step of"));
  EXPECT_THAT(read("out/tradeoff.csv"), HasSubstr(",refused,a step of"));
}

TEST_F(TradeoffCommand, ReportsEveryMistakeAtOnce) {
  expect_refusal(
      {"tradeoff",     "box.toml", "--out",       "out", "--integrators", "rk5,rk4", "--steps",  "0.5,half",
       "--tolerances", "3",        "--stiffness", "0",   "--target",      "2",       "--budget", "5",
       "--measure",    "mean",     "--ensemble",  "1.5"},
      {"--integrators: there is no integrator \"rk5\"; known are velocity-verlet", "--steps: expected",
       "\"half\"", "--tolerances: expected 1e-14 to 0.1, found 3", "--stiffness: expected 1e-06",
       "--target: expected above 0 to 1, found 2", "--budget: expected a time with its unit",
       "--measure: measure: expected one of rms", "--ensemble: expected"});
}

TEST_F(TradeoffCommand, RefusesWhatItCannotRun) {
  expect_refusal({"tradeoff", "nowhere.toml"}, {"expected a scene file"});
  expect_refusal({"tradeoff"}, {"file is required"});
  expect_refusal({"tradeoff", "box.toml", "--out", "out", "--body", "bax"}, {"did you mean \"box\"?"});
  expect_refusal({"tradeoff", "box.toml", "--out", "out", "--set", "body.box.mass=3"}, {"a mass"});
}

TEST_F(TradeoffCommand, DoesNotWriteIntoAFullFolderUnlessForced) {
  write("out/mine.txt", "mine");
  expect_refusal({"tradeoff", "box.toml", "--out", "out"}, {"not empty", "--force"});
}

TEST_F(TradeoffCommand, SaysWhenThereIsNothingToMeasureBy) {
  const Ran ran = trade({"--out", "out", "--integrators", "rk4", "--budget", "1e-9 s"});
  EXPECT_EQ(ran.exit_code, 20) << ran.out << ran.err;
  EXPECT_THAT(ran.out, AllOf(HasSubstr("no reference"), HasSubstr("the budget")));
  EXPECT_FALSE(exists("out")) << "nothing is left behind";
}

TEST_F(TradeoffCommand, KeepsWhatWasRunWhenInterrupted) {
  Surroundings around;
  around.signal = SIGINT;
  around.when_it_says = "80 %";
  const Ran ran = run(
      {"tradeoff", "box.toml", "--out", "out", "--ensemble", "0", "--stiffness", "1", "--set", "duration=5 s",
       "--integrators", "velocity-verlet", "--steps", "0.9,0.5,0.4,0.3,0.2,0.1,0.05,0.02,0.01,0.005,0.002"},
      around);
  EXPECT_EQ(ran.exit_code, 30) << ran.out << ran.err;
  EXPECT_THAT(read("out/tradeoff.csv"), AllOf(HasSubstr(",completed,"), HasSubstr(",not run,interrupted,")));
}

TEST_F(TradeoffCommand, IsListedAndHasHelpWithAnExample) {
  EXPECT_THAT(run({"--help"}).out, HasSubstr("tradeoff"));
  const Ran help = run({"tradeoff", "--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_THAT(help.out, AllOf(HasSubstr("Example: dougong tradeoff"), HasSubstr("--budget")));
}

class TradeoffExamples : public ProgramTest, public testing::WithParamInterface<const char*> {};

TEST_P(TradeoffExamples, AreComparedForAWhile) {
  const auto file = std::filesystem::path(DOUGONG_EXAMPLES) / GetParam();
  const Ran ran = run({"tradeoff", file.string(), "--out", "out", "--set", "duration=0.3 s", "--integrators",
                       "velocity-verlet", "--steps", "0.5", "--stiffness", "1", "--ensemble", "0"},
                      with_quick_plots());
  EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
}
INSTANTIATE_TEST_SUITE_P(OfTheDocument, TradeoffExamples,
                         testing::Values("rocking-block.toml", "one-sine-pulse.toml", "sliding-block.toml",
                                         "two-bodies.toml", "bonded-frame.toml", "dry-wall.toml"));

}  // namespace
}  // namespace dougong::app
