// The message loop of `dougong space`, from a pipe and from a file, and the examples that are shipped with
// it.
#include <fstream>

#include "tests/app/cli/program_test.h"

namespace dougong::app {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string falling =
    "# a ball above a floor\n"
    "plane -1 0  1 0\n"
    "cir 0  0 0  0  500\n 0 3  0.5\n"
    "\n"
    "save scene.toml\n"
    "finish\n";

Surroundings piped(const std::string& text) {
  Surroundings around;
  around.input = text;
  return around;
}

class SpaceCommand : public ProgramTest {};

TEST_F(SpaceCommand, RunsWhatIsPipedIn) {
  const Ran ran = run({"space", "--duration", "0.5 s", "--out", "out"}, piped(falling + "10\n"));
  EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
  EXPECT_THAT(ran.out,
              AllOf(HasSubstr("Completed: 0.5 s"), HasSubstr("as asked for"), Not(HasSubstr("charge"))));
  EXPECT_TRUE(exists("out/results.h5"));
  EXPECT_TRUE(exists("out/film-strip.png"));
}

TEST_F(SpaceCommand, GivesTheSameBitsAsTheSceneItSaved) {
  EXPECT_EQ(run({"space", "--duration", "1 s", "--out", "a"}, piped(falling + "10\n")).exit_code, 0);
  EXPECT_EQ(run({"scene", "run", "scene.toml", "--out", "b"}).exit_code, 0);
  EXPECT_EQ(read("a/bodies.csv"), read("b/bodies.csv"));
  EXPECT_EQ(read("a/energy.csv"), read("b/energy.csv"));
}

TEST_F(SpaceCommand, DoesNotWriteOverASavedSceneUnlessForced) {
  write("scene.toml", "mine");
  expect_refusal({"space", "--duration", "0.1 s", "--out", "a"}, {"save scene.toml", "exists", "--force"},
                 piped(falling + "10\n"));
  EXPECT_EQ(read("scene.toml"), "mine");
  EXPECT_EQ(run({"space", "--duration", "0.1 s", "--out", "a", "--force"}, piped(falling + "10\n")).exit_code,
            0);
  EXPECT_NE(read("scene.toml"), "mine");
}

TEST_F(SpaceCommand, ShakesFromTheEquilibriumUnderGravity) {
  const Ran ran = run({"space", "--earthquake", "--duration", "0.1 s", "--out", "out"},
                      piped("plane -1 0 1 0 rect 0 0 0 0 2400 1 1 0 0.5 0 finish kobe 10"));
  EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
  EXPECT_THAT(ran.out, HasSubstr("at rest after"));
}

TEST_F(SpaceCommand, NeverTakesAnUnsafeStepSilently) {
  const Ran ran = run({"space", "--duration", "0.1 s", "--out", "out"},
                      piped("rect 0 0 0 0 2400 1 1 0 0.5 0 plane 0 0 1 0 finish 1"));
  EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
  EXPECT_THAT(ran.out, AllOf(HasSubstr("0.01 s / 1 = 0.01 s is above the stability bound"),
                             HasSubstr("half the bound"), HasSubstr("50 % of the stability bound")));
}

TEST_F(SpaceCommand, NamesTheLineOfAMistake) {
  expect_refusal({"space"}, {"standard input:2: expected mass (kg) of cir above zero, found -50"},
                 piped("cir 0 0 0\n0 -50\n"));
  expect_refusal({"space"}, {"standard input:1: expected a message", "did you mean \"rect\"?"},
                 piped("rct 0"));
  expect_refusal({"space"}, {"the end of the input"}, piped("cir 0 0"));
  expect_refusal({"space"}, {"expected message, found the end of the input"});
  expect_refusal({"space", "--duration", "10"}, {"--duration 10", "a time with its unit"}, piped(falling));
  expect_refusal({"space", "--material", "mithril"}, {"--material mithril", "concrete, brick"},
                 piped(falling));
}

TEST_F(SpaceCommand, RefusesAFolderAndAFileThatIsNotThere) {
  expect_refusal({"space", "."}, {"found a folder"});
  expect_refusal({"space", "nowhere.space"}, {"found nothing that can be read"});
}

TEST_F(SpaceCommand, ListsTheShippedRecordsForOneThatIsNot) {
  expect_refusal({"space", "--earthquake"}, {"wenchuan-synthetic (wenchuan)", "\"lisbon\""},
                 piped(falling + "lisbon\n10\n"));
}

TEST_F(SpaceCommand, ShakesTheTerrainByARecord) {
  const Ran ran =
      run({"space", "--earthquake", "--material", "rubber", "--duration", "0.2 s", "--out", "out"},
          piped(falling + "tohoku\n10\n"));
  EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
  EXPECT_THAT(read("scene.toml"),
              AllOf(HasSubstr("motion = { record = \"tohoku\" }"), HasSubstr("[materials.rubber]")));
}

TEST_F(SpaceCommand, MakesAFilmWhereThereIsFfmpeg) {
  const std::vector<std::string> words{"space", "--duration", "0.2 s", "--out", "out"};
  const std::string count = "n=0; for f in frame*.png; do n=$((n+1)); done; echo $n > film.mp4\n";
  Surroundings around = with_ffmpeg(count);
  around.input = falling + "10\n";
  EXPECT_EQ(run(words, around).exit_code, 0);
  EXPECT_EQ(read("out/film.mp4"), "6\n") << "frames every 40 ms from 0 to 0.2 s";
}

TEST_F(SpaceCommand, KeepsItsResultsWhenTheFilmFails) {
  Surroundings around = with_ffmpeg("echo no such codec; exit 1\n");
  around.input = falling + "10\n";
  const Ran ran = run({"space", "--duration", "0.1 s", "--out", "out"}, around);
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_THAT(ran.out, HasSubstr("no such codec"));
  EXPECT_TRUE(exists("out/results.h5"));
}

// --- the examples
// -------------------------------------------------------------------------------------------

struct Example {
  const char* name;
  const char* duration;
  bool earthquake = false;
};
void PrintTo(const Example& example, std::ostream* out) {
  *out << example.name;
}
class SpaceExamples : public ProgramTest, public testing::WithParamInterface<Example> {
 protected:
  static std::string document() {
    return read_file(std::filesystem::path(DOUGONG_EXAMPLES) / "../../docs/examples.md");
  }
};

TEST_P(SpaceExamples, RunForAWhileAndAreDescribed) {
  const Example& e = GetParam();
  const auto file = std::filesystem::path(DOUGONG_EXAMPLES) / (std::string(e.name) + ".space");
  std::vector<std::string> words{"space", file.string(), "--duration", e.duration, "--out", "out"};
  if (e.earthquake) words.emplace_back("--earthquake");
  const Ran ran = run(words);
  EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
  EXPECT_THAT(document(), HasSubstr(std::string(e.name) + ".space"));
}
INSTANTIATE_TEST_SUITE_P(Shipped, SpaceExamples,
                         testing::Values(Example{"table-edge", "0.5 s"}, Example{"nested-balls", "0.2 s"},
                                         Example{"wedge-80m", "2 s"}, Example{"wedge-8m", "2 s"},
                                         Example{"wedge-0.8m", "0.5 s"}, Example{"one-storey", "0.5 s"},
                                         Example{"four-storey", "0.2 s"}, Example{"ten-storey", "0.1 s"},
                                         Example{"four-storey-shaken", "0.2 s", true},
                                         Example{"two-stars", "5 s"}, Example{"three-stars", "1 s"},
                                         Example{"four-stars", "1 s"}, Example{"slingshot", "5 s"}));

TEST(SpaceExampleFiles, AreAllTested) {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(DOUGONG_EXAMPLES))
    files += entry.path().extension() == ".space" ? 1 : 0;
  EXPECT_EQ(files, 13u);
}

}  // namespace
}  // namespace dougong::app
