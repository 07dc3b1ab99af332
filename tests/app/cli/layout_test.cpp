// The commands of layouts: a table, a picture, the check, what is written and what is read back.
#include "tests/app/cli/program_test.h"

namespace dougong::app {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class LayoutCommands : public ProgramTest {};

TEST_F(LayoutCommands, TheTableHasPeriods) {
  const Ran ran = run({"layouts"});
  EXPECT_THAT(ran.out, AllOf(HasSubstr("period"), HasSubstr("concrete-frame"), HasSubstr("dougong-hall")));
  EXPECT_THAT(ran.out, HasSubstr("0.598 s")) << "of the concrete frame";
}

TEST_F(LayoutCommands, ThePageDrawsEachWithItsParameters) {
  const Ran ran = run({"layouts", "--page", "all.html"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_THAT(read("all.html"), AllOf(HasSubstr("Elevation of pagoda"), HasSubstr("0.598 s"),
                                      HasSubstr("column_reinforcement"), HasSubstr("image/svg+xml")));
  EXPECT_EQ(run({"layouts", "--page", "all.html"}).exit_code, 2) << "nothing is written over";
  EXPECT_EQ(run({"layouts", "--page", "all.png"}).exit_code, 2);
}

TEST_F(LayoutCommands, DrawTakesValuesByPosition) {
  const Ran ran =
      run({"layout", "draw", "concrete-frame", "storeys=1", "infill=all-storeys", "--out", "frame.svg"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_THAT(read("frame.svg"), AllOf(HasSubstr("S1.infill1.1"), HasSubstr("class=\"bonds\"")));
}

TEST_F(LayoutCommands, CheckSettlesAndSaysThePeriod) {
  const Ran ran = run({"layout", "check", "masonry-house", "ties=every-floor"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_THAT(ran.out, AllOf(HasSubstr("6 joints"), HasSubstr("settled after"),
                             HasSubstr("0 of 56 bond points"), HasSubstr("period 0.2")));
}

// Six drums of 1 m2 and 2600 kg: 6 x 2600 x 9.80665 / 1 m2 at the foot.
TEST_F(LayoutCommands, CheckSaysWhatTheJointsBear) {
  const Ran ran = run({"layout", "check", "column", "--out", "column.svg"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_THAT(ran.out, AllOf(HasSubstr("greatest compression 0.153 MPa in S1.drum / ground"),
                             HasSubstr("the most used of 6 joints"), HasSubstr("153.0")));
  EXPECT_THAT(read("column.svg"), HasSubstr("Use of the joints"));
  EXPECT_EQ(run({"layout", "check", "column", "--out", "column.svg"}).exit_code, 2);
}

TEST_F(LayoutCommands, ModesSaysPeriodsMassesAndShapes) {
  const Ran ran =
      run({"layout", "modes", "concrete-frame", "storeys=2", "bays=1", "--count", "3", "--out", "out"},
          with_quick_plots());
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_THAT(ran.out, AllOf(HasSubstr("effective mass (%)"), HasSubstr("modes.html")));
  EXPECT_THAT(read("out/modes.csv"), HasSubstr("\n3,"));
  EXPECT_THAT(read("out/mode_shapes.csv"), HasSubstr("\n1,S1.column1.1,"));
  EXPECT_THAT(read("out/modes.html"), HasSubstr("Mode 3: T = "));
  EXPECT_TRUE(exists("out/figures/mode_3.png"));
  expect_refusal({"layout", "modes", "concrete-frame", "--count", "0"}, {"--count"});
}

TEST_F(LayoutCommands, CheckFailsOnErrors) {
  const Ran ran = run({"layout", "check", "masonry-house", "on.name=equipment", "on.floor_thickness=0 m",
                       "on.item_height=2.7 m", "on.item_width=1 m"});
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_THAT(ran.out, HasSubstr("overlaps on.cabinet"));
}

TEST_F(LayoutCommands, ExportedScenesAndDrawingsComeBack) {
  EXPECT_EQ(run({"layout", "export", "pagoda", "storeys=2", "--out", "pagoda.toml"}).exit_code, 0);
  const Ran again = run({"layout", "check", "pagoda.toml"});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_THAT(again.out, HasSubstr("19 blocks, 1 bonds, 0 joints"));

  EXPECT_EQ(run({"layout", "export", "pagoda", "storeys=2", "--out", "pagoda.dxf"}).exit_code, 0);
  const Ran imported = run({"layout", "import", "pagoda.dxf", "--material", "timber", "--out", "again.toml"});
  EXPECT_EQ(imported.exit_code, 0) << imported.err;
  EXPECT_THAT(imported.out, AllOf(HasSubstr("19 blocks, 0 bonds"), HasSubstr("left out: 1 entities")));
  EXPECT_EQ(run({"layout", "draw", "again.toml", "--out", "again.svg"}).exit_code, 0);
}

TEST_F(LayoutCommands, WriteOverNothing) {
  write("there.toml", "keep me");
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"layout", "export", "column", "--out", "there.toml"},
        {"layout", "import", "none.dxf", "--out", "there.toml"}}) {
    const Ran ran = run(command);
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_THAT(ran.err, HasSubstr("the file exists"));
  }
  EXPECT_EQ(read("there.toml"), "keep me");
}

TEST_F(LayoutCommands, RefuseWhatTheyCannotDo) {
  EXPECT_THAT(run({"layout", "export", "column", "--out", "column.pdf"}).err,
              HasSubstr(".toml, .svg or .dxf"));
  EXPECT_THAT(run({"layout", "import", "column.pdf", "--out", "column.toml"}).err, HasSubstr(".dxf or .csv"));
  EXPECT_THAT(run({"layout", "draw", "column", "drum=3"}).err, HasSubstr("did you mean \"layout.drums\"?"));
  EXPECT_THAT(run({"layout", "draw", "nothing.toml"}).err, HasSubstr("nothing.toml"));
}

}  // namespace
}  // namespace dougong::app
