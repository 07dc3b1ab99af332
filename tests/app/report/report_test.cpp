// The whole report: which files, and that what they say is there, offline, escaped.
#include "app/report/report.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <regex>
#include <set>

#include "app/report/figures.h"
#include "app/report/html.h"
#include "app/report/image.h"
#include "app/report/page.h"
#include "app/report/safe_file.h"
#include "app/report/text.h"
#include "fixtures.h"

namespace dougong::app {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

/// End of the tag that starts at `from`, quoted attributes skipped.
std::size_t tag_end(const std::string& code, std::size_t from) {
  char quote = 0;
  for (std::size_t i = from; i < code.size(); ++i) {
    if (quote != 0) {
      if (code[i] == quote) quote = 0;
    } else if (code[i] == '"' || code[i] == '\'') {
      quote = code[i];
    } else if (code[i] == '>') {
      return i;
    }
  }
  return std::string::npos;
}

/// Why the tags do not close in order; empty when they do. `lone`: names that never close.
std::string unbalanced(const std::string& code, const std::set<std::string>& lone = {}) {
  std::vector<std::string> open;
  for (std::size_t at = 0; (at = code.find('<', at)) != std::string::npos;) {
    const std::size_t end = tag_end(code, at);
    if (end == std::string::npos) return "a tag without end";
    const std::string tag = code.substr(at + 1, end - at - 1);
    at = end;
    if (tag[0] == '!' || tag[0] == '?' || tag.back() == '/') continue;
    const std::string name = tag.substr(0, tag.find_first_of(" \t\n"));
    if (lone.count(name) > 0) continue;
    if (name[0] != '/') {
      open.push_back(name);
    } else if (open.empty() || open.back() != name.substr(1)) {
      return "<" + name + "> closes nothing";
    } else {
      open.pop_back();
    }
  }
  return open.empty() ? "" : "<" + open.back() + "> stays open";
}

/// The page without the pictures inside it.
std::string without_data(std::string page) {
  for (std::size_t at = 0; (at = page.find("base64,", at)) != std::string::npos; ++at) {
    page.erase(at, page.find('"', at) - at);
  }
  return page;
}

std::string page_of(const RunResult& run) {
  return report_page(run, {});
}

/// Another value of PATH while in scope.
class Path {
 public:
  explicit Path(const char* value) : before_(std::getenv("PATH")) { setenv("PATH", value, 1); }
  ~Path() { setenv("PATH", before_.c_str(), 1); }

 private:
  std::string before_;
};

TEST(Report, WritesEveryFileIntoAFolderWithSpaces) {
  const TemporaryDirectory folder;
  const fs::path out = folder.path() / "my run, 'quoted' ü";
  const auto files = write_report(fixtures::collapsed(), out);
  for (const fs::path& file : files) EXPECT_GT(fs::file_size(file), 100u) << file;
  for (const char* name : {"report.html",
                           "summary.json",
                           "drift.csv",
                           "acceleration.csv",
                           "roof_and_base_shear.csv",
                           "energy.csv",
                           "motion.csv",
                           "figures/motion.svg",
                           "figures/spectrum.png",
                           "figures/drift_profile.svg",
                           "figures/drift_histories.svg",
                           "figures/roof_and_base_shear.svg",
                           "figures/energy.svg",
                           "figures/overlap.svg",
                           "figures/mass_lost.svg",
                           "figures/hysteresis.svg",
                           "figures/floor_spectra.svg",
                           "figures/energy_stack.svg",
                           "floor_spectra.csv",
                           "collapse_sequence.csv",
                           "falls.csv",
                           "mass_lost.csv",
                           "figures/model.svg",
                           "figures/scene.png",
                           "figures/film_strip.png",
                           "figures/frame_8.png"}) {
    EXPECT_THAT(files, testing::Contains(out / name));
  }
  EXPECT_LT(fs::file_size(out / "report.html"), 5'000'000u);
}

TEST(Report, ARunWithoutHistoriesStillHasAReport) {
  const TemporaryDirectory folder;
  write_report(fixtures::motionless(), folder.path());
  const std::string page = read_file(folder.path() / "report.html");
  EXPECT_THAT(page, HasSubstr("nothing moved"));
  EXPECT_THAT(page, Not(HasSubstr("film_strip")));
  EXPECT_THAT(write_report({}, folder.path() / "empty"),
              testing::Contains(folder.path() / "empty" / "report.html"));
}

TEST(Report, AFolderThatCannotBeMadeIsNamed) {
  try {
    write_report(fixtures::motionless(), "/dev/full/out");
    FAIL();
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("/dev/full/out"));
  }
}

