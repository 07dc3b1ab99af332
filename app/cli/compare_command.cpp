#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "app/cli/commands.h"
#include "app/cli/compare_store.h"
#include "app/cli/compare_text.h"
#include "app/cli/interrupts.h"
#include "app/cli/output_folder.h"
#include "app/cli/pdf_aloud.h"
#include "app/cli/record_choice.h"
#include "app/report/comparison_report.h"
#include "app/report/gnuplot.h"
#include "app/report/results_file.h"
#include "app/report/safe_file.h"

namespace dougong::app {
namespace {

namespace fs = std::filesystem;

// The folder of a comparison has it: the same command may go on there.
constexpr const char* mark = "command.txt";

ComparisonChoice choice_of(const CompareOptions& options) {
  ComparisonChoice choice;
  choice.scenario = options.scenario;
  const auto add = [&](const char* key, const std::string& value, const char* flag) {
    if (!value.empty()) choice.overrides.push_back({key, value, flag});
  };
  add("layout.name", options.layout, "--layout");
  add("record.pga", options.pga, "--pga");
  add("ensemble.n", options.ensemble, "--ensemble");
  for (const std::string& text : options.set) choice.overrides.push_back(parse_override(text));
  for (const std::string& record : options.records) choice.records.push_back(record_override(record));
  for (const std::string& text : options.vary)
    choice.variants = crossed(choice.variants, variants_of_key(text));
  return choice;
}

bool wants_same_sa(const CompareOptions& options, const std::vector<VariantSheet>& variants) {
  return options.same_sa == "yes" || (options.same_sa == "auto" && periods_differ(variants));
}

std::size_t jobs_of(const CompareOptions& options) {
  return options.jobs > 0 ? options.jobs : std::max(1u, std::thread::hardware_concurrency());
}

fs::path folder_of(const CompareOptions& options) {
  if (!options.out.empty()) return options.out;
  return options.scenario.empty() ? "dougong-compare"
                                  : fs::path(options.scenario).stem().string() + "-compare";
}

ComparisonCost cost_of(const std::vector<Case>& cases, const std::vector<VariantSheet>& variants,
                       const RunStore& store) {
  ComparisonCost cost;
  cost.cases = cases.size();
  for (const Case& one : cases) {
    if (store.has(one)) {
      ++cost.kept;
      continue;
    }
    const std::size_t runs = runs_of(one.scenario);
    cost.runs += runs;
    if (one.view == View::same_sa) cost.runs_of_same_sa += runs;
    cost.seconds += static_cast<double>(runs) * variants[one.variant].estimated_seconds;
  }
  return cost;
}

void print(const std::vector<ToneLine>& lines, const Terminal& terminal) {
  for (const ToneLine& line : lines) terminal.line(line.text, line.tone);
}

// Everything up to the first run.
struct Prepared {
  Comparison comparison;
  std::vector<Case> cases;
};

Prepared prepare_aloud(const CompareOptions& options, const Terminal& terminal) {
  const ComparisonPlan plan = plan_comparison(choice_of(options));
  terminal.line(fmt::format("Preparing {} variants ...", plan.variants.size()), Tone::faint);
  Prepared prepared{{look_at_variants(plan, records_directory()), plan.records, {View::same_motion}, {}},
                    plan.cases};
  print(variants_text(prepared.comparison.variants), terminal);
  if (!wants_same_sa(options, prepared.comparison.variants)) return prepared;
  const auto scaled = cases_of_same_sa(plan, prepared.comparison.variants, records_directory());
  if (!scaled.empty()) prepared.comparison.views.push_back(View::same_sa);
  prepared.cases.insert(prepared.cases.end(), scaled.begin(), scaled.end());
  return prepared;
}

void run_aloud(Prepared& prepared, const CompareOptions& options, const RunStore& store,
               Interrupts& interrupts, Terminal& terminal) {
  interrupts.run_begins();
  run_cases(prepared.comparison, prepared.cases, records_directory(), jobs_of(options), options.command,
            store, [&](const EnsembleProgress& progress) {
              terminal.progress(progress);
              return !interrupts.asked();
            });
  terminal.end_progress();
}

}  // namespace

int compare_command(const CompareOptions& options) {
  Terminal terminal(stdout);
  Prepared prepared = prepare_aloud(options, terminal);
  require_gnuplot();
  const fs::path path = folder_of(options);
  const OutputFolder folder(path, options.force || fs::exists(path / mark));
  Interrupts interrupts(folder.made());
  const RunStore store = store_in(path, records_directory(), options.force);
  print(cost_text(cost_of(prepared.cases, prepared.comparison.variants, store), jobs_of(options)), terminal);
  write_file(path / mark, options.command + "\n");
  run_aloud(prepared, options, store, interrupts, terminal);
  if (prepared.comparison.interrupted) {
    terminal.line("Interrupted: what is complete is kept, and the same command goes on from there.",
                  Tone::doubtful);
    return exit_undecided;
  }
  const Comparison& comparison = prepared.comparison;
  print(comparison_tables(comparison, differences_of(comparison), collapses_of(comparison)), terminal);
  const auto files = write_comparison(
      comparison, [&](const ComparedRun& run) { return read_results(path / run.folder / "results.h5"); },
      path);
  terminal.line(row("report", (path / files.front()).string()));
  terminal.line(row("files", fmt::format("{} and the runs in {}", files.size(), path.string())));
  pdf_aloud(path / files.front(), options.pdf, terminal);
  return exit_survived;
}

}  // namespace dougong::app
