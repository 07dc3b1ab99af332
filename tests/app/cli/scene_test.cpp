// Free scenes as a person meets them: check, run, draw, describe.
#include <cmath>

#include "app/report/hdf5.h"
#include "tests/app/cli/program_test.h"

namespace dougong::app {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

const std::string stone = R"(title = "a stone"
[[body]]
name = "stone"
shape = "circle"
radius = "0.2 m"
position = ["0 m", "3 m"]
material = "rubber"
[[body]]
name = "other"
shape = "rectangle"
width = "1 m"
height = "0.5 m"
position = ["3 m", "0.25 m"]
material = "rubber"
[[terrain]]
shape = "half-plane"
material = "rubber"
[solve]
duration = "0.5 s"
)";

class SceneCommand : public ProgramTest {};

TEST_F(SceneCommand, ChecksASoundScene) {
  write("s.toml", stone);
  const Ran ran = run({"scene", "check", "s.toml"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_THAT(ran.out, AllOf(HasSubstr("a stone"), HasSubstr("2 bodies"), HasSubstr("nothing wrong")));
}

TEST_F(SceneCommand, ReportsEveryMistakeAtOnce) {
  write("s.toml", stone + "[output]\nrat = \"3 Hz\"\n[contact]\npoint_stiffness = 3\n");
  expect_refusal({"scene", "check", "s.toml"},
                 {"s.toml:21:1: unknown key \"output.rat\"; did you mean \"rate\"?",
                  "s.toml:23:19: contact.point_stiffness: expected a stiffness with its unit"});
  expect_refusal({"scene", "run", "s.toml", "--out", "out"}, {"did you mean \"rate\"?"});
}

TEST_F(SceneCommand, RefusesWhatIsNoSceneFile) {
  expect_refusal({"scene", "run", "nowhere.toml"}, {"expected a scene file, found nothing that can be read"});
  expect_refusal({"scene", "run", "."}, {"expected a scene file, found a folder"});
  write("bytes.toml", std::string("\x00\xff\xfe", 3));
  expect_refusal({"scene", "run", "bytes.toml"}, {"bytes.toml:1:"});
  write("scenario.toml", "[layout]\nname = \"column\"\n");
  expect_refusal({"scene", "run", "scenario.toml"}, {"unknown key \"layout\""});
}

TEST_F(SceneCommand, LeavesItsResults) {
  write("s.toml", stone);
  const Ran ran = run({"scene", "run", "s.toml", "--out", "out"});
  EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
  EXPECT_THAT(ran.out, AllOf(HasSubstr("Completed: 0.5 s simulated."), HasSubstr("energy error"),
                             HasSubstr("modelled"), HasSubstr("left out"), HasSubstr("cost")));
  for (const char* name :
       {"results.h5", "scene.toml", "bodies.csv", "energy.csv", "film-strip.png", "end.png"})
    EXPECT_TRUE(exists(std::string("out/") + name)) << name;
  EXPECT_THAT(read("out/bodies.csv"),
              AllOf(StartsWith("time (s),body,x (m),y (m),angle (rad),velocity x (m/s)"),
                    HasSubstr("\n0,stone,0,3,")));
}

TEST_F(SceneCommand, KeepsTheBodiesAndQuantitiesThatAreChosen) {
  write("s.toml", stone +
                      "[output]\nbodies = [\"stone\"]\nquantities = [\"acceleration\"]\nrate = \"20 Hz\"\n"
                      "pictures = 0\n");
  EXPECT_EQ(run({"scene", "run", "s.toml", "--out", "out"}).exit_code, 0);
  EXPECT_FALSE(exists("out/film-strip.png"));
  EXPECT_THAT(read("out/bodies.csv"), AllOf(Not(HasSubstr("other")), Not(HasSubstr("angle (rad)"))));
  const h5::Handle file = h5::open_file(folder() / "out/results.h5");
  const h5::Handle bodies = h5::open_group(file, "bodies");
  EXPECT_EQ(h5::read_texts(bodies, "name"), std::vector<std::string>{"stone"});
  EXPECT_FALSE(h5::has(bodies, "position"));
  EXPECT_EQ(h5::read_numbers(bodies, "acceleration").size(), 2 * h5::read_numbers(file, "time").size());
  EXPECT_EQ(h5::read_numbers(file, "time").size(), 11u);
  EXPECT_EQ(h5::read_numbers(h5::open_group(file, "energy"), "kinetic").size(), 11u);
}

TEST_F(SceneCommand, RunsTheSceneItWroteToTheSameBits) {
  write("s.toml", stone);
  EXPECT_EQ(run({"scene", "run", "s.toml", "--out", "a"}).exit_code, 0);
  EXPECT_EQ(run({"scene", "run", "a/scene.toml", "--out", "b"}).exit_code, 0);
  EXPECT_EQ(read("a/bodies.csv"), read("b/bodies.csv"));
}

TEST_F(SceneCommand, TakesOverrides) {
  write("s.toml", stone);
  const Ran ran = run(
      {"scene", "run", "s.toml", "--out", "out", "--set", "duration=0.2 s", "--set", "body.stone.mass=3 t"});
  EXPECT_THAT(ran.out, HasSubstr("Completed: 0.2 s"));
  EXPECT_THAT(read("out/scene.toml"), HasSubstr("mass = \"3000 kg\""));
  expect_refusal({"scene", "run", "s.toml", "--set", "body.ston.mass=3 t"}, {"did you mean \"stone\"?"});
  expect_refusal({"scene", "run", "s.toml", "--set", "duration=3"},
                 {"--set duration=3: solve.duration", "a time"});
}

TEST_F(SceneCommand, DoesNotWriteIntoAFullFolderUnlessForced) {
  write("s.toml", stone);
  write("out/mine.txt", "mine");
  expect_refusal({"scene", "run", "s.toml", "--out", "out"}, {"not empty", "--force"});
  EXPECT_EQ(run({"scene", "run", "s.toml", "--out", "out", "--force"}).exit_code, 0);
}

TEST_F(SceneCommand, SavesWhatItReachedWhenInterrupted) {
  write("s.toml", stone);
  Surroundings around;
  around.signal = SIGINT;
  around.when_it_says = "   0 %";
  const Ran ran = run(
      {"scene", "run", "s.toml", "--out", "out", "--set", "duration=600 min", "--set", "rate=1 Hz"}, around);
  EXPECT_EQ(ran.exit_code, 30) << ran.err;
  EXPECT_THAT(ran.out, HasSubstr("Interrupted at"));
  EXPECT_EQ(h5::read_integers(h5::open_file(folder() / "out/results.h5"), "partial").at(0), 1);
}

TEST_F(SceneCommand, SaysWhenTheNumbersFailed) {
  // Two blocks that start deep within each other are flung apart.
  write("s.toml",
        stone + "[[body]]\nshape = \"circle\"\nradius = \"0.3 m\"\nposition = [\"0 m\", \"3.05 m\"]\n");
  const Ran ran = run({"scene", "run", "s.toml", "--out", "out"});
  EXPECT_EQ(ran.exit_code, 20) << ran.out << ran.err;
  EXPECT_THAT(ran.out, HasSubstr("Numerically invalid at"));
  EXPECT_TRUE(exists("out/results.h5"));
}

TEST_F(SceneCommand, DrawsPngAndSvg) {
  write("s.toml", stone);
  EXPECT_EQ(run({"scene", "draw", "s.toml"}).exit_code, 0);
  EXPECT_EQ(run({"scene", "draw", "s.toml", "--out", "p.svg"}).exit_code, 0);
  EXPECT_THAT(read("s.png"), StartsWith("\x89PNG"));
  EXPECT_THAT(read("p.svg"), AllOf(StartsWith("<svg"), HasSubstr("<title>stone"), HasSubstr("</svg>")));
  expect_refusal({"scene", "draw", "s.toml", "--out", "p.svg"}, {"the file exists"});
  expect_refusal({"scene", "draw", "s.toml", "--out", "p.bmp"}, {".png or .svg"});
}

TEST_F(SceneCommand, DescribesScenesAndScenarios) {
  write("s.toml", stone);
  const Ran scene = run({"describe", "s.toml"});
  EXPECT_THAT(scene.out, AllOf(HasSubstr("Coulomb friction"), HasSubstr("frequency"), HasSubstr("cost"),
                               HasSubstr("stability bound"), HasSubstr("motion out of the plane")));
  EXPECT_THAT(listing(), testing::ElementsAre("s.toml")) << "a description leaves nothing behind";
  write("b.toml", "[layout]\nname = \"column\"\ndrums = 2\n[record]\nname = \"wenchuan\"\n");
  const Ran scenario = run({"describe", "b.toml", "--set", "duration=1 s"});
  EXPECT_EQ(scenario.exit_code, 0) << scenario.err;
  EXPECT_THAT(scenario.out, AllOf(HasSubstr("period"), HasSubstr("stability bound"), HasSubstr("cost")));
}

// 600 stars along a spiral; docs/theory/fields.md has 0.14 % for this angle.
TEST_F(SceneCommand, ShowsWhatTheTreeCostsInAccuracy) {
  std::string stars =
      "gravity = \"none\"\n[solve]\nduration = \"0.01 s\"\n"
      "[fields]\ngravitational_constant = \"1 m3/(kg s2)\"\nsoftening = \"0.1 m\"\n"
      "opening_angle = 0.5\n";
  for (int i = 0; i < 600; ++i)
    stars +=
        "[[body]]\nshape = \"circle\"\nradius = \"1 mm\"\nmass = \"1 kg\"\ncollides = false\nposition = [\"" +
        std::to_string(0.4 * std::sqrt(i) * std::cos(2.4 * i)) + " m\", \"" +
        std::to_string(0.4 * std::sqrt(i) * std::sin(2.4 * i)) + " m\"]\n";
  write("s.toml", stars);
  const auto said = HasSubstr("% of the direct sum's (rms of all 600 bodies, opening angle 0.5)");
  EXPECT_THAT(run({"describe", "s.toml"}).out, AllOf(said, HasSubstr("gravitation, at the start")));
  const Ran ran = run({"scene", "run", "s.toml", "--out", "out", "--set", "output.pictures=0"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_THAT(ran.out, AllOf(said, HasSubstr("gravitation, at the end")));
  const h5::Handle file = h5::open_file(folder() / "out/results.h5");
  const auto error_in = [&](const char* name) {
    return h5::read_numbers(h5::open_group(file, "tree"), name).at(0);
  };
  EXPECT_GT(error_in("force_error_at_start"), 1e-4);
  EXPECT_LT(error_in("force_error_at_end"), 1e-2);
}

TEST_F(SceneCommand, NamesTheShippedRecordsForOneThatIsNot) {
  write("s.toml",
        stone +
            "[[terrain]]\nname = \"table\"\nshape = \"circle\"\nradius = \"1 m\"\nposition = [\"9 m\", "
            "\"0 m\"]\nmotion = { record = \"lisbon\" }\n");
  expect_refusal({"scene", "run", "s.toml", "--out", "out"}, {"wenchuan-synthetic (wenchuan)", "\"lisbon\""});
}

TEST_F(SceneCommand, HasHelpWithExamples) {
  for (const std::vector<std::string>& words : {std::vector<std::string>{"scene", "--help"},
                                                {"scene", "run", "--help"},
                                                {"describe", "--help"},
                                                {"space", "--help"}}) {
    const Ran ran = run(words);
    EXPECT_EQ(ran.exit_code, 0);
    EXPECT_THAT(ran.out, HasSubstr("Example: dougong "));
  }
}

class SceneExamples : public ProgramTest, public testing::WithParamInterface<const char*> {};

TEST_P(SceneExamples, RunForAWhile) {
  const auto file = std::filesystem::path(DOUGONG_EXAMPLES) / GetParam();
  const Ran ran = run({"scene", "run", file.string(), "--out", "out", "--set", "duration=0.1 s"});
  EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
}
INSTANTIATE_TEST_SUITE_P(OfTheDocument, SceneExamples, testing::Values("pendulum.toml", "chute.toml"));

}  // namespace
}  // namespace dougong::app
