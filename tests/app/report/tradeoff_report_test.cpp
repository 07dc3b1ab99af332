// The CSV and the figure of a tradeoff, from made-up runs.
#include "app/report/tradeoff_report.h"

#include <gmock/gmock.h>

#include <sstream>

namespace dougong::app {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

JudgedTrial trial(const std::string& integrator, double stiffness, double part, double cost, double error) {
  JudgedTrial t;
  t.way.stiffness = stiffness;
  t.way.solve.integrator = integrator;
  t.way.solve.step_fraction = part;
  t.status = TrialStatus::completed;
  t.cpu = cost, t.simulated = 2.0, t.steps = 100, t.evaluations = 200;
  t.error = error, t.numerical = 0.5 * error;
  return t;
}

JudgedTrial without_answer(JudgedTrial t, TrialStatus status, const std::string& reason) {
  t.status = status;
  t.reason = reason;
  t.error = t.numerical = std::numeric_limits<double>::quiet_NaN();
  return t;
}

Tradeoff sample() {
  Tradeoff t;
  t.title = "a block's fall";
  t.duration = 2.0, t.motion = 0.5;
  t.models.push_back({1.0, trial("rk8", 1.0, 0.01, 9.0, 0.0), 1e-6, 0.0});
  t.models.push_back({10.0, trial("rk8", 10.0, 0.01, 9.0, 0.0), 1e-6, 0.02});
  t.trials = {trial("velocity-verlet", 1.0, 0.5, 0.2, 0.02),
              trial("velocity-verlet", 1.0, 0.1, 1.0, 0.004),
              trial("rk4", 10.0, 0.5, 2.0, 0.03),
              without_answer(trial("rk4", 1.0, 0.9, 0.1, 0.0), TrialStatus::failed, "too deep, by far"),
              without_answer(trial("explicit-euler", 1.0, 0.9, 0.0, 0.0), TrialStatus::refused, "no step"),
              without_answer(trial("rk4", 1.0, 0.1, 90.0, 0.0), TrialStatus::not_run, "too dear")};
  t.ensemble.differences = {1e-6, 2e-6};
  return t;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(TradeoffCsv, HasARowForEveryRunReferenceAndMember) {
  const std::vector<std::string> lines = lines_of(tradeoff_csv(sample()));
  ASSERT_EQ(lines.size(), 1u + 6u + 2u + 2u);
  EXPECT_THAT(lines[0], StartsWith("kind,integrator,stiffness,step fraction (1)"));
  EXPECT_EQ(lines[1], "as described,velocity-verlet,1,0.5,,,completed,,0.02,0.01,0,0.2,0.1,2,0,100,200,0");
  EXPECT_THAT(lines[2], StartsWith("run,velocity-verlet,1,0.1"));
  EXPECT_THAT(lines[2], testing::EndsWith(",1")) << "recommended";
  EXPECT_THAT(lines[7], StartsWith("reference,rk8,1,"));
  EXPECT_THAT(lines[9], AllOf(StartsWith("member,rk8,"), HasSubstr(",2e-06,")));
}

TEST(TradeoffCsv, KeepsFailuresWithTheirReasonsAndWithoutErrors) {
  const std::vector<std::string> lines = lines_of(tradeoff_csv(sample()));
  EXPECT_THAT(lines[4], HasSubstr("rk4,1,0.9,,,failed,\"too deep, by far\",,,"));
  EXPECT_THAT(lines[5], HasSubstr("refused,no step,,,"));
  EXPECT_THAT(lines[6], HasSubstr("not run,too dear,,,"));
  for (const std::string& line : lines) EXPECT_THAT(line, Not(HasSubstr("nan")));
}

TEST(TradeoffFigure, ShowsEveryRun) {
  const Figure figure = tradeoff_figure(sample());
  std::size_t points = 0;
  for (const auto& [name, data] : figure.data) points += lines_of(data).size();
  EXPECT_EQ(points, sample().trials.size()) << "failures and what was too dear among them";
  EXPECT_THAT(figure.script,
              AllOf(HasSubstr("a block''s fall"), HasSubstr("'failed'"), HasSubstr("target 1"),
                    HasSubstr("recommended"), HasSubstr("as the scene stands"), HasSubstr("x 10")));
}

TEST(TradeoffFigure, HasABandWhereTheMotionIsChaotic) {
  Tradeoff t = sample();
  EXPECT_THAT(tradeoff_figure(t).script, Not(HasSubstr("spread of")));
  t.ensemble.differences = {0.01, 0.02};
  EXPECT_THAT(tradeoff_figure(t).script, HasSubstr("spread of 2 runs"));
}

TEST(TradeoffFigure, IsDrawn) {
  const DrawnFigure drawn = draw(tradeoff_figure(sample()));
  EXPECT_THAT(drawn.svg, AllOf(HasSubstr("velocity-verlet"), HasSubstr("Processor time")));
  EXPECT_THAT(drawn.png, StartsWith("\x89PNG"));
}

TEST(TradeoffFigure, IsDrawnWhenNothingCompleted) {
  Tradeoff t = sample();
  t.trials = {t.trials[3], t.trials[4]};
  EXPECT_THAT(draw(tradeoff_figure(t)).png, StartsWith("\x89PNG"));
}

}  // namespace
}  // namespace dougong::app
