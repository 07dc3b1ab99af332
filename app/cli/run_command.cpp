#include <fmt/format.h>

#include <atomic>
#include <csignal>

#include "app/cli/commands.h"
#include "app/cli/record_choice.h"
#include "app/cli/run_text.h"
#include "app/cli/terminal.h"
#include "app/report/report.h"
#include "app/report/results_file.h"
#include "app/report/safe_file.h"
#include "app/study/execute.h"

namespace dougong::app {
namespace {

std::atomic<bool> interrupted = false;

void on_interrupt(int) { interrupted = true; }

// The first Ctrl-C ends the run with a valid partial result; a second one ends the program.
class InterruptGuard {
 public:
  InterruptGuard() {
    interrupted = false;
    struct sigaction action = {};
    action.sa_handler = on_interrupt;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &action, &previous_);
  }
  ~InterruptGuard() { sigaction(SIGINT, &previous_, nullptr); }
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

 private:
  struct sigaction previous_ = {};
};

std::vector<Override> overrides_of(const RunOptions& options) {
  std::vector<Override> overrides;
  const auto add = [&](const char* key, const std::string& value, const char* flag) {
    if (!value.empty()) overrides.push_back({key, value, flag});
  };
  add("layout.name", options.layout, "--layout");
  if (!options.record.empty()) overrides.push_back(record_override(options.record));
  add("record.component", options.component, "--component");
  add("record.pga", options.pga, "--pga");
  add("output.directory", options.out, "--out");
  for (const std::string& text : options.set) overrides.push_back(parse_override(text));
  return overrides;
}

Scenario scenario_of(const RunOptions& options) {
  const auto overrides = overrides_of(options);
  return options.scenario.empty() ? scenario_from(overrides) : load_scenario(options.scenario, overrides);
}

// Nothing is written over: an existing folder with anything in it needs --force.
void claim_directory(const std::filesystem::path& directory, bool force) {
  std::error_code error;
  if (std::filesystem::exists(directory, error) && !std::filesystem::is_directory(directory, error))
    throw FileError(directory, "write the results to", "it is a file, not a folder");
  if (!force && std::filesystem::exists(directory, error) && !std::filesystem::is_empty(directory, error))
    throw FileError(directory, "write the results to", "the folder exists and is not empty; give --force or another --out");
  make_directory(directory);
}

RunResult save_and_reload(const RunResult& result, const std::filesystem::path& directory) {
  const auto path = directory / "results.h5";
  write_results(result, path);
  return read_results(path);
}

int exit_code_of(structures::VerdictKind kind) {
  switch (kind) {
    case structures::VerdictKind::survived: return exit_survived;
    case structures::VerdictKind::collapsed: return exit_collapsed;
    case structures::VerdictKind::numerically_invalid: return exit_numerically_invalid;
    case structures::VerdictKind::undecided: return exit_undecided;
  }
  return exit_undecided;
}

}  // namespace

int run_command(const RunOptions& options) {
  Terminal terminal(options.json ? stderr : stdout);
  const Scenario scenario = scenario_of(options);
  const std::filesystem::path directory = scenario.output.directory;
  claim_directory(directory, options.force);

  terminal.line(fmt::format("Preparing {} ...", scenario.layout.name), Tone::faint);
  Preparation preparation = prepare(scenario, records_directory());
  for (const std::string& text : preparation_text(preparation)) terminal.line(text);

  const InterruptGuard guard;
  const RunResult computed = execute(preparation, options.command, [&](const Progress& progress) {
    terminal.progress(progress);
    return !interrupted;
  });
  terminal.end_progress();

  terminal.line("Drawing the report ...", Tone::faint);
  const RunResult result = save_and_reload(computed, directory);
  const auto files = write_report(result, directory);
  for (const ToneLine& line : verdict_text(result, directory, files.size() + 1)) terminal.line(line.text, line.tone);
  if (options.json) fmt::print(stdout, "{}\n", read_file(directory / "summary.json"));
  return exit_code_of(result.verdict.kind);
}

int report_command(const ReportOptions& options) {
  const std::filesystem::path directory = options.directory;
  const RunResult result = read_results(directory / "results.h5");
  const auto files = write_report(result, directory);
  const Terminal terminal(stdout);
  for (const ToneLine& line : verdict_text(result, directory, files.size() + 1)) terminal.line(line.text, line.tone);
  return exit_survived;
}

}  // namespace dougong::app
