#include "structures/verdict.h"

#include <gmock/gmock.h>

#include <functional>
#include <limits>

namespace dougong::structures {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;
using Outcome = NumericalEvidence::Outcome;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Two storeys that shook and stand, in a run without fault.
struct Case {
  Response response;
  NumericalEvidence numerics;

  Case() {
    for (int step = 0; step <= 1000; ++step) response.times.push_back(0.01 * step);
    for (const char* name : {"S1", "S2"}) {
      StoreyResponse storey;
      storey.name = name;
      storey.height = 2.8;
      storey.drift.assign(response.times.size(), 0.001);
      storey.peak_drift.negative = {-0.0125, 5.31};
      storey.residual_drift = 0.001;
      response.storeys.push_back(storey);
    }
    response.storeys[1].peak_drift.negative = {-0.005, 5.2};
    response.blocks = 6;
    response.weight = 1e6;
    response.peak_base_shear.positive = {2.5e5, 4.2};
    response.peak_base_shear_ratio.positive = {0.25, 4.2};
    response.greatest_lean = {"S1.column.left", 0.01, 0.115};
    numerics.energy_error_ratio = 0.002;
    numerics.deepest_overlap_ratio = 0.004;
    numerics.deepest_overlap_where = "S1.slab / S2.column.left at 4.11 s";
    numerics.end_time = numerics.asked_time = 10.0;
  }
  Case& lose(std::size_t storey, double time) {
    response.storeys[storey].lost_at = time;
    response.storeys[storey].lost_because = "100 % of its level's mass was lost";
    response.losses.push_back({storey, time, "fell 0.11 m (2.41 m at the end)"});
    response.first_loss_of_support = time - 0.2;
    response.fallen_mass_fraction += 0.4;
    return *this;
  }
  Verdict judged(const VerdictCriteria& criteria = {}) const { return judge(response, numerics, criteria); }
};

struct Branch {
  const char* name;
  std::function<void(Case&)> change;
  VerdictKind kind;
  const char* headline;  // a part of it
};

void PrintTo(const Branch& branch, std::ostream* out) {
  *out << branch.name;
}

class VerdictTable : public ::testing::TestWithParam<Branch> {};

TEST_P(VerdictTable, Decides) {
  Case c;
  GetParam().change(c);
  const Verdict verdict = c.judged();
  EXPECT_EQ(verdict.kind, GetParam().kind) << verdict.headline;
  EXPECT_THAT(verdict.headline, HasSubstr(GetParam().headline));
  EXPECT_FALSE(verdict.evidence.empty());
}

constexpr auto invalid = VerdictKind::numerically_invalid;
constexpr auto collapsed = VerdictKind::collapsed;
constexpr auto undecided = VerdictKind::undecided;
constexpr auto survived = VerdictKind::survived;

INSTANTIATE_TEST_SUITE_P(
    Rules, VerdictTable,
    ::testing::Values(
        Branch{"nothing_wrong", [](Case&) {}, survived,
               "Survived: peak drift -1.25 % (-1/80) in S1 at 5.31 s, residual drift 0.1 % (1/1000) in S1; "
               "no block fell."},
        Branch{"some_fell",
               [](Case& c) {
                 c.response.losses.push_back({2, 3.0, "turned 46 deg"});
               },
               survived, "1 of 6 blocks fell"},
        Branch{"not_finite", [](Case& c) { c.numerics.finite = false; }, invalid, "stopped being finite"},
        Branch{"diverged",
               [](Case& c) {
                 c.numerics.outcome = Outcome::diverged;
                 c.numerics.end_time = 3.0;
                 c.numerics.outcome_detail = "speed of S1.slab";
               },
               invalid, "diverged at 3.00 s: speed of S1.slab"},
        Branch{"energy", [](Case& c) { c.numerics.energy_error_ratio = 0.12; }, invalid,
               "energy error is 12 % of the energy turned over, beyond 5 %"},
        Branch{"energy_is_nan", [](Case& c) { c.numerics.energy_error_ratio = nan; }, invalid,
               "energy error"},
        Branch{
            "sinking", [](Case& c) { c.numerics.deepest_overlap_ratio = 0.3; }, invalid,
            "sank into each other by 30 % of the smaller one's width, beyond 10 % (S1.slab / S2.column.left"},
        Branch{"overlap_is_nan", [](Case& c) { c.numerics.deepest_overlap_ratio = nan; }, invalid, "sank"},
        Branch{"lost_but_invalid",
               [](Case& c) {
                 c.lose(0, 4.0);
                 c.numerics.energy_error_ratio = 0.5;
               },
               invalid, "Numerically invalid"},
        Branch{"storey_lost", [](Case& c) { c.lose(1, 5.34); }, collapsed,
               "Collapsed: storey S2 was lost first, at 5.34 s."},
        Branch{"storeys_lost", [](Case& c) { c.lose(1, 5.34).lose(0, 4.1); }, collapsed,
               "storey S1 was lost first, at 4.10 s, and 2 of 2 storeys in all"},
        Branch{"mass_fell",
               [](Case& c) {
                 c.response.losses.push_back({3, 6.0, "fell 1.00 m"});
                 c.response.fallen_mass_fraction = 0.12;
               },
               collapsed, "Collapsed in part: 12 % of the mass fell, from 6.00 s on"},
        Branch{"collapsed_then_interrupted",
               [](Case& c) {
                 c.lose(0, 4.0);
                 c.numerics.outcome = Outcome::interrupted;
                 c.numerics.end_time = 5.0;
               },
               collapsed, "S1"},
        Branch{"collapsed_still_moving",
               [](Case& c) {
                 c.lose(0, 4.0);
                 c.numerics.greatest_speed_at_end = 3.0;
               },
               collapsed, "S1"},
        Branch{"interrupted",
               [](Case& c) {
                 c.numerics.outcome = Outcome::interrupted;
                 c.numerics.end_time = 5.0;
               },
               undecided, "interrupted at 5.00 s of 10.00 s"},
        Branch{"stopped",
               [](Case& c) {
                 c.numerics.outcome = Outcome::stopped;
                 c.numerics.outcome_detail = "wall time";
               },
               undecided, "stopped at 10.00 s of 10.00 s: wall time"},
        Branch{"ended_early", [](Case& c) { c.numerics.end_time = 9.5; }, undecided, "ended early"},
        Branch{"nothing_recorded", [](Case& c) { c.response = Response{}; }, undecided,
               "no output was recorded"},
        Branch{"moving", [](Case& c) { c.numerics.greatest_speed_at_end = 0.4; }, undecided,
               "still moves at 0.4 m/s"},
        Branch{"speed_is_nan", [](Case& c) { c.numerics.greatest_speed_at_end = nan; }, undecided,
               "still moves"},
        Branch{"leaning", [](Case& c) { c.response.greatest_lean.angle = -0.2; }, undecided,
               "S1.column.left leans -11.5 deg at the end and would topple alone beyond 6.6 deg"},
        Branch{"drifting",
               [](Case& c) {
                 for (std::size_t i = 0; i < 1001; ++i)
                   c.response.storeys[1].drift[i] = -0.004 * c.response.times[i];
               },
               undecided, "the drift of S2 still grows, by 0.4 % over the last 1 s"},
        Branch{"isolator_that_still_moves",
               [](Case& c) {
                 c.response.storeys[1].is_base = true;
                 for (std::size_t i = 0; i < 1001; ++i)
                   c.response.storeys[1].drift[i] = -0.004 * c.response.times[i];
               },
               survived, "Survived"},
        Branch{"swinging_back",
               [](Case& c) {
                 for (std::size_t i = 0; i < 1001; ++i)
                   c.response.storeys[1].drift[i] = 0.05 - 0.004 * c.response.times[i];
               },
               survived, "Survived"}),
    [](const auto& info) { return std::string(info.param.name); });

TEST(Verdict, ChangesAtTheBoundsThatAreAsked) {
  Case c;
  EXPECT_EQ(c.judged({.energy_error = 0.001}).kind, invalid);
  EXPECT_EQ(c.judged({.overlap = 0.001}).kind, invalid);
  EXPECT_EQ(c.judged({.lean = 0.05}).kind, undecided);
  c.response.losses.push_back({3, 6.0, "fell 1.00 m"});
  c.response.fallen_mass_fraction = 0.03;
  EXPECT_EQ(c.judged().kind, survived);
  EXPECT_EQ(c.judged({.fallen_mass = 0.02}).kind, collapsed);
}

TEST(Verdict, ProvesACollapseStoreyByStorey) {
  const Verdict verdict = Case().lose(0, 4.1).judged();
  EXPECT_THAT(verdict.evidence,
              Contains("Storey S1 was lost at 4.10 s: 100 % of its level's mass was lost; its drift "
                       "was 0.1 % (1/1000) before."));
  EXPECT_THAT(verdict.evidence, Contains("The first block lost its support at 3.90 s."));
  EXPECT_THAT(verdict.evidence, Contains("1 of 6 blocks fell, 40 % of the mass."));
}

TEST(Verdict, GivesItsEvidenceWithUnits) {
  const Verdict verdict = Case().judged();
  EXPECT_THAT(verdict.evidence, Contains("Energy error 0.2 % of the energy turned over (bound 5 %)."));
  EXPECT_THAT(verdict.evidence, Contains("Peak base shear 250 kN at 4.20 s, 0.25 of the weight."));
  EXPECT_THAT(verdict.evidence, Contains(HasSubstr("S1.column.left leans most, 0.573 deg of the 6.59 deg")));
}

TEST(Verdict, SaysNothingAboutTheBuildingWhenTheNumbersFailed) {
  Case c;
  c.lose(0, 4.1).numerics.finite = false;
  const Verdict verdict = c.judged();
  EXPECT_THAT(verdict.evidence, Contains(HasSubstr("that is not counted as collapse")));
  EXPECT_THAT(verdict.evidence, Not(Contains(HasSubstr("was lost at"))));
}

TEST(Verdict, IsNamedAsUsersReadIt) {
  EXPECT_EQ(to_string(survived), "survived");
  EXPECT_EQ(to_string(collapsed), "collapsed");
  EXPECT_EQ(to_string(invalid), "numerically invalid");
  EXPECT_EQ(to_string(undecided), "undecided");
}

}  // namespace
}  // namespace dougong::structures
