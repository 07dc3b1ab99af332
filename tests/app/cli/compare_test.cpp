// A comparison from the command line to its folder: what it refuses, keeps, and writes.
#include <signal.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "app/report/results_file.h"
#include "app/report/text.h"
#include "tests/app/cli/program_test.h"

namespace dougong::app {
namespace {

using testing::HasSubstr;
using testing::Not;

class Compare : public ProgramTest {
 protected:
  /// A drum, shaken for a second, of two heights, unless `more` says otherwise.
  std::vector<std::string> words(const std::string& out, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all{"compare", "--layout", "column", "--set", "drums=1", "--pga", "0.6 g"};
    const auto has = [&](const char* flag) { return std::ranges::find(more, flag) != more.end(); };
    if (!has("--record")) all.insert(all.end(), {"--record", "wenchuan"});
    if (!has("--vary")) all.insert(all.end(), {"--vary", "drum_height = 2, 0.5 m"});
    all.insert(all.end(), {"--set", "duration=1 s", "--out", out});
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  Ran compare(const std::string& out, const std::vector<std::string>& more = {}) const {
    return run(words(out, more), with_quick_plots());
  }
  /// The page without the command, in which the folder and the number of jobs stand.
  std::string page(const std::string& out) const {
    std::istringstream lines(read(out + "/compare.html"));
    std::string line, all;
    while (std::getline(lines, line))
      if (line.find("<pre>dougong compare ") == std::string::npos) all += line + "\n";
    return all;
  }
  void expect_same(const std::string& one, const std::string& other) const {
    EXPECT_EQ(read(one + "/compare.csv"), read(other + "/compare.csv"));
    EXPECT_EQ(read(one + "/differences.csv"), read(other + "/differences.csv"));
    EXPECT_EQ(page(one), page(other));
  }
};

std::vector<std::vector<std::string>> rows_of(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back(1);
    bool quoted = false;
    for (const char c : line) {
      if (c == '"')
        quoted = !quoted;
      else if (c == ',' && !quoted)
        rows.back().emplace_back();
      else
        rows.back().back() += c;
    }
  }
  return rows;
}

TEST_F(Compare, LeavesAFolderForEveryRunAndTablesAndAPage) {
  const Ran ran = compare("out", {"--record", "kobe", "--record", "wenchuan", "--same-sa", "no"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  for (const char* variant : {"drum_height-2-m", "drum_height-0.5-m"})
    for (const char* record : {"kobe", "wenchuan"}) {
      const std::string folder = std::string("out/") + variant + "/" + record;
      EXPECT_TRUE(exists(folder + "/summary.json")) << folder;
      EXPECT_EQ(read_results(this->folder() / folder / "results.h5").ensemble.members.size(), 1u);
    }
  for (const char* file : {"compare.html", "compare.csv", "differences.csv", "figures/differences.svg",
                           "figures/drift_profiles.svg", "figures/histories_kobe.svg"})
    EXPECT_TRUE(exists(std::string("out/") + file)) << file;
  EXPECT_THAT(ran.out, HasSubstr("too few runs to tell"));
}

TEST_F(Compare, SaysThatOneRunProvesNothing) {
  const Ran ran = compare("out", {"--same-sa", "no"});
  EXPECT_THAT(ran.out, HasSubstr("one run proves nothing"));
  EXPECT_THAT(read("out/compare.html"), HasSubstr("One run proves nothing"));
}

TEST_F(Compare, IsTheSameOnOneThreadAndOnThree) {
  ASSERT_EQ(compare("one", {"--ensemble", "5", "-j", "1"}).exit_code, 0);
  ASSERT_EQ(compare("three", {"--ensemble", "5", "-j", "3"}).exit_code, 0);
  expect_same("one", "three");
}

TEST_F(Compare, KeepsCompleteRunsAndMakesTheSameOfThem) {
  ASSERT_EQ(compare("out", {"--ensemble", "3"}).exit_code, 0);
  std::filesystem::copy(folder() / "out", folder() / "before", std::filesystem::copy_options::recursive);
  const std::string lost = "out/drum_height-0.5-m/wenchuan";
  std::filesystem::remove_all(folder() / lost);
  const Ran again = compare("out", {"--ensemble", "3"});
  EXPECT_THAT(again.out, HasSubstr("2 of 3 folders are complete"));
  EXPECT_TRUE(exists(lost + "/results.h5"));
  expect_same("out", "before");
  EXPECT_EQ(read("out/drum_height-2-m/wenchuan/results.h5"),
            read("before/drum_height-2-m/wenchuan/results.h5"));
}

TEST_F(Compare, GoesOnAfterAnInterruption) {
  const std::vector<std::string> long_one{"--ensemble", "12", "--set", "duration=12 s", "-j", "1"};
  Surroundings around = with_quick_plots();
  around.signal = SIGINT, around.when_it_says = "50 %";
  const Ran ran = run(words("out", long_one), around);
  EXPECT_EQ(ran.exit_code, 30) << ran.out << ran.err;
  EXPECT_THAT(ran.out, HasSubstr("the same command goes on"));
  EXPECT_FALSE(exists("out/compare.html"));
  const Ran on = compare("out", long_one);
  EXPECT_EQ(on.exit_code, 0) << on.err;
  EXPECT_THAT(on.out, HasSubstr("folders are complete"));
  ASSERT_EQ(compare("at-once", long_one).exit_code, 0);
  expect_same("out", "at-once");
}

TEST_F(Compare, HasTheNumbersOfItsTablesOnItsPage) {
  ASSERT_EQ(
      compare("out", {"--ensemble", "6", "--same-sa", "no", "--record", "elcentro", "--set", "duration=11 s"})
          .exit_code,
      0);
  const auto rows = rows_of(read("out/differences.csv"));
  const auto runs = rows_of(read("out/compare.csv"));
  const auto drift = std::ranges::find_if(rows, [](const auto& row) { return row[3] == "peak drift"; });
  ASSERT_NE(drift, rows.end());
  // The mean difference again, from the single runs.
  double sum = 0.0;
  for (const auto& row : runs)
    if (row[6] == "peak drift" && row[4] != "half step")
      sum += (row[0] == "drum_height = 2 m" ? -1.0 : 1.0) * std::stod(row[7]);
  EXPECT_NEAR(sum / 6.0, std::stod((*drift)[9]), 1e-15);
  EXPECT_LT(std::stod((*drift)[10]), std::stod((*drift)[9]));
  EXPECT_GT(std::stod((*drift)[11]), std::stod((*drift)[9]));
  const std::string html = read("out/compare.html");
  for (const std::size_t column : {6u, 7u, 9u, 10u, 11u}) {
    const std::string printed = significant(std::abs(100.0 * std::stod((*drift)[column])), 3) + " %";
    EXPECT_NE(html.find(printed), std::string::npos) << rows[0][column] << " " << printed;
  }
}

TEST_F(Compare, TakesVariantsFromTheScenarioFile) {
  write("study.toml",
        "[layout]\nname = \"column\"\ndrums = 1\n[record]\nname = \"wenchuan\"\n[solve]\nduration = \"1 s\"\n"
        "[[variant]]\nname = \"tall\"\nset = [\"drum_height = 2 m\"]\n"
        "[[variant]]\nname = \"flat one\"\nset = [\"drum_height = 0.5 m\", \"drums = 2\"]\n");
  const Ran ran = run({"compare", "study.toml", "--same-sa", "no"}, with_quick_plots());
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_THAT(ran.out, HasSubstr("flat one against tall"));
  EXPECT_TRUE(exists("study-compare/flat-one/wenchuan/results.h5"));
}

TEST_F(Compare, ScalesToTheSameSpectralAccelerationWhereThePeriodsDiffer) {
  const Ran differ = compare("two", {"--vary", "drums=1,3"});
  EXPECT_THAT(differ.out, HasSubstr("same Sa(T1)"));
  EXPECT_TRUE(exists("two/drums-3/wenchuan.same-sa/results.h5"));
  EXPECT_FALSE(exists("two/drums-1/wenchuan.same-sa"));
  const Ran same = compare("one", {"--vary", "layout.friction=0.6,0.7"});
  EXPECT_EQ(same.exit_code, 0) << same.err;
  EXPECT_THAT(same.out, Not(HasSubstr("same Sa(T1)")));
}

TEST_F(Compare, RefusesWhatIsNoComparison) {
  expect_refusal(words("z", {"--vary", "drum_hight = 1, 2 m"}), {"drum_hight", "drum_height"});
  expect_refusal(words("z", {"--vary", "drum_height = 1, x m"}), {"--vary", "\"x m\""});
  expect_refusal(words("z", {"--vary", "drum_height"}), {"--vary", "key=value"});
  expect_refusal(words("z", {"--vary", "drum_height = 1 m"}), {"at least two variants", "--vary"});
  expect_refusal(words("z", {"--vary", "drums = 2, 2"}), {"two of this name"});
  expect_refusal(words("z", {"--vary", "pga = 0.1, 0.2 g"}), {"record.pga", "same motion"});
  expect_refusal(words("z", {"--record", "nowhere"}), {"nowhere"});
  expect_refusal(words("z", {"--same-sa", "perhaps"}), {"--same-sa"});
}

TEST_F(Compare, RefusesATableOfAVariantThatSaysSomethingElse) {
  const auto file = [&](const std::string& variant) {
    return write("study.toml", "[record]\nname = \"kobe\"\n[[variant]]\n" + variant).string();
  };
  expect_refusal({"compare", file("nme = \"a\"\n")}, {"study.toml:4", "nme", "without a name"});
  expect_refusal({"compare", file("name = \"a\"\nset = \"drums=2\"\n")}, {"study.toml:5", "list"});
  expect_refusal({"compare", file("name = \"a\"\nset = [\"drums\"]\n")}, {"study.toml:5", "key=value"});
}

TEST_F(Compare, WritesNothingOverOfOthers) {
  write("other/notes.txt", "mine");
  expect_refusal(words("other"), {"other", "--force"}, with_quick_plots());
  ASSERT_EQ(compare("out").exit_code, 0);
  const std::string before = read("out/drum_height-2-m/wenchuan/results.h5");
  const Ran stronger = compare("out", {"--set", "taper=0.2"});
  EXPECT_EQ(stronger.exit_code, 2);
  EXPECT_THAT(stronger.err, HasSubstr("other inputs"));
  EXPECT_EQ(read("out/drum_height-2-m/wenchuan/results.h5"), before);
  EXPECT_EQ(compare("out", {"--set", "taper=0.2", "--force"}).exit_code, 0);
  EXPECT_NE(read("out/drum_height-2-m/wenchuan/results.h5"), before);
}

}  // namespace
}  // namespace dougong::app
