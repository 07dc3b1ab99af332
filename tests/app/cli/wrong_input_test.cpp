// What a person can get wrong on the command line and in the files it names. Every refusal says where, what
// was expected and what was found, ends with exit code 2 and leaves nothing behind.
#include <sys/stat.h>
#include <unistd.h>

#include "tests/app/cli/program_test.h"

namespace dougong::app {
namespace {

using Words = std::vector<std::string>;
class WrongInput : public ProgramTest {};

const std::string at2_head =
    "PEER NGA STRONG MOTION DATABASE RECORD\nTest, 1/1/2000, Nowhere, 0\nACCELERATION TIME SERIES IN UNITS "
    "OF G\n";

// --- the command line itself -------------------------------------------------------------------------

TEST_F(WrongInput, NoCommandNamesThemAll) {
  expect_refusal({}, {"expected a command", "run", "layouts", "report"});
}

TEST_F(WrongInput, AnUnknownCommandIsAnsweredByTheNearest) {
  expect_refusal({"runn"}, {"unknown command \"runn\"", "did you mean \"run\"?"});
  expect_refusal({"layout", "shw"}, {"unknown command \"shw\"", "did you mean \"show\"?"});
}

TEST_F(WrongInput, AnUnknownFlagIsAnsweredByTheNearest) {
  expect_refusal({"run", "--recrod", "wenchuan"},
                 {"unknown option \"--recrod\"", "did you mean \"--record\"?"});
  expect_refusal({"--bogus"}, {"unknown option \"--bogus\" of dougong"});
}

TEST_F(WrongInput, AFlagGivenTwiceIsNotQuietlyIgnored) {
  expect_refusal({"run", "--record", "wenchuan", "--record", "tohoku"}, {"--record", "received 2"});
}

TEST_F(WrongInput, AMissingArgumentIsNamed) {
  expect_refusal({"layout", "show"}, {"dougong layout show", "name is required"});
  expect_refusal({"record", "info"}, {"dougong record info", "file is required"});
  expect_refusal({"report"}, {"dougong report", "directory is required"});
  expect_refusal({"run", "--pga"}, {"--pga"});
}

TEST_F(WrongInput, AUnitThatLostItsQuotesIsNotTakenForAScenario) {
  expect_refusal({"run", "--record", "wenchuan", "--pga", "0.4", "g"},
                 {"scenario g", "in quotes", "--pga \"0.4 g\""});
}

TEST_F(WrongInput, AScenarioAfterSetIsNotTakenForAnotherSet) {
  expect_refusal({"run", "--set", "storeys=3", "nosuch.toml"}, {"nosuch.toml: expected a scenario file"});
}

// --- keys and values ----------------------------------------------------------------------------------

TEST_F(WrongInput, AnUnknownLayoutIsAnsweredByTheNearest) {
  expect_refusal(short_run("out", {"--layout", "four-story"}),
                 {"\"four-story\"", "did you mean \"four-storey\"?"});
  expect_refusal({"layout", "show", "brickwall"}, {"\"brickwall\"", "did you mean \"brick-wall\"?"});
}

TEST_F(WrongInput, AnUnknownKeyIsAnsweredByTheNearest) {
  expect_refusal(short_run("out", {"--set", "storys=3"}),
                 {"--set storys=3", "did you mean \"layout.storeys\"?"});
  expect_refusal(short_run("out", {"--set", "nonsense"}), {"--set nonsense", "expected key=value"});
}

TEST_F(WrongInput, AMistypedStandardIsAnsweredByTheNearest) {
  expect_refusal(short_run("out", {"--codes", "gb5011"}),
                 {"--codes", "screening.codes", "did you mean \"gb50011\"?"});
}

TEST_F(WrongInput, ALengthWithoutUnitListsTheUnits) {
  expect_refusal(
      short_run("out", {"--set", "left_column_width=0.3"}),
      {"left_column_width", "expected a length with its unit (m, mm, cm, km)", "found the bare number 0.3"});
}

TEST_F(WrongInput, ANegativeLengthNamesTheRange) {
  expect_refusal(short_run("out", {"--set", "left_column_width=-1 m"}),
                 {"left_column_width", "from 10 mm to 10 m", "found -1 m"});
}

TEST_F(WrongInput, APgaNeedsAUnitOfAccelerationAndMustBePositive) {
  expect_refusal(short_run("out", {"--pga", "0.4"}), {"record.pga", "an acceleration with its unit", "0.4"});
  expect_refusal(short_run("out", {"--pga", "0.4 m"}), {"record.pga", "m is a unit of length"});
  expect_refusal(short_run("out", {"--pga", "-1 g"}), {"record.pga", "expected a value from", "found -1 g"});
}

TEST_F(WrongInput, PgaAndScaleExcludeEachOther) {
  expect_refusal(short_run("out", {"--pga", "0.3 g", "--set", "scale=2"}),
                 {"record.scale and record.pga exclude each other"});
}

struct BadSetting {
  std::string setting, expected, found;
};
void PrintTo(const BadSetting& bad, std::ostream* out) {
  *out << bad.setting;
}
class BadSettings : public ProgramTest, public testing::WithParamInterface<BadSetting> {};

TEST_P(BadSettings, SayWhatIsExpected) {
  const auto& [setting, expected, found] = GetParam();
  expect_refusal(short_run("out", {"--set", setting}),
                 {setting.substr(0, setting.find('=')), expected, found});
}
INSTANTIATE_TEST_SUITE_P(
    Extreme, BadSettings,
    testing::Values(BadSetting{"storeys=1e9", "a whole number from 1 to 100", "found 1e+09"},
                    BadSetting{"storeys=0", "from 1 to 100", "found 0"},
                    BadSetting{"storeys=2.5", "a whole number", "found 2.5"},
                    BadSetting{"step_fraction=2", "from 0.0001 to 0.999", "found 2"},
                    BadSetting{"duration=0 s", "a value from", "found 0 s"},
                    BadSetting{"duration=nan s", "a", "nan"},
                    BadSetting{"rate=1e9 Hz", "from 0.01 Hz to 1000000 Hz", "found 1e+09 Hz"},
                    BadSetting{"integrator=rk5", "one of automatic, velocity-verlet",
                               "did you mean \"rk4\"?"},
                    BadSetting{"format=knets", "peer-at2, ", "found \"knets\""},
                    BadSetting{"step=1 s", "at most the stability bound of", "found 1 s"},
                    BadSetting{"slab_length=5 m", "at least", "found 5 m"}));

TEST_F(WrongInput, AWallWithoutCoursesIsRefused) {
  expect_refusal(short_run("out", {"--layout", "brick-wall", "--set", "courses=0"}),
                 {"courses", "from 1 to 400"});
}

TEST_F(WrongInput, ResultsThatDoNotFitIntoMemoryAreRefusedBeforeTheRun) {
  expect_refusal(
      {"run", "--record", "wenchuan", "--set", "rate=1e6 Hz", "--set", "duration=1e5 s", "--out", "out"},
      {"output.rate", "fit into the memory"});
}

// --- scenario files --------------------------------------------------------------------------------------

TEST_F(WrongInput, AllMistakesOfAScenarioAreListedWithTheirPlaces) {
  write("study.toml",
        "[layout]\nname = \"four-storey\"\nstorys = 3\nleft_column_width = 0.3\n\n[record]\nname = "
        "\"wenchuan\"\n"
        "pga = \"0.4 m\"\nscale = 2\n");
  expect_refusal(
      {"run", "study.toml"},
      {"study.toml:3:1: unknown key \"layout.storys\"", "study.toml:4:21: layout.left_column_width",
       "study.toml:8:7: record.pga", "study.toml:9:9: record.scale and record.pga exclude each other"});
}

TEST_F(WrongInput, AScenarioThatIsNotTomlNamesTheLine) {
  write("study.toml", "[layout]\nname = four-storey\n");
  expect_refusal({"run", "study.toml"}, {"study.toml:2:"});
}

TEST_F(WrongInput, AScenarioThatIsNotAFileIsRefused) {
  expect_refusal({"run", "."}, {".: expected a scenario file, found a folder"});
  expect_refusal({"run", "nosuch.toml"}, {"nosuch.toml: expected a scenario file"});
}

TEST_F(WrongInput, AnEmptyScenarioLacksARecord) {
  write("empty.toml", "");
  expect_refusal({"run", "empty.toml"}, {"empty.toml: no record", "record.file", "record.name"});
}

// --- records -----------------------------------------------------------------------------------------------

TEST_F(WrongInput, ARecordThatIsNotThereListsTheShippedOnes) {
  expect_refusal(short_run("out", {"--record", "nosuch"}), {"wenchuan", "tohoku", "\"nosuch\""});
  expect_refusal(short_run("out", {"--record", "nosuch.AT2"}), {"nosuch.AT2", "no such file"});
}

TEST_F(WrongInput, AFolderIsNoRecord) {
  write("folder/file", "x");
  expect_refusal(short_run("out", {"--record", "folder"}), {"folder: expected a file, found a directory"});
}

struct BadRecord {
  std::string name, text;
  Words words;
};
void PrintTo(const BadRecord& record, std::ostream* out) {
  *out << record.name;
}
class BadRecords : public ProgramTest, public testing::WithParamInterface<BadRecord> {};

TEST_P(BadRecords, NameTheFileAndTheFault) {
  const auto& [name, text, words] = GetParam();
  write(name, text);
  expect_refusal(short_run("out/deep", {"--record", name}), words);
  expect_refusal({"record", "info", name}, words);
}
INSTANTIATE_TEST_SUITE_P(
    Files, BadRecords,
    testing::Values(
        BadRecord{"empty.AT2", "", {"empty.AT2", "an empty file"}},
        BadRecord{"garbage.bin",
                  std::string("\x7f\x00\x01\xfe\xff\x80 \x03\x1b[31m", 13),
                  {"garbage.bin", "expected a known format (tried: miniSEED, SAC, K-NET"}},
        BadRecord{"cut.AT2",
                  at2_head + "NPTS= 9, DT= .01 SEC\n 0.1 0.2 0.3\n",
                  {"cut.AT2:4", "expected 9 values", "found 3", "truncated"}},
        BadRecord{"one.AT2", at2_head + "NPTS= 1, DT= .01 SEC\n 0.1\n", {"one.AT2:4", "at least 2 samples"}},
        BadRecord{"nan.AT2",
                  at2_head + "NPTS= 4, DT= .01 SEC\n 0.1 NaN 0.3 0.2\n",
                  {"nan.AT2:5", "expected finite numbers", "NaN"}}));

TEST_F(WrongInput, AFileWithoutUnitsSaysHowToGiveThem) {
  write("plain.txt", "time acceleration\n0.00 0.1\n0.01 0.2\n0.02 -0.1\n0.03 0.0\n");
  expect_refusal(short_run("out", {"--record", "plain.txt"}), {"plain.txt", "units", "--set units=gal"});
  expect_refusal({"record", "info", "plain.txt"}, {"plain.txt", "units", "--units gal"});
}

TEST_F(WrongInput, ARecordOfZerosCannotBeScaled) {
  write("zero.AT2", at2_head + "NPTS= 4, DT= .01 SEC\n 0 0 0 0\n");
  expect_refusal(short_run("out", {"--record", "zero.AT2", "--pga", "0.3 g"}), {"scale it to a PGA"});
}

TEST_F(WrongInput, AComponentThatDoesNotExistListsThoseThatDo) {
  expect_refusal(short_run("out", {"--component", "77"}), {"expected component 77", "EW"});
}

TEST_F(WrongInput, AVerticalComponentThatIsNotThereIsMissed) {
  write("alone.AT2", at2_head + "NPTS= 4, DT= .01 SEC\n 0.1 0.2 0.3 0.2\n");
  expect_refusal(short_run("out", {"--record", "alone.AT2", "--set", "vertical=true"}),
                 {"alone.AT2", "a vertical component", "record.vertical"});
}

TEST_F(WrongInput, AFileThatMustNotBeReadSaysSo) {
  ::chmod(write("secret.AT2", at2_head + "NPTS= 4, DT= .01 SEC\n 0.1 0.2 0.3 0.2\n").c_str(), 0000);
  ::chmod(folder().c_str(), 0755);
  Surroundings around;
  around.as_nobody = ::geteuid() == 0;
  if (run({"--version"}, around).exit_code != 0)
    GTEST_SKIP() << "the program cannot be started without root's rights";
  expect_refusal({"record", "info", "secret.AT2"}, {"secret.AT2", "expected a readable file"}, around);
}

// --- where the results go --------------------------------------------------------------------------------

TEST_F(WrongInput, TheOutputMustBeAFolderThatIsEmpty) {
  write("file", "kept");
  write("full/thing", "kept");
  expect_refusal(short_run("file"), {"file", "it is a file, not a folder"});
  expect_refusal(short_run("file/below"), {"file/below", "ot a directory"});
  expect_refusal(short_run("full"), {"full", "not empty", "--force"});
  EXPECT_EQ(read("full/thing"), "kept");
}

TEST_F(WrongInput, AFolderThatCannotBeWrittenIsFoundOutBeforeTheRun) {
  ::mkdir((folder() / "locked").c_str(), 0555);
  ::chmod(folder().c_str(), 0755);
  Surroundings around;
  around.as_nobody = ::geteuid() == 0;
  if (run({"--version"}, around).exit_code != 0)
    GTEST_SKIP() << "the program cannot be started without root's rights";
  expect_refusal(short_run("locked"), {"locked", "ermission denied"}, around);
  expect_refusal(short_run("locked/below"), {"locked/below", "ermission denied"}, around);
}

TEST_F(WrongInput, AFolderWithoutARunHasNoReport) {
  expect_refusal({"report", "nosuch"}, {"nosuch/results.h5"});
  write("damaged/results.h5", "not HDF5");
  expect_refusal({"report", "damaged"}, {"damaged/results.h5"});
}

TEST_F(WrongInput, APictureNeedsAKnownEndingAndIsNotWrittenOver) {
  write("wall.png", "kept");
  expect_refusal({"layout", "show", "brick-wall", "--picture", "wall.jpg"}, {"wall.jpg", ".png or .svg"});
  expect_refusal({"layout", "show", "brick-wall", "--picture", "wall.png"},
                 {"wall.png", "exists", "--force"});
  EXPECT_EQ(read("wall.png"), "kept");
}

TEST_F(WrongInput, MissingGnuplotIsFoundOutBeforeTheRun) {
  write("bin/nothing", "");
  Surroundings around;
  around.environment["PATH"] = (folder() / "bin").string();
  expect_refusal(short_run("out"), {"gnuplot is not installed", "gnuplot-nox"}, around);
}

}  // namespace
}  // namespace dougong::app
