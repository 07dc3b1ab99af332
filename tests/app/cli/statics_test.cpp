// dougong tilt and dougong pushover: what they print, what they leave behind, how they end.
#include <signal.h>

#include <cmath>

#include "tests/app/cli/program_test.h"

namespace dougong::app {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

class Statics : public ProgramTest {
 protected:
  /// One block of 0.5 x 2 m.
  std::vector<std::string> block(const std::string& command, const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{command, "--layout",    "column", "--set",           "drums=1",
                                       "--set", "width=0.5 m", "--set",  "drum_height=2 m", "--hold",
                                       "1 s",   "--precision", "0.01",   "--out",           "out"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
};

TEST_F(Statics, ABlockTiltsToItsSlenderness) {
  const Ran ran = run(block("tilt", {}), with_quick_plots());
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_THAT(ran.out,
              AllOf(HasSubstr("left"), HasSubstr("right"), HasSubstr("1 of 1 blocks in motion, 1 hinge")));
  const json found = json::parse(read("out/tilt.json"));
  ASSERT_EQ(found["sides"].size(), 2u);
  for (const json& side : found["sides"]) {
    EXPECT_LE(side["stands"], 0.25 * 1.01);
    EXPECT_GE(side["falls"], 0.25 * 0.99);
    EXPECT_NEAR(side["tilt_falls"]["value"], std::atan(side["falls"].get<double>()) * 180 / M_PI, 1e-9);
    EXPECT_EQ(side["mechanism"]["moving_blocks"].size(), 1u);
  }
  EXPECT_THAT(read("out/trials.csv"), HasSubstr("\nleft,1,0,0,stands,"));
  EXPECT_THAT(read("out/tilt.html"), AllOf(HasSubstr("figures/mechanism_left.svg"), HasSubstr("hinge")));
  EXPECT_TRUE(exists("out/figures/mechanism_right.png"));
  EXPECT_FALSE(exists("out/capacity.csv"));
}

TEST_F(Statics, APushedBlockLosesItsResistanceAsItTurns) {
  const Ran ran = run(block("pushover", {"--towards", "left", "--to", "4 %"}), with_quick_plots());
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_THAT(ran.out, AllOf(HasSubstr("peak V/W 0.2"), HasSubstr("the target displacement was reached")));
  const json side = json::parse(read("out/pushover.json"))["sides"][0];
  EXPECT_NEAR(side["curve"]["peak_multiplier"], 0.25, 0.004);
  EXPECT_GE(side["curve"]["roof_drift_at_end"], 0.04);
  EXPECT_THAT(read("out/capacity.csv"), HasSubstr("base shear (N)"));
  EXPECT_TRUE(exists("out/figures/capacity.svg"));
}

// A block that leans on its corner, beyond the model check: it falls under its weight alone.
TEST_F(Statics, TellWhatDoesNotStand) {
  write("leaning.toml",
        "[[body]]\nname = \"block\"\nshape = \"rectangle\"\nwidth = \"0.5 m\"\nheight = \"2 m\"\n"
        "position = [\"0 m\", \"1.02519 m\"]\nangle = \"20 deg\"\n"
        "[[terrain]]\nname = \"ground\"\nshape = \"rectangle\"\nwidth = \"20 m\"\nheight = \"1 m\"\n"
        "position = [\"0 m\", \"-0.5 m\"]\n"
        "[[storey]]\nheight = \"2 m\"\nlevel = [\"block\"]\n");
  write("study.toml", "[layout]\nfile = \"leaning.toml\"\n");
  const Ran ran = run({"tilt", "study.toml", "--out", "out"}, with_quick_plots());
  EXPECT_EQ(ran.exit_code, 10) << ran.out << ran.err;
  EXPECT_THAT(ran.out, HasSubstr("0: it does not stand under its weight"));
}

TEST_F(Statics, SayWhereTheSearchEndedWithEverythingStanding) {
  const Ran ran = run(block("tilt", {"--towards", "right", "--largest", "0.1"}), with_quick_plots());
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_THAT(ran.out, HasSubstr("at least 0.1000 (the search ended there)"));
  EXPECT_TRUE(json::parse(read("out/tilt.json"))["sides"][0]["falls"].is_null());
  EXPECT_TRUE(json::parse(read("out/tilt.json"))["sides"][0]["tilt_falls"]["value"].is_null());
  EXPECT_FALSE(exists("out/figures/mechanism_right.svg"));
}

TEST_F(Statics, KeepWhatAnInterruptedSearchFound) {
  Surroundings around = with_quick_plots();
  around.signal = SIGTERM;
  around.when_it_says = "10 %";
  const Ran ran = run({"tilt", "--layout", "brick-wall", "--hold", "1 s", "--out", "out"}, around);
  EXPECT_EQ(ran.exit_code, 30) << ran.out << ran.err;
  const json found = json::parse(read("out/tilt.json"));
  EXPECT_TRUE(found["interrupted"]);
  EXPECT_GT(found["sides"][0]["stands"], 0.0);
  EXPECT_THAT(read("out/tilt.html"), HasSubstr("Interrupted."));
}

TEST_F(Statics, RefuseBadInputTogetherAndWriteNothing) {
  expect_refusal({"tilt", "--precision", "2", "--hold", "5", "--largest", "x"},
                 {"--precision: expected 0.0001 to 0.5, found 2", "--hold", "--largest"});
  expect_refusal({"pushover", "--pattern", "uniform"}, {"--pattern", "mass", "triangular"});
  expect_refusal({"tilt", "--layout", "colum"}, {"colum", "column"});
  expect_refusal({"tilt", "--pattern", "mass"}, {"unknown option \"--pattern\""});
  expect_refusal({"tilt", "none.toml"}, {"none.toml"});
}

TEST_F(Statics, WriteOverNothing) {
  std::filesystem::create_directory(folder() / "out");
  write("out/mine.txt", "keep me");
  expect_refusal(block("tilt", {}), {"not empty", "--force"});
}

}  // namespace
}  // namespace dougong::app