TEST(Page, ListsTheDamageOfTheBondsInOrder) {
  const std::string page = report_page(fixtures::repeated(), {});
  EXPECT_THAT(page, HasSubstr("2 of 3 bonds cracked, yielded or were crushed."));
  const auto head = page.find(">head<"), base = page.find(">base<");
  ASSERT_NE(head, std::string::npos);
  ASSERT_NE(base, std::string::npos);
  EXPECT_LT(head, base) << "the first to crack comes first";
  EXPECT_EQ(page.find(">sound<"), std::string::npos);
  EXPECT_THAT(report_page(fixtures::survived(), {}), HasSubstr("Nothing is bonded in this building."));
}

TEST(Page, TellsHowItFell) {
  const std::string page = page_of(fixtures::collapsed());
  for (const char* words :
       {"Mode: soft storey, one storey took most of the sideways displacement.", "81 % of the displacement",
        "Point of no return", "11.10 s", "140.0 kJ in all 2 blocks", "1 block fell over the end",
        "3.2 m², 6 % of the 52.0 m² before"})
    EXPECT_THAT(page, HasSubstr(words));
  EXPECT_THAT(page_of(fixtures::survived()), HasSubstr("No block was lost during the run."));
  RunResult older = fixtures::collapsed();
  older.collapse = {};
  EXPECT_THAT(page_of(older), HasSubstr("from before it was told how"));
}

TEST(Page, DoesNotTellHowFailedNumbersFell) {
  RunResult run = fixtures::survived();
  run.verdict.kind = structures::VerdictKind::numerically_invalid;
  EXPECT_THAT(page_of(run), HasSubstr("the numbers failed, so nothing is said of a fall"));
}

TEST(Page, ScreensByStandardsAndSaysThatItIsNoCompliance) {
  const std::string page = page_of(fixtures::repeated());
  for (const char* words : {"Screening, not code compliance", "concrete frames", "Table C1-3", "exceeded",
                            "A storey was lost: no limit is kept"})
    EXPECT_THAT(page, HasSubstr(words));
}

TEST(Page, SaysHowSureItIs) {
  const std::string page = report_page(fixtures::repeated(), {});
  EXPECT_THAT(
      page, HasSubstr("collapsed in 1 of 2 runs: probability 0.50, 95 % interval 0.09 to 0.91; 1 numerically "
                      "invalid; 1 not run to their end"));
  EXPECT_THAT(page, HasSubstr("Half the step changes the peak drift by 0.2"));
  EXPECT_THAT(page, HasSubstr("11.30 s"));
  EXPECT_THAT(page, Not(HasSubstr("900 %"))) << "numbers that failed are no part of a spread";
  EXPECT_THAT(report_page(fixtures::survived(), {}),
              HasSubstr("Not known from this run: the building was shaken once."));
}

TEST(Page, ShowsWhatHalfTheStepChangesOfARunThatWasMadeOnce) {
  RunResult run = fixtures::repeated();
  run.ensemble.members.resize(1);
  run.ensemble.half_step.verdict = structures::VerdictKind::survived;
  const std::string page = report_page(run, {});
  EXPECT_THAT(page, HasSubstr("With half the step: peak drift 3.30 % instead of 3.10 %, survived instead of "
                              "collapsed."));
  EXPECT_THAT(page, HasSubstr("6.5 %")) << "0.033 / 0.031";
  run.ensemble.half_step.verdict = structures::VerdictKind::collapsed;
  EXPECT_THAT(report_page(run, {}), HasSubstr("the same verdict (collapsed)"));
  run.ensemble.half_step.done = false;
  EXPECT_THAT(report_page(run, {}), HasSubstr("Not done in this run: a second run with half the step."));
}

