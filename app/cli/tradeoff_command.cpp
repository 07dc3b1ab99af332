#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/interrupts.h"
#include "app/cli/option_reading.h"
#include "app/cli/output_folder.h"
#include "app/cli/tradeoff_text.h"
#include "app/report/tradeoff_report.h"
#include "app/study/entries.h"
#include "app/study/key.h"
#include "app/study/quantity.h"
#include "app/study/scene_file.h"
#include "engine/integrators/table.h"

namespace dougong::app {
namespace {

namespace fs = std::filesystem;

class Reading {
 public:
  explicit Reading(const TradeoffOptions& options) : o_(options) {}

  TradeoffChoice choice() {
    TradeoffChoice c;
    c.ladder.integrators = integrators();
    c.ladder.steps = numbers("--steps", o_.steps, above_zero, 100.0);
    c.ladder.tolerances = numbers("--tolerances", o_.tolerances, 1e-14, 0.1);
    c.ladder.stiffnesses = numbers("--stiffness", o_.stiffnesses, 1e-6, 1e6);
    c.target = reading_.number("--target", o_.target, c.target, Dimension::ratio, above_zero, 1.0);
    c.budget = reading_.number("--budget", o_.budget, c.budget, Dimension::time, above_zero, 1e9);
    c.members = static_cast<std::size_t>(reading_.number(
        "--ensemble", o_.members, static_cast<double>(c.members), Dimension::count, 0.0, 1000.0));
    c.bodies = o_.bodies;
    reading_.attempt("--measure",
                     [&] { c.measure = o_.measure.empty() ? c.measure : measure_from(o_.measure); });
    reading_.finish();
    return c;
  }

 private:
  std::vector<std::string> integrators() {
    for (const std::string& name : o_.integrators)
      reading_.attempt("--integrators", [&] { engine::make_integrator(name); });
    return o_.integrators;
  }

  std::vector<double> numbers(const std::string& option, const std::vector<std::string>& texts, double least,
                              double most) {
    std::vector<double> values;
    for (const std::string& text : texts)
      values.push_back(reading_.number(option, text, 1.0, Dimension::ratio, least, most));
    return values;
  }

  const TradeoffOptions& o_;
  OptionReading reading_;
};

SceneDescription description_of(const TradeoffOptions& options) {
  std::vector<Override> overrides;
  for (const std::string& text : options.set) overrides.push_back(parse_override(text));
  return load_scene(options.file, overrides);
}

void print(const std::vector<ToneLine>& lines, const Terminal& terminal) {
  for (const ToneLine& line : lines) terminal.line(line.text, line.tone);
}

void print_keys(const Tradeoff& tradeoff, const SceneDescription& description, const fs::path& records,
                const Terminal& terminal) {
  const auto best = tradeoff.recommended();
  if (!best || *best == tradeoff.own) return;
  terminal.line("In the scene file:");
  const engine::Scene scene = check_scene(description, records).scene;
  for (const std::string& line : keys_of(tradeoff.trials[*best].way, description, scene))
    terminal.line("  " + line);
}

Tradeoff run_aloud(const SceneDescription& description, const TradeoffChoice& choice, Interrupts& interrupts,
                   Terminal& terminal) {
  interrupts.run_begins();
  Tradeoff tradeoff =
      run_tradeoff(description, records_directory(), choice, [&](const TradeoffProgress& progress) {
        terminal.progress(progress);
        return !interrupts.asked();
      });
  terminal.end_progress();
  return tradeoff;
}

}  // namespace

int tradeoff_command(const TradeoffOptions& options) {
  const TradeoffChoice choice = Reading(options).choice();
  const SceneDescription description = description_of(options);
  const OutputFolder folder(
      options.out.empty() ? fs::path(options.file).stem().string() + "-tradeoff" : options.out,
      options.force);
  Interrupts interrupts(folder.made());
  Terminal terminal(stdout);
  try {
    const Tradeoff tradeoff = run_aloud(description, choice, interrupts, terminal);
    print(tradeoff_basis_text(tradeoff), terminal);
    print(tradeoff_table(tradeoff), terminal);
    print(tradeoff_answer_text(tradeoff), terminal);
    print_keys(tradeoff, description, records_directory(), terminal);
    const std::vector<std::string> files = write_tradeoff(tradeoff, description, folder.path());
    terminal.line(row("files", fmt::format("{} in {}", fmt::join(files, ", "), folder.path().string())));
    return tradeoff.interrupted ? exit_undecided : exit_survived;
  } catch (const NoReference& trouble) {
    terminal.end_progress();
    terminal.line(trouble.what(), Tone::bad);
    return interrupts.asked() ? exit_undecided : exit_numerically_invalid;
  }
}

}  // namespace dougong::app
