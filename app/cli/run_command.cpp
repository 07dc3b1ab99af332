#include <fmt/format.h>

#include <thread>

#include "app/cli/commands.h"
#include "app/cli/film_aloud.h"
#include "app/cli/interrupts.h"
#include "app/cli/output_folder.h"
#include "app/cli/pdf_aloud.h"
#include "app/cli/record_choice.h"
#include "app/cli/run_text.h"
#include "app/cli/terminal.h"
#include "app/report/gnuplot.h"
#include "app/report/report.h"
#include "app/report/results_file.h"
#include "app/report/safe_file.h"
#include "app/report/summary.h"
#include "app/study/ensemble.h"

namespace dougong::app {
namespace {

namespace fs = std::filesystem;

std::vector<Override> overrides_of(const RunOptions& options) {
  std::vector<Override> overrides;
  const auto add = [&](const char* key, const std::string& value, const char* flag) {
    if (!value.empty()) overrides.push_back({key, value, flag});
  };
  add("layout.name", options.layout, "--layout");
  if (!options.record.empty()) overrides.push_back(record_override(options.record));
  add("record.component", options.component, "--component");
  add("record.pga", options.pga, "--pga");
  add("ensemble.n", options.ensemble, "--ensemble");
  add("screening.codes", options.codes, "--codes");
  add("output.directory", options.out, "--out");
  for (const std::string& text : options.set) overrides.push_back(parse_override(text));
  return overrides;
}

// "--pga 0.4 g" without quotes leaves a "g" that is taken for the scenario.
void refuse_stray_word(const std::string& word) {
  std::error_code error;
  if (word.empty() || fs::exists(word, error) || word.find_first_of("./") != std::string::npos) return;
  throw FileError(word, "read the scenario",
                  "no such file; a value and its unit are one argument, in quotes: --pga \"0.4 g\"");
}

Scenario scenario_of(const RunOptions& options) {
  const auto overrides = overrides_of(options);
  refuse_stray_word(options.scenario);
  return options.scenario.empty() ? scenario_from(overrides) : load_scenario(options.scenario, overrides);
}

Preparation prepare_aloud(const Scenario& scenario, const Terminal& terminal) {
  terminal.line(fmt::format("Preparing {} ...", scenario.layout.name), Tone::faint);
  Preparation preparation = prepare(scenario, records_directory());
  for (const std::string& text : preparation_text(preparation)) terminal.line(text);
  return preparation;
}

// A report of an earlier run must not stand beside other results.
void save(const RunResult& result, const fs::path& directory) {
  std::error_code ignored;
  for (const char* name : {"report.html", "report.pdf", "summary.json"})
    fs::remove(directory / name, ignored);
  write_results(result, directory / "results.h5");
}

// What there is of a long run is saved now and then: a run that is killed leaves it behind.
RunResult shake(Preparation& preparation, const std::string& command, const fs::path& directory,
                Interrupts& interrupts, Terminal& terminal) {
  interrupts.run_begins();
  RunResult result = execute(
      preparation, command,
      [&](const Progress& progress) {
        terminal.progress(progress);
        return !interrupts.asked();
      },
      [&](const RunResult& so_far) { save(so_far, directory); });
  terminal.end_progress();
  return result;
}

std::size_t jobs_of(const RunOptions& options) {
  return options.jobs > 0 ? options.jobs : std::max(1u, std::thread::hardware_concurrency());
}

std::string repetition_text(const EnsembleChoice& ensemble) {
  if (ensemble.n >= 2) return fmt::format("Running {} more times with small changes ...", ensemble.n - 1);
  return "Running once more with half the step (--set ensemble.half_step=false leaves it out) ...";
}

// The other members of the ensemble and the half step, unless the run itself was interrupted. What has been
// computed is saved before they begin.
void repeat(const Preparation& preparation, std::size_t jobs, const fs::path& directory,
            Interrupts& interrupts, Terminal& terminal, RunResult& result) {
  if (runs_of(preparation.scenario) < 2 || result.partial) return;
  save(result, directory);
  terminal.line(repetition_text(preparation.scenario.ensemble), Tone::faint);
  result.ensemble = run_ensemble(preparation, result, jobs, [&](const EnsembleProgress& progress) {
    terminal.progress(progress);
    return !interrupts.asked();
  });
  terminal.end_progress();
}

// The report is drawn from what the file holds.
RunResult save_and_reload(const RunResult& result, const fs::path& directory) {
  save(result, directory);
  return read_results(directory / "results.h5");
}

// Whatever keeps the report from being drawn, the answer is saved for programs too.
void save_summary_alone(const RunResult& result, const fs::path& directory) {
  try {
    write_file(directory / "summary.json", summary_json(result, {"summary.json"}));
  } catch (const std::exception&) {
    // The reason that is told is the first one.
  }
}

std::size_t draw_report(const RunResult& result, const fs::path& directory) {
  try {
    return write_report(result, directory).size();
  } catch (const std::exception& error) {
    save_summary_alone(result, directory);
    throw std::runtime_error(
        fmt::format("{}\nThe run is saved in {}; draw its report with: dougong report {}", error.what(),
                    (directory / "results.h5").string(), directory.string()));
  }
}

void print_json(const std::string& text) {
  if (std::fputs((text + "\n").c_str(), stdout) < 0 || std::fflush(stdout) != 0)
    throw std::runtime_error("cannot write to standard output; the same is in summary.json");
}

void say(const std::vector<ToneLine>& lines, const Terminal& terminal) {
  for (const ToneLine& line : lines) terminal.line(line.text, line.tone);
}

// One run has its answer before its half step is known.
void answer_and_repeat(const Preparation& preparation, std::size_t jobs, const fs::path& directory,
                       Interrupts& interrupts, Terminal& terminal, RunResult& result) {
  const bool once = preparation.scenario.ensemble.n < 2;
  if (once) say(answer_text(result), terminal);
  repeat(preparation, jobs, directory, interrupts, terminal, result);
  say(once ? half_step_line(result) : answer_text(result), terminal);
}

void say_files(const fs::path& directory, std::size_t files, const Terminal& terminal) {
  for (const std::string& text : files_text(directory, files)) terminal.line(text);
}

int exit_code_of(structures::VerdictKind kind) {
  switch (kind) {
    case structures::VerdictKind::survived:
      return exit_survived;
    case structures::VerdictKind::collapsed:
      return exit_collapsed;
    case structures::VerdictKind::numerically_invalid:
      return exit_numerically_invalid;
    case structures::VerdictKind::undecided:
      return exit_undecided;
  }
  return exit_undecided;
}

}  // namespace

int run_command(const RunOptions& options) {
  Terminal terminal(options.json ? stderr : stdout);
  const Scenario scenario = scenario_of(options);
  require_gnuplot();
  require_film_path(options.film, options.force);
  const OutputFolder folder(scenario.output.directory, options.force);
  Interrupts interrupts(folder.made());
  Preparation preparation = prepare_aloud(scenario, terminal);
  RunResult computed = shake(preparation, options.command, folder.path(), interrupts, terminal);
  answer_and_repeat(preparation, jobs_of(options), folder.path(), interrupts, terminal, computed);
  const RunResult result = save_and_reload(computed, folder.path());
  say_files(folder.path(), draw_report(result, folder.path()) + 1, terminal);
  pdf_aloud(folder.path() / "report.html", options.pdf, terminal);
  film_aloud(result, options.film, terminal);
  if (options.json) print_json(read_file(folder.path() / "summary.json"));
  return exit_code_of(result.verdict.kind);
}

int report_command(const ReportOptions& options) {
  const fs::path directory = options.directory;
  require_film_path(options.film, options.force);
  const RunResult result = read_results(directory / "results.h5");
  const Terminal terminal(stdout);
  say(answer_text(result), terminal);
  say(half_step_line(result), terminal);
  say_files(directory, draw_report(result, directory) + 1, terminal);
  pdf_aloud(directory / "report.html", options.pdf, terminal);
  film_aloud(result, options.film, terminal);
  return exit_survived;
}

}  // namespace dougong::app