TEST(Page, HoldsTheStiffnessUsedAgainstThatOfTheBlocks) {
  const std::string page = report_page(fixtures::survived(), {});
  EXPECT_THAT(page, HasSubstr("2.00 to 2.00 GN/m over 1 face; 1.00 to 1.00 times that of the blocks"));
  EXPECT_THAT(page, HasSubstr("0.500 to 0.500 GN/m over 1 face; 0.250 to 0.250 times"));
  EXPECT_THAT(page, HasSubstr("0.012 % of the smaller block")) << "the mean overlap";
}

TEST(Page, SaysTheVerdictTheNumbersAndThatThereIsNoSpread) {
  const std::string page = page_of(fixtures::collapsed());
  for (const char* words :
       {"Verdict: Collapsed", "S1 lost its support at 11.30 s", "78 %", "no spread computed", "2 warnings",
        "vertical ground motion", "f00dfeed01234567", "+2.846", "1/35", "lost at 11.50 s"}) {
    EXPECT_THAT(page, HasSubstr(words));
  }
  EXPECT_THAT(page_of(fixtures::partial()), HasSubstr("Partial run."));
  EXPECT_THAT(page, Not(HasSubstr("Partial run.")));
}

TEST(Page, AFailedRunSaysThatItsNumbersAreNoResult) {
  RunResult run = fixtures::collapsed();
  EXPECT_THAT(page_of(run), Not(HasSubstr("says nothing about the building")));
  run.verdict.kind = structures::VerdictKind::numerically_invalid;
  EXPECT_THAT(page_of(run), HasSubstr("says nothing about the building"));
}

TEST(Page, NeedsNoNetwork) {
  const TemporaryDirectory folder;
  write_report(fixtures::survived(), folder.path());
  const std::string page = without_data(read_file(folder.path() / "report.html"));
  EXPECT_FALSE(std::regex_search(page, std::regex("(src|href)=\"(https?:)?//")));
  EXPECT_THAT(page, Not(HasSubstr("@import")));
  EXPECT_THAT(page, Not(HasSubstr("<script")));
  EXPECT_FALSE(std::regex_search(page, std::regex("<img(?![^>]*alt=\"[^\"]+\")")));
}

TEST(Page, TagsCloseInOrder) {
  const TemporaryDirectory folder;
  write_report(fixtures::collapsed(), folder.path());
  EXPECT_EQ(unbalanced(read_file(folder.path() / "report.html"), {"meta", "img"}), "");
}

TEST(Page, EscapesWhatTheRunBrings) {
  RunResult run = fixtures::survived();
  const std::string evil = "<script>alert(\"1\")</script> & 'x'";
  run.model.layout = run.motion.title = run.verdict.headline = run.reproducibility.scenario = evil;
  run.model.parameters = {{evil, evil, evil}};
  run.model.blocks[0].name = run.response.storeys[0].name = evil;
  run.numerics.warnings = run.model.not_modelled = {evil};
  const TemporaryDirectory folder;
  write_report(run, folder.path());
  EXPECT_THAT(read_file(folder.path() / "report.html"), Not(HasSubstr("<script")));
  EXPECT_EQ(unbalanced(read_file(folder.path() / "figures/model.svg")), "");
  EXPECT_EQ(unbalanced(read_file(folder.path() / "figures/drift_profile.svg")), "");
  EXPECT_THAT(read_file(folder.path() / "figures/drift_profile.svg"), Not(HasSubstr("<script")));
}

