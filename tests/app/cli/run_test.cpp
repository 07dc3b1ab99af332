// A run from the command line to its results: what it prints where, what it keeps, how it ends.
#include <signal.h>

#include <algorithm>

#include "app/report/results_file.h"
#include "app/study/version.h"
#include "tests/app/cli/program_test.h"

namespace dougong::app {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

// Keys that the schema requires and the value lacks, or that it has and the schema does not know. The whole
// schema is checked where summaries are made (tests/app/report).
std::vector<std::string> strange_keys(const json& value, const json& schema, const std::string& place = "") {
  if (!schema.contains("properties") || !value.is_object()) return {};
  std::vector<std::string> strange;
  for (const json& key : schema.at("required"))
    if (!value.contains(key)) strange.push_back(place + "/" + key.get<std::string>() + " is missing");
  for (const auto& [key, inner] : value.items()) {
    if (!schema["properties"].contains(key)) strange.push_back(place + "/" + key + " is unknown");
    const auto below =
        strange_keys(inner, schema["properties"].value(key, json::object()), place + "/" + key);
    strange.insert(strange.end(), below.begin(), below.end());
  }
  return strange;
}

// Answers the question at the start and fails at every figure.
constexpr const char* fails_at_figures = "read first\ncase \"$first\" in *svg*) exit 0;; esac\nexit 1\n";

class Run : public ProgramTest {
 protected:
  json summary(const std::string& directory) const { return json::parse(read(directory + "/summary.json")); }
};

// --- what is printed ------------------------------------------------------------------------------------

TEST_F(Run, EveryHelpHasAnExample) {
  const std::vector<std::vector<std::string>> commands{
      {},          {"run"},    {"layouts"},        {"layout"}, {"layout", "show"},
      {"records"}, {"record"}, {"record", "info"}, {"report"}};
  for (std::vector<std::string> command : commands) {
    command.push_back("--help");
    const Ran ran = run(command);
    EXPECT_EQ(ran.exit_code, 0);
    EXPECT_THAT(ran.out, HasSubstr("Example: dougong ")) << command.front();
    EXPECT_EQ(ran.err, "");
  }
}

TEST_F(Run, TheVersionNamesTheProgramAndItsRevision) {
  const Ran ran = run({"--version"});
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_THAT(ran.out, testing::StartsWith("dougong " + program_version() + " ("));
}

TEST_F(Run, PipedOutputIsPlainAndSaysTheAnswer) {
  const Ran ran = run(short_run("out"));
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(ran.err, "");
  for (const char* word :
       {"Survived", "peak drift", "energy error", "0 of 12 blocks fell", "out/report.html"})
    EXPECT_THAT(ran.out, HasSubstr(word));
  EXPECT_THAT(ran.out, Not(HasSubstr("\033"))) << "no colours and no cursor movements in a pipe";
  EXPECT_THAT(ran.out, Not(HasSubstr("\r")));
}

TEST_F(Run, IsMadeAgainWithHalfTheStepUnlessToldNotTo) {
  const Ran ran = run(short_run("out"));
  EXPECT_THAT(ran.out, HasSubstr("half step    peak drift"));
  EXPECT_LT(ran.out.find("Survived"), ran.out.find("Running once more")) << "the answer does not wait";
  EXPECT_EQ(summary("out").at("numerics").at("half_step").at("verdict"), "survived");
  EXPECT_THAT(run({"report", "out"}).out, HasSubstr("half step    peak drift"));
  const Ran alone = run(short_run("alone", {"--set", "ensemble.half_step=false"}));
  EXPECT_THAT(alone.out, Not(HasSubstr("half step")));
  EXPECT_TRUE(summary("alone").at("numerics").at("half_step").is_null());
}

TEST_F(Run, AnEnsembleSaysHowSureTheAnswerIs) {
  const Ran ran = run(short_run("out", {"--ensemble", "3", "-j", "2"}));
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_THAT(ran.out, HasSubstr("collapsed in 0 of 3 runs: probability 0.00, 95 % interval 0.00 to 0.56"));
  EXPECT_THAT(ran.out, HasSubstr("with half the step"));
  const json ensemble = summary("out").at("ensemble");
  EXPECT_EQ(ensemble.at("runs"), 3);
  EXPECT_EQ(ensemble.at("survived"), 3);
  EXPECT_EQ(read_results(folder() / "out/results.h5").ensemble.members.size(), 3u);
  const Ran again = run({"report", "out"});
  EXPECT_THAT(again.out, HasSubstr("collapsed in 0 of 3 runs"));
}

TEST_F(Run, JsonIsAloneOnStandardOutputAndKeepsToItsSchema) {
  const Ran ran = run(short_run("out", {"--json"}));
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  const json printed = json::parse(ran.out);
  EXPECT_EQ(printed.at("verdict").at("kind"), "survived");
  EXPECT_EQ(printed, summary("out"));
  EXPECT_THAT(ran.err, HasSubstr("Preparing four-storey"));
  EXPECT_THAT(strange_keys(printed, json::parse(read_file(DOUGONG_SUMMARY_SCHEMA))), testing::IsEmpty());
}

TEST_F(Run, LayoutsAndRecordsAreListed) {
  EXPECT_THAT(run({"layouts"}).out, testing::AllOf(HasSubstr("four-storey-strong"), HasSubstr("brick-wall")));
  EXPECT_THAT(run({"records"}).out, testing::AllOf(HasSubstr("wenchuan"), HasSubstr("SYNTHETIC")));
}

TEST_F(Run, ALayoutIsShownAndDrawn) {
  const Ran ran = run({"layout", "show", "column", "--set", "drums=3", "--picture", "column.svg"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_THAT(ran.out, testing::AllOf(HasSubstr("taper_ratio"), HasSubstr("3 blocks")));
  EXPECT_THAT(read("column.svg"), HasSubstr("<svg"));
}

// --- what is kept ---------------------------------------------------------------------------------------

TEST_F(Run, TheSameRunTwiceGivesTheSameBits) {
  ASSERT_EQ(run(short_run("one", {"--pga", "0.5 g"}), with_quick_plots()).exit_code,
            run(short_run("two", {"--pga", "0.5 g"}), with_quick_plots()).exit_code);
  const RunResult one = read_results(folder() / "one/results.h5"),
                  two = read_results(folder() / "two/results.h5");
  EXPECT_FALSE(one.reproducibility.state_hash.empty());
  EXPECT_EQ(one.reproducibility.state_hash, two.reproducibility.state_hash);
  EXPECT_EQ(one.trajectory.poses, two.trajectory.poses);
  EXPECT_EQ(one.energy.error, two.energy.error);
  for (const char* table : {"drift.csv", "acceleration.csv", "energy.csv", "motion.csv"})
    EXPECT_EQ(read(std::string("one/") + table), read(std::string("two/") + table)) << table;
}

TEST_F(Run, ReportDrawsAgainWhatWasDrawnBefore) {
  ASSERT_EQ(run(short_run("out")).exit_code, 0);
  const std::string page = read("out/report.html"), table = read("out/drift.csv");
  for (const char* name : {"out/report.html", "out/drift.csv", "out/summary.json"})
    std::filesystem::remove(folder() / name);
  const Ran again = run({"report", "out"});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_THAT(again.out, HasSubstr("Survived"));
  EXPECT_EQ(read("out/report.html"), page);
  EXPECT_EQ(read("out/drift.csv"), table);
  EXPECT_TRUE(exists("out/summary.json"));
}

TEST_F(Run, AFullFolderIsWrittenIntoOnlyWhenForced) {
  write("out/mine.txt", "kept");
  ASSERT_EQ(run(short_run("out", {"--force"}), with_quick_plots()).exit_code, 0);
  EXPECT_EQ(read("out/mine.txt"), "kept");
  EXPECT_TRUE(exists("out/results.h5"));
}

TEST_F(Run, ARecordInAScenarioIsFoundFromTheFolderOfTheScenario) {
  std::string record =
      "PEER NGA STRONG MOTION DATABASE RECORD\nTest, 1/1/2000, Nowhere, 0\n"
      "ACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 200, DT= .01 SEC\n";
  for (int i = 0; i < 200; ++i) record += i % 20 < 10 ? " 0.01\n" : " -0.01\n";
  write("studies/records/small.AT2", record);
  write("studies/one.toml", "[record]\nfile = \"records/small.AT2\"\n[solve]\nduration = \"0.5 s\"\n");
  const Ran ran = run({"run", "studies/one.toml", "--out", "out"}, with_quick_plots());
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(exists("out/results.h5"));
  expect_refusal({"run", "studies/one.toml", "--record", "records/small.AT2", "--out", "other"},
                 {"records/small.AT2", "no such file"});
}

// --- how it ends ----------------------------------------------------------------------------------------

TEST_F(Run, ABuildingThatCollapsesEndsWith10) {
  const Ran ran = run({"run", "--record", "wenchuan", "--pga", "1.2 g", "--set", "storeys=1", "--set",
                       "duration=19 s", "--out", "out"},
                      with_quick_plots());
  EXPECT_EQ(ran.exit_code, 10) << ran.out << ran.err;
  EXPECT_EQ(summary("out").at("verdict").at("kind"), "collapsed");
  const json collapse = summary("out").at("collapse");
  EXPECT_EQ(collapse.at("mode"), "sway") << "one storey on two columns";
  EXPECT_LE(collapse.at("initiation"), collapse.at("complete"));
  EXPECT_LE(collapse.at("no_return"), collapse.at("complete"));
  EXPECT_THAT(ran.out, HasSubstr("fall         sway, began"));
  EXPECT_TRUE(exists("out/collapse_sequence.csv"));
}

TEST_F(Run, ScreensByTheStandardsThatAreNamed) {
  const Ran ran = run(short_run("out", {"--codes", "fema356", "--set", "screening.structure=rc frame"}),
                      with_quick_plots());
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_THAT(ran.out, HasSubstr("FEMA 356: 0 of 5 limits exceeded"));
  EXPECT_THAT(ran.out, HasSubstr("screening, not code compliance"));
  EXPECT_EQ(summary("out").at("screening").at("checks").size(), 5u);
  EXPECT_TRUE(exists("out/screening.csv"));
}

TEST_F(Run, ScreensNothingThatIsLaidDry) {
  const Ran ran = run(short_run("out"), with_quick_plots());
  EXPECT_THAT(ran.out, Not(HasSubstr("screening")));
  EXPECT_THAT(summary("out").at("screening").at("checks"), testing::IsEmpty());
}

TEST_F(Run, ABuildingThatSinksIntoItselfIsNumericallyInvalidAndNotShaken) {
  const Ran ran = run(short_run("out", {"--set", "young_modulus=100 kPa"}), with_quick_plots());
  EXPECT_EQ(ran.exit_code, 20) << ran.err;
  EXPECT_THAT(ran.out, HasSubstr("it was not shaken"));
  EXPECT_EQ(summary("out").at("numerics").at("steps"), 0);
}

class Interrupted : public Run {
 protected:
  Ran interrupted_run(int signal, const std::string& when, const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{"run", "--record", "wenchuan", "--pga", "0.01 g", "--out", "out/deep"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    Surroundings around = with_quick_plots();
    around.signal = signal;
    around.when_it_says = when;
    return run(arguments, around);
  }
};

TEST_F(Interrupted, ARunKeepsItsPartMarkedAsPartial) {
  const Ran ran = interrupted_run(SIGINT, "  0 % ", {});
  EXPECT_EQ(ran.exit_code, 30) << ran.err;
  EXPECT_THAT(ran.out,
              testing::AllOf(HasSubstr("Undecided: the run was interrupted"), HasSubstr("INTERRUPTED")));
  const RunResult result = read_results(folder() / "out/deep/results.h5");
  EXPECT_TRUE(result.partial);
  EXPECT_LT(result.numerics.end_time, result.numerics.asked_time);
  EXPECT_TRUE(summary("out/deep").at("partial").get<bool>());
  EXPECT_THAT(read("out/deep/report.html"), HasSubstr("interrupted"));
}

TEST_F(Interrupted, ABatchSystemThatEndsARunGetsAPartialResultToo) {
  EXPECT_EQ(interrupted_run(SIGTERM, "  0 % ", {}).exit_code, 30);
  EXPECT_TRUE(summary("out/deep").at("partial").get<bool>());
}

TEST_F(Interrupted, AKilledRunLeavesTheLastThatWasSaved) {
  const Ran ran = interrupted_run(SIGKILL, " 80 % ", {"--set", "output.save_every=0.1 s"});
  ASSERT_EQ(ran.signal, SIGKILL) << ran.out;
  const RunResult result = read_results(folder() / "out/deep/results.h5");
  EXPECT_TRUE(result.partial);
  EXPECT_GT(result.numerics.end_time, 0.0);
  EXPECT_EQ(result.trajectory.times.back(), result.numerics.end_time);
  const Ran drawn = run({"report", "out/deep"}, with_quick_plots());
  EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
  EXPECT_THAT(drawn.out, HasSubstr("INTERRUPTED"));
  EXPECT_TRUE(summary("out/deep").at("partial").get<bool>());
}

TEST_F(Interrupted, HalfTheStepIsLeftOutAndTheRunKept) {
  const Ran ran = interrupted_run(SIGINT, "Running once more", {});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_THAT(ran.out, testing::AllOf(HasSubstr("Survived"), Not(HasSubstr("INTERRUPTED"))));
  EXPECT_FALSE(summary("out/deep").at("partial").get<bool>());
  EXPECT_TRUE(summary("out/deep").at("numerics").at("half_step").is_null());
  EXPECT_TRUE(exists("out/deep/report.html"));
}

TEST_F(Interrupted, APreparationLeavesNothingBehind) {
  const Ran ran =
      interrupted_run(SIGINT, "Preparing",
                      {"--layout", "brick-wall", "--set", "courses=40", "--set", "bricks_per_course=20"});
  EXPECT_EQ(ran.signal, SIGINT) << ran.out;
  EXPECT_THAT(ran.err, HasSubstr("interrupted before the run began; nothing was written"));
  EXPECT_THAT(listing(), testing::IsEmpty());
}

// --- when the disk or the plots fail after the run
// ------------------------------------------------------------

TEST_F(Run, AFullDiskCostsTheFilesButNotTheAnswer) {
  Surroundings around;
  around.largest_file = 20000;
  const Ran ran = run(short_run("out/deep"), around);
  EXPECT_EQ(ran.exit_code, 2) << ran.err;
  EXPECT_THAT(ran.err, HasSubstr("results.h5"));
  EXPECT_THAT(ran.out, HasSubstr("Survived")) << "the answer is said even when it cannot be kept";
  EXPECT_THAT(listing(), testing::IsEmpty());
}

TEST_F(Run, PlotsThatFailLaterLeaveResultsAndSummary) {
  const Surroundings around = with_gnuplot(fails_at_figures);
  const Ran ran = run(short_run("out"), around);
  EXPECT_EQ(ran.exit_code, 2) << ran.out;
  EXPECT_THAT(ran.err, testing::AllOf(HasSubstr("gnuplot failed"), HasSubstr("dougong report out")));
  EXPECT_THAT(ran.out, HasSubstr("Survived"));
  EXPECT_EQ(summary("out").at("verdict").at("kind"), "survived");
  EXPECT_FALSE(exists("out/report.html"));
  EXPECT_EQ(run({"report", "out"}).exit_code, 0);
}

TEST_F(Run, AReportOfAnEarlierRunDoesNotStandBesideNewResults) {
  write("out/report.html", "of another run");
  const Surroundings around = with_gnuplot(fails_at_figures);
  EXPECT_EQ(run(short_run("out", {"--force"}), around).exit_code, 2);
  EXPECT_FALSE(exists("out/report.html"));
}

}  // namespace
}  // namespace dougong::app
