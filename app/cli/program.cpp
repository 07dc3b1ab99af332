#include "app/cli/program.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/report/gnuplot.h"
#include "app/report/safe_file.h"
#include "app/study/prepare.h"
#include "app/study/version.h"

namespace dougong::app {
namespace {

std::string quoted(const std::string& word) {
  if (!word.empty() && word.find_first_of(" \t\n'\"\\$*?;&|<>()[]{}") == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

std::string command_text(int argc, const char* const* argv) {
  std::string text = "dougong";
  for (int i = 1; i < argc; ++i) text += " " + quoted(argv[i]);
  return text;
}

// Options of all commands, and the one that was asked for.
struct Request {
  RunOptions run;
  LayoutShowOptions layout;
  RecordInfoOptions record;
  ReportOptions report;
  std::function<int()> command;
};

void add_run(CLI::App& app, Request& r) {
  CLI::App* run = app.add_subcommand("run", "Shake a building by a record and report what happened");
  run->add_option("scenario", r.run.scenario, "Scenario file (TOML); flags and --set override it");
  run->add_option("--layout", r.run.layout, "Building: a name from `dougong layouts`");
  run->add_option("--record", r.run.record, "Ground motion: a file, or a name from `dougong records`");
  run->add_option("--component", r.run.component, "Component that drives the horizontal axis: EW, NS, 180 ...");
  run->add_option("--pga", r.run.pga, "Peak ground acceleration to scale to, with its unit: \"0.4 g\"");
  run->add_option("--set", r.run.set, "key=value of the scenario or the layout (docs/scenario.md)")->take_all();
  run->add_option("--out", r.run.out, "Folder for the results (dougong-out)");
  run->add_flag("--force", r.run.force, "Write into a folder that already holds something");
  run->add_flag("--json", r.run.json, "Print summary.json on standard output and nothing else there");
  run->footer("Exit codes: 0 survived, 10 collapsed, 20 numerically invalid, 30 undecided, 2 bad input.\n"
              "Example: dougong run --layout four-storey --set left_column_width=\"0.6 m\" --record wenchuan "
              "--pga \"0.4 g\" --out out/strong");
  run->callback([&r] { r.command = [&r] { return run_command(r.run); }; });
}

void add_layouts(CLI::App& app, Request& r) {
  CLI::App* list = app.add_subcommand("layouts", "List the buildings there are");
  list->footer("Example: dougong layouts");
  list->callback([&r] { r.command = layouts_command; });
  CLI::App* layout = app.add_subcommand("layout", "One building: its parameters and a picture");
  layout->require_subcommand(1);
  layout->footer("Example: dougong layout show brick-wall");
  CLI::App* show = layout->add_subcommand("show", "Parameters with defaults and units, and a picture");
  show->add_option("name", r.layout.name, "Name of the layout")->required();
  show->add_option("--set", r.layout.set, "parameter=value")->take_all();
  show->add_option("--picture", r.layout.picture, "PNG or SVG file to draw (NAME.png)");
  show->add_flag("--force", r.layout.force, "Write over an existing picture");
  show->footer("Example: dougong layout show brick-wall --set courses=20 --picture wall.svg");
  show->callback([&r] { r.command = [&r] { return layout_show_command(r.layout); }; });
}

void add_records(CLI::App& app, Request& r) {
  CLI::App* list = app.add_subcommand("records", "List the shipped ground motions");
  list->footer("Example: dougong records");
  list->callback([&r] { r.command = records_command; });
  CLI::App* record = app.add_subcommand("record", "One ground motion");
  record->require_subcommand(1);
  record->footer("Example: dougong record info station.AT2");
  CLI::App* info = record->add_subcommand("info", "What a file holds, and its measures");
  info->add_option("file", r.record.record, "A file, or a name from `dougong records`")->required();
  info->add_option("--component", r.record.component, "Component to choose");
  info->add_option("--units", r.record.units, "Units of a file that does not say: g, gal, m/s2 ...");
  info->add_option("--interval", r.record.interval, "Time between samples, for a file that does not say: \"0.01 s\"");
  info->add_option("--count-scale", r.record.count_scale, "gal per count: 3920/6182761");
  info->add_flag("--json", r.record.json, "As JSON");
  info->footer("Example: dougong record info station.csv --units gal --interval \"0.01 s\" --json");
  info->callback([&r] { r.command = [&r] { return record_info_command(r.record); }; });
}

void add_report(CLI::App& app, Request& r) {
  CLI::App* report = app.add_subcommand("report", "Draw the report of a run again, from its results.h5");
  report->add_option("directory", r.report.directory, "Folder of the run")->required();
  report->footer("Example: dougong report out/strong");
  report->callback([&r] { r.command = [&r] { return report_command(r.report); }; });
}

void describe_program(CLI::App& app, Request& r) {
  app.set_version_flag("--version", fmt::format("dougong {} ({}, {})", program_version(), program_git_hash(),
                                                program_compiler()));
  app.require_subcommand(1);
  app.footer("Example: dougong run --layout four-storey --record wenchuan --pga \"0.3 g\"");
  add_run(app, r);
  add_layouts(app, r);
  add_records(app, r);
  add_report(app, r);
}

int report_error(const std::string& text) {
  fmt::print(stderr, "dougong: {}\n", text);
  return exit_bad_input;
}

}  // namespace

int run_program(int argc, const char* const* argv) {
  CLI::App app{"Dougong: how far does a building of blocks drift on a real ground motion, and does it collapse?",
               "dougong"};
  Request request;
  request.run.command = command_text(argc, argv);
  describe_program(app, request);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? exit_survived : exit_bad_input;
  }
  try {
    return request.command();
  } catch (const ModelError& error) {
    return report_error(fmt::format("the model cannot be run:\n{}", error.what()));
  } catch (const std::exception& error) {
    return report_error(error.what());
  }
}

}  // namespace dougong::app
