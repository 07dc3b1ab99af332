#include "app/study/code_screens.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "structures/layouts/layout.h"

namespace dougong::app {
namespace {

using structures::CodeScreen;
using structures::ScreenRow;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const ScreenRow& row(const std::string& id, const std::string& subject) {
  for (const CodeScreen& code : code_screens())
    if (code.id == id)
      for (const ScreenRow& r : code.rows)
        if (r.subject == subject) return r;
  throw std::out_of_range(id + ": " + subject);
}

std::string refusal(const std::string& text) {
  try {
    read_code_screen(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(CodeScreens, AreTheFiveStandards) {
  std::vector<std::string> ids;
  for (const CodeScreen& code : code_screens()) ids.push_back(code.id);
  EXPECT_THAT(ids, ElementsAre("asce7", "eurocode8", "fema356", "gb50011", "hazus"));
}

// Every number says where it stands and how well it is known, and limits rise within a row.
TEST(CodeScreens, HaveClauseStatusAndAscendingLimitsInEveryRow) {
  for (const CodeScreen& code : code_screens())
    for (const ScreenRow& r : code.rows) {
      EXPECT_FALSE(r.clause.empty()) << code.id << ": " << r.subject;
      EXPECT_THAT((std::vector<std::string>{"1", "2", "d"}), ::testing::Contains(r.status)) << r.subject;
      EXPECT_TRUE(std::ranges::is_sorted(r.limits, {}, &structures::DriftLimit::drift)) << r.subject;
    }
}

TEST(CodeScreens, HoldThePublishedNumbers) {
  EXPECT_EQ(row("gb50011", "RC frame, frequent earthquake, elastic").limits[0].drift, 1.0 / 550.0);
  EXPECT_EQ(row("gb50011", "RC frame, rare earthquake, elastoplastic").limits[0].drift, 1.0 / 50.0);
  EXPECT_EQ(row("fema356", "concrete frames").limits[1].drift, 0.02);
  EXPECT_EQ(row("fema356", "concrete frames").limits[1].residual, 0.01);
  EXPECT_FALSE(row("fema356", "concrete frames").limits[0].residual);  // "negligible" is no number
  EXPECT_EQ(row("asce7", "all other structures; risk category III").limits[0].drift, 0.015);
  EXPECT_NEAR(
      row("eurocode8", "brittle non-structural elements attached; importance class I, II").limits[0].drift,
      0.01, 1e-15);
  EXPECT_EQ(row("hazus", "C1L RC moment frame, moderate code").limits[3].drift, 0.06);
}

// HAZUS: middle and high rise have two thirds and half of the low-rise thresholds, pre-code 0.8 of low code.
TEST(CodeScreens, HazusThresholdsKeepTheirRatios) {
  for (const char* level : {"high code", "moderate code", "low code", "pre-code"})
    for (std::size_t i = 0; i < 4; ++i) {
      const auto at = [&](const char* height) {
        return row("hazus", std::string(height) + " RC moment frame, " + level).limits[i].drift;
      };
      EXPECT_NEAR(at("C1M"), at("C1L") * 2 / 3, 1.01e-4);
      EXPECT_NEAR(at("C1H"), at("C1L") / 2, 1.01e-4);
    }
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(row("hazus", "URML unreinforced masonry, pre-code").limits[i].drift,
                0.8 * row("hazus", "URML unreinforced masonry, low code").limits[i].drift, 1e-12);
}

TEST(CodeScreens, AFileThatIsWrongIsRefusedByItsRow) {
  const std::string head =
      "id = \"x\"\nstandard = \"X\"\nedition = \"1\"\nnote = \"n\"\n[[row]]\n"
      "subject = \"s\"\nclause = \"c\"\nstatus = \"2\"\n";
  EXPECT_THAT(refusal(head + "structures = [\"any\"]\nlimits = [\"a\"]\ndrift = [\"1/0\"]\n"),
              HasSubstr("x, row 1: expected a ratio as \"1/550\", found \"1/0\""));
  EXPECT_THAT(refusal(head + "structures = [\"castle\"]\nlimits = [\"a\"]\ndrift = [\"1/5\"]\n"),
              HasSubstr("expected a structural type, found \"castle\""));
  EXPECT_THAT(refusal(head + "structures = [\"any\"]\nlimits = [\"a\", \"b\"]\ndrift = [\"1/5\"]\n"),
              HasSubstr("as many numbers as limits"));
  EXPECT_THAT(refusal("id = \"x\"\n"), HasSubstr("x: expected a text \"standard\""));
}

TEST(ChosenScreens, AreNamedAndAMistypedIdIsAnswered) {
  EXPECT_EQ(chosen_screens("automatic").size(), 5u);
  EXPECT_THAT(chosen_screens("none"), IsEmpty());
  EXPECT_EQ(chosen_screens("gb50011, hazus")[1].id, "hazus");
  try {
    chosen_screens("gb5011");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("did you mean \"gb50011\"?"));
  }
}

ScreeningSheet sheet(const ScreeningChoice& choice, const std::string& layout,
                     structures::VerdictKind kind = structures::VerdictKind::survived) {
  structures::Response response;
  response.storeys.resize(1);
  response.storeys[0].peak_drift.positive = {0.005, 1.0};
  structures::Verdict verdict;
  verdict.kind = kind;
  return screening_of(choice, structures::build_layout(layout), response, verdict);
}

TEST(Screening, TakesTheStandardsThatHaveRowsForTheLayout) {
  const ScreeningSheet frame = sheet({}, "concrete-frame");
  EXPECT_EQ(frame.structural_type, "rc frame");
  EXPECT_EQ(frame.notes.size(), 5u);
  const ScreeningSheet house = sheet({}, "masonry-house");
  for (const auto& check : house.checks) EXPECT_THAT(check.standard, ::testing::Not(HasSubstr("GB 50011")));
  EXPECT_FALSE(house.checks.empty());
}

TEST(Screening, SaysWhyThereIsNone) {
  EXPECT_THAT(sheet({}, "four-storey").notes, ElementsAre(HasSubstr("No standard's drift limits")));
  EXPECT_THAT(sheet({}, "concrete-frame", structures::VerdictKind::numerically_invalid).notes,
              ElementsAre(HasSubstr("The numbers failed")));
  EXPECT_THAT(sheet({"none", "automatic"}, "concrete-frame").notes, IsEmpty());
  EXPECT_THAT(sheet({"gb50011", "masonry"}, "four-storey").notes,
              ElementsAre(HasSubstr("It has no row for this type")));
}

}  // namespace
}  // namespace dougong::app
