// dougong tilt, dougong pushover: how much of its weight a building bears sideways, and how it would go.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/cli/commands.h"
#include "app/cli/interrupts.h"
#include "app/cli/option_reading.h"
#include "app/cli/output_folder.h"
#include "app/cli/run_text.h"
#include "app/cli/terminal.h"
#include "app/report/gnuplot.h"
#include "app/report/statics_report.h"
#include "app/report/text.h"
#include "app/study/entries.h"
#include "app/study/quantity.h"

namespace dougong::app {
namespace {

namespace fs = std::filesystem;

class Reading {
 public:
  explicit Reading(const StaticsOptions& options) : o_(options) {}

  StaticChoice choice() {
    StaticChoice c;
    c.sides = sides();
    if (o_.pushover) c.pattern = pattern();
    c.precision = reading_.number("--precision", o_.precision, c.precision, Dimension::ratio, 1e-4, 0.5);
    c.first_step = reading_.number("--step", o_.step, c.first_step, Dimension::ratio, 1e-4, 1.0);
    c.largest = reading_.number("--largest", o_.largest, c.largest, Dimension::ratio, 1e-3, 100.0);
    c.hold_time = reading_.number("--hold", o_.hold, c.hold_time, Dimension::time, 0.01, 1000.0);
    c.target_drift = reading_.number("--to", o_.target, c.target_drift, Dimension::ratio, 1e-5, 1.0);
    reading_.finish();
    return c;
  }

 private:
  std::vector<structures::Direction> sides() const {
    using structures::Direction;
    if (o_.towards == "left") return {Direction::left};
    if (o_.towards == "right") return {Direction::right};
    return {Direction::left, Direction::right};
  }
  structures::LoadPattern pattern() const {
    return *std::ranges::find_if(structures::load_patterns(),
                                 [&](auto pattern) { return to_string(pattern) == o_.pattern; });
  }

  const StaticsOptions& o_;
  OptionReading reading_;
};

Scenario scenario_of(const StaticsOptions& options) {
  std::vector<Override> overrides;
  if (!options.layout.empty()) overrides.push_back({"layout.name", options.layout, "--layout"});
  for (const std::string& text : options.set) overrides.push_back(parse_override(text));
  if (options.scenario.empty()) return scenario_from(overrides, RecordRule::optional);
  return load_scenario(options.scenario, overrides, RecordRule::optional);
}

std::vector<std::string> side_lines(const StaticResult& r, const SideResult& s) {
  std::string answer = "λ " + bracket_text(s.found);
  if (!r.choice.pattern && std::isfinite(s.found.falls))
    answer += fmt::format(" ({}° to {}°)", fixed(tilt_degrees(s.found.stands), 2),
                          fixed(tilt_degrees(s.found.falls), 2));
  std::vector<std::string> lines{
      row(to_string(s.side), fmt::format("{}, {}", answer, plural(s.found.trials.size(), "trial")))};
  if (!s.mechanism.moving.empty()) {
    std::string first;
    for (std::size_t i = 0; i < std::min<std::size_t>(5, s.mechanism.moving.size()); ++i)
      first += (first.empty() ? "" : ", ") + r.model.blocks[s.mechanism.moving[i]].name;
    lines.push_back(row("", mechanism_text(s, r.model.blocks.size()) + "; most: " + first));
  }
  if (s.curve.points.empty()) return lines;
  const auto& peak = s.curve.points[s.curve.peak()];
  lines.push_back(row("", fmt::format("capacity curve: peak V/W {} at {} % roof drift; {}; {} bonds cracked",
                                      fixed(peak.multiplier, 4), significant(100.0 * peak.roof / r.height, 3),
                                      to_string(s.curve.end), s.curve.points.back().cracked)));
  if (s.curve.events.empty()) return lines;
  const auto& e = s.curve.events.front();
  lines.push_back(row("", fmt::format("first {}: {} at V/W {}", e.how, r.building.scene.bonds[e.bond].name,
                                      fixed(s.curve.points[e.point].multiplier, 4))));
  return lines;
}

/// The worst of the sides.
int exit_code_of(const StaticResult& r) {
  int code = r.interrupted ? exit_undecided : exit_survived;
  for (const SideResult& s : r.sides) {
    if (s.found.end == structures::TrialResult::numerically_invalid) return exit_numerically_invalid;
    if (s.found.end == structures::TrialResult::undecided) code = exit_undecided;
    if (s.found.falls == 0.0 && code == exit_survived) code = exit_collapsed;
  }
  return code;
}

StaticResult analyse_aloud(const Scenario& scenario, const StaticChoice& choice, Interrupts& interrupts,
                           Terminal& terminal) {
  interrupts.run_begins();
  StaticResult result = run_statics(scenario, choice, [&](const StaticProgress& progress) {
    terminal.progress(progress);
    return !interrupts.asked();
  });
  terminal.end_progress();
  return result;
}

}  // namespace

int statics_command(const StaticsOptions& options) {
  const StaticChoice choice = Reading(options).choice();
  const Scenario scenario = scenario_of(options);
  require_gnuplot();
  const std::string name =
      scenario.layout.file.empty() ? scenario.layout.name : fs::path(scenario.layout.file).stem().string();
  const OutputFolder folder(
      options.out.empty() ? fs::path(name + "-" + kind_of(choice)) : fs::path(options.out), options.force);
  Interrupts interrupts(folder.made());
  Terminal terminal(stdout);
  const StaticResult result = analyse_aloud(scenario, choice, interrupts, terminal);
  terminal.line(row("building", fmt::format("{}: {}; {}", result.model.layout, result.model.title,
                                            mass_text(result.model.mass))));
  for (const SideResult& side : result.sides)
    for (const std::string& line : side_lines(result, side)) terminal.line(line);
  for (const auto& finding : result.findings)
    terminal.line(row(to_string(finding.severity), finding.message), Tone::doubtful);
  const auto files = write_statics(result, options.command, folder.path());
  terminal.line(row("report", (folder.path() / files.front()).string()));
  terminal.line(row("files", fmt::format("{} in {}", files.size(), folder.path().string())));
  return exit_code_of(result);
}

}  // namespace dougong::app