TEST(Page, Base64IsTheStandardOne) {
  EXPECT_EQ(base64("Man"), "TWFu");
  EXPECT_EQ(base64("Ma"), "TWE=");
  EXPECT_EQ(base64("M"), "TQ==");
  EXPECT_EQ(base64(""), "");
}

TEST(Plots, AreWellFormedSvgWithTextAndPngAtTwice) {
  for (const NamedFigure& named : all_figures(fixtures::collapsed())) {
    const DrawnFigure drawn = draw(named.figure);
    EXPECT_EQ(unbalanced(drawn.svg), "") << named.name;
    EXPECT_THAT(drawn.svg, HasSubstr("</text>")) << named.name;
    const Image png = image_of(drawn.png);
    EXPECT_EQ(png.width, 2 * named.figure.width) << named.name;
    EXPECT_EQ(png.height, 2 * named.figure.height) << named.name;
  }
}

TEST(Plots, TheProfileNamesPeaksOfBothSignsAndLosses) {
  const std::string svg = draw(drift_profile_figure(fixtures::collapsed())).svg;
  for (const char* words : {"+2.85 % at 10.78 s", "−2.83 % at 11.10 s", "lost at 11.30 s", "S4"})
    EXPECT_THAT(svg, HasSubstr(words));
}

TEST(Plots, TheProfileDrawsTheRaftOnItsIsolators) {
  RunResult run = fixtures::survived();
  auto& raft = run.response.storeys.front();
  raft.is_base = true, raft.name = "raft";
  const auto [least, most] = std::ranges::minmax(raft.floor_displacement);
  const std::string svg = draw(drift_profile_figure(run)).svg;
  EXPECT_THAT(svg, HasSubstr("raft on isolators: " + displacement(most) + " and " + displacement(least)));
  EXPECT_THAT(draw(drift_profile_figure(fixtures::survived())).svg, Not(HasSubstr("isolators")));
}

TEST(Plots, OfAnEnsembleDrawEveryRunAndWhatTheStepDoes) {
  const RunResult run = fixtures::repeated();
  ASSERT_TRUE(has_ensemble_figure(run));
  EXPECT_FALSE(has_ensemble_figure(fixtures::collapsed())) << "run once";
  const Figure figure = ensemble_figure(run);
  const std::string svg = draw(figure).svg;
  EXPECT_EQ(unbalanced(svg), "");
  for (const char* words :
       {"as described", "half the step", "each run", "16 to 84 %", "collapsed", "survived"})
    EXPECT_THAT(svg, HasSubstr(words));
  EXPECT_THAT(svg, Not(HasSubstr("undecided"))) << "that run was left out";
  EXPECT_THAT(figure.data.at("step.txt"), HasSubstr("3.1 1\n3.3 1"));
}

TEST(Plots, ALongRecordStaysSmall) {
  const RunResult run = fixtures::long_record();
  EXPECT_LT(draw(motion_figure(run)).svg.size(), 400'000u);
  EXPECT_LT(draw(drift_histories_figure(run)).svg.size(), 400'000u);
}

TEST(Plots, GnuplotsOwnMessageComesThrough) {
  try {
    draw({100, 100, "plot 'no such file' with nonsense\n", {}});
    FAIL();
  } catch (const PlotError& error) {
    EXPECT_THAT(error.what(), HasSubstr("nonsense"));
  }
}

TEST(Plots, WithoutGnuplotThePackageIsNamed) {
  const Path nowhere("/nonexistent");
  try {
    draw({100, 100, "plot 1\n", {}});
    FAIL();
  } catch (const PlotError& error) {
    EXPECT_THAT(error.what(), HasSubstr("gnuplot-nox"));
  }
}

TEST(Plots, ACheckThatTheTagCheckSees) {
  EXPECT_NE(unbalanced("<svg><g></svg>"), "");
  EXPECT_EQ(unbalanced("<svg><g a=\"1\"/></svg>"), "");
}

}  // namespace
}  // namespace dougong::app
