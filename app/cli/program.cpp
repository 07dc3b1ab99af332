#include "app/cli/program.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/record_tools.h"
#include "app/report/block_colour.h"
#include "app/study/prepare.h"
#include "app/study/version.h"
#include "seismic/input_error.h"
#include "structures/nearest_name.h"

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
  CompareOptions compare;
  StaticsOptions tilt, pushover;
  LayoutsOptions layouts;
  LayoutOptions layout;
  ImportOptions import;
  RecordListOptions records;
  RecordInfoOptions record;
  RecordConvertOptions convert;
  ReportOptions report;
  SceneOptions scene;
  TradeoffOptions tradeoff;
  DescribeOptions describe;
  SpaceOptions space;
  std::function<int()> command;
};

void add_film(CLI::App& command, FilmChoice& film) {
  CLI::Option* path = command.add_option(
      "--film", film.path, "A film of the run, FILE.mp4; without ffmpeg its frames in the folder FILE");
  command.add_option("--slow", film.slow, "How many times slower than the run the film goes (1)")
      ->needs(path)
      ->check(CLI::Range(0.1, 1000.0));
  command.add_option("--colour", film.colour, "What the film's colours tell (displacement)")
      ->needs(path)
      ->check(CLI::IsMember(block_colours()));
}

void add_pdf(CLI::App& command, bool& pdf) {
  command.add_flag("--pdf", pdf, "The page as PDF too, where chromium or weasyprint is installed");
}

void add_run(CLI::App& app, Request& r) {
  CLI::App* run = app.add_subcommand("run", "Shake a building by a record and report what happened");
  run->add_option("scenario", r.run.scenario, "Scenario file (TOML); flags and --set override it");
  run->add_option("--layout", r.run.layout, "Building: a name from `dougong layouts`");
  run->add_option("--record", r.run.record, "Ground motion: a file, or a name from `dougong records`");
  run->add_option("--component", r.run.component,
                  "Component that drives the horizontal axis: EW, NS, 180 ...");
  run->add_option("--pga", r.run.pga, "Peak ground acceleration to scale to, with its unit: \"0.4 g\"");
  run->add_option("--set", r.run.set, "key=value of the scenario or the layout (docs/scenario.md)")
      ->take_all()
      ->allow_extra_args(false);
  run->add_option("--ensemble", r.run.ensemble,
                  "Runs in all, the others with small changes: how sure the answer is (1)");
  run->add_option("--codes", r.run.codes,
                  "Standards whose drift limits are looked at: gb50011,fema356 or none (those that fit)");
  run->add_option("-j,--jobs", r.run.jobs, "Runs at a time (one a processor)")->check(CLI::Range(1, 1024));
  add_film(*run, r.run.film);
  add_pdf(*run, r.run.pdf);
  run->add_option("--out", r.run.out, "Folder for the results (dougong-out)");
  run->add_flag("--force", r.run.force, "Write into a folder that already holds something");
  run->add_flag("--json", r.run.json, "Print summary.json on standard output and nothing else there");
  run->footer(
      "Exit codes: 0 survived, 10 collapsed, 20 numerically invalid, 30 undecided, 2 bad input.\n"
      "Example: dougong run --layout four-storey --set left_column_width=\"0.6 m\" --record wenchuan "
      "--pga \"0.4 g\" --out out/strong");
  run->callback([&r] { r.command = [&r] { return run_command(r.run); }; });
}

void add_compare(CLI::App& app, Request& r) {
  CLI::App* compare = app.add_subcommand("compare", "Variants of a building on the same motions, in pairs");
  CompareOptions& o = r.compare;
  compare->add_option("scenario", o.scenario, "Scenario file (TOML), with or without tables [[variant]]");
  const auto add_many = [&](const char* name, std::vector<std::string>& values, const char* meaning) {
    compare->add_option(name, values, meaning)->take_all()->allow_extra_args(false);
  };
  add_many("--vary", o.vary,
           "\"key = value, value ...\": the first is the reference; several are combined, each with each");
  add_many("--record", o.records, "Ground motion: a file or a name, once for each (that of the scenario)");
  compare->add_option("--layout", o.layout, "Building of all variants: a name from `dougong layouts`");
  compare->add_option("--pga", o.pga, "Peak ground acceleration to scale every record to: \"0.4 g\"");
  add_many("--set", o.set, "key=value of all variants (docs/scenario.md)");
  compare->add_option("--ensemble", o.ensemble,
                      "Runs of each variant on each record, all but one with small changes (1)");
  compare
      ->add_option("--same-sa", o.same_sa,
                   "Also with records scaled to the same Sa(T1, 5 %): auto, where periods differ by 5 %")
      ->check(CLI::IsMember({"auto", "yes", "no"}));
  compare->add_option("-j,--jobs", o.jobs, "Runs at a time (one a processor)")->check(CLI::Range(1, 1024));
  add_pdf(*compare, o.pdf);
  compare->add_option("--out", o.out, "Folder for the results (SCENARIO-compare)");
  compare->add_flag("--force", o.force, "Write into a folder that already holds something else");
  compare->footer(
      "Writes compare.html, compare.csv, differences.csv, figures/ and a folder for every run. The same\n"
      "command again keeps the runs that are complete. How the intervals are made: docs/compare.md.\n"
      "Exit codes: 0 done, 30 interrupted, 2 bad input.\n"
      "Example: dougong compare --layout four-storey --vary \"left_column_width = 0.3, 0.6 m\" --record "
      "wenchuan --pga \"0.3 g\" --ensemble 16 --out out/columns");
  compare->callback([&r] { r.command = [&r] { return compare_command(r.compare); }; });
}

void add_statics_options(CLI::App& command, StaticsOptions& o) {
  command.add_option("scenario", o.scenario, "Scenario file (TOML); its motion is not looked at");
  command.add_option("--layout", o.layout, "Building: a name from `dougong layouts`");
  command.add_option("--set", o.set, "key=value of the scenario or the layout (docs/scenario.md)")
      ->take_all()
      ->allow_extra_args(false);
  command.add_option("--towards", o.towards, "left, right or both")
      ->check(CLI::IsMember({"left", "right", "both"}));
  command.add_option("--precision", o.precision, "Width of the bracket over its upper end (0.005)");
  command.add_option("--step", o.step, "Of the multiplier, while all trials stand (0.1)");
  command.add_option("--largest", o.largest, "Multiplier at which the search ends (2)");
  command.add_option("--hold", o.hold, "What stands at the end is watched at rest for so long (\"5 s\")");
  command.add_option("--out", o.out, "Folder for the results (LAYOUT-tilt, LAYOUT-pushover)");
  command.add_flag("--force", o.force, "Write into a folder that already holds something");
}

constexpr const char* statics_codes =
    "Exit codes: 0 bracketed, 10 it does not stand under its weight, 20 numerically invalid,\n"
    "30 undecided or interrupted, 2 bad input.\n";

void add_statics(CLI::App& app, Request& r) {
  CLI::App* tilt = app.add_subcommand("tilt", "Tilt a building until it does not stand: collapse multiplier");
  add_statics_options(*tilt, r.tilt);
  tilt->footer(std::string(statics_codes) +
               "Example: dougong tilt --layout brick-wall --towards right --out out/tilt");
  tilt->callback([&r] { r.command = [&r] { return statics_command(r.tilt); }; });
  CLI::App* push = app.add_subcommand(
      "pushover", "Push a building by growing forces: collapse multiplier, capacity curve");
  add_statics_options(*push, r.pushover);
  push->add_option("--pattern", r.pushover.pattern, "Of the forces: mass, triangular or first-mode (mass)")
      ->check(CLI::IsMember({"mass", "triangular", "first-mode"}));
  push->add_option("--to", r.pushover.target, "Roof drift u/H at which the capacity curve ends (5 %)");
  push->footer(std::string(statics_codes) +
               "Example: dougong pushover --layout brick-wall --pattern triangular --out out/push");
  push->callback([&r] {
    r.pushover.pushover = true;
    r.command = [&r] { return statics_command(r.pushover); };
  });
}

CLI::App* add_layout(CLI::App& parent, Request& r, const char* name, const char* meaning,
                     int (*command)(const LayoutOptions&), const std::string& example) {
  CLI::App* sub = parent.add_subcommand(name, meaning);
  sub->add_option("name", r.layout.name, "Name of the layout, or a scene file that lists its storeys")
      ->required();
  sub->add_option("values", r.layout.set, "parameter=value of the layout, key=value of [on] and [beside]");
  sub->add_option("--set", r.layout.set, "parameter=value")->take_all()->allow_extra_args(false);
  sub->add_option("--out,--picture", r.layout.out, "File to write");
  sub->add_flag("--force", r.layout.force, "Write over an existing file");
  sub->footer("Example: " + example);
  sub->callback([&r, command] { r.command = [&r, command] { return command(r.layout); }; });
  return sub;
}

void add_layout_import(CLI::App& parent, Request& r) {
  CLI::App* sub = parent.add_subcommand("import", "Make a building by hand of outlines in a DXF or CSV file");
  sub->add_option("file", r.import.file, "DXF with closed polylines, or CSV with a row a corner")->required();
  sub->add_option("--out", r.import.out, "Scene file to write (.toml)")->required();
  sub->add_option("--units", r.import.units, "Unit of a DXF file's lengths: m, cm or mm")
      ->check(CLI::IsMember({"m", "cm", "mm"}));
  sub->add_option("--material", r.import.material, "Preset of blocks and ground (docs/scene.md)");
  sub->add_flag("--force", r.import.force, "Write over an existing file");
  sub->footer("Example: dougong layout import wall.dxf --units mm --material brick --out wall.toml");
  sub->callback([&r] { r.command = [&r] { return layout_import_command(r.import); }; });
}

void add_layouts(CLI::App& app, Request& r) {
  CLI::App* list = app.add_subcommand("layouts", "List the buildings there are");
  list->add_option("--page", r.layouts.page, "Page with the drawings and parameters of all: FILE.html");
  list->add_flag("--force", r.layouts.force, "Write over an existing file");
  list->footer("Example: dougong layouts --page layouts.html");
  list->callback([&r] { r.command = [&r] { return layouts_command(r.layouts); }; });
  CLI::App* layout = app.add_subcommand("layout", "One building: its parameters, picture, check and export");
  layout->require_subcommand(1);
  layout->footer("Example: dougong layout show brick-wall");
  add_layout(*layout, r, "show", "Parameters with defaults and units, and a picture", layout_show_command,
             "dougong layout show brick-wall courses=20 --picture wall.svg");
  add_layout(*layout, r, "draw", "A picture", layout_draw_command,
             "dougong layout draw concrete-frame infill=above-first --out frame.svg");
  add_layout(*layout, r, "check", "The model check, settling under gravity, and the period",
             layout_check_command, "dougong layout check masonry-house ties=every-floor");
  add_layout(*layout, r, "modes", "Periods, effective masses and shapes of small vibrations",
             layout_modes_command, "dougong layout modes concrete-frame storeys=5 --out out/modes")
      ->add_option("--count", r.layout.count, "Modes, from the lowest (6)")
      ->check(CLI::Range(1, 40));
  add_layout(*layout, r, "export", "Write it as a scene file, a drawing or a DXF file", layout_export_command,
             "dougong layout export pagoda storeys=7 --out pagoda.dxf");
  add_layout_import(*layout, r);
}

void add_record_choice(CLI::App& app, RecordInfoOptions& record) {
  app.add_option("file", record.record, "A file or archive, or a name from `dougong records`")->required();
  app.add_option("more", record.more, "Further files: the other components of the station");
  app.add_option("--component", record.component, "Component to choose, by name or direction: EW, 180, N08W");
  app.add_option("--station", record.station, "Station, of a file that holds several");
  app.add_option("--member", record.member, "File to read in an archive, by its name");
  app.add_option("--response", record.response, "StationXML with the sensitivity of miniSEED counts");
  app.add_option("--units", record.units, "Units of a file that does not say: g, gal, m/s2 ...");
  app.add_option("--interval", record.interval,
                 "Time between samples, for a file that does not say: \"0.01 s\"");
  app.add_option("--count-scale", record.count_scale, "gal per count: 3920/6182761");
}

void add_convert(CLI::App& record, Request& r) {
  CLI::App* convert = record.add_subcommand("convert", "Write a record in another format");
  add_record_choice(*convert, r.convert.from);
  convert->add_option("--to", r.convert.format, "at2, knet, csmnc, csv or miniseed")->required();
  convert->add_option("--out", r.convert.out, "Stem of the files to write: out/kobe gives out/kobe-EW.AT2");
  convert->add_option("--azimuth", r.convert.azimuth,
                      "Turn the horizontal pair to this direction, from north: \"45 deg\"");
  convert->add_option("--pga", r.convert.pga, "Scale the chosen component to this peak: \"0.4 g\"");
  convert->add_flag("--force", r.convert.force, "Write over existing files");
  convert->add_flag("--json", r.convert.from.json, "As JSON");
  convert->footer(
      "All components are written, or only the one that --component names.\n"
      "Example: dougong record convert station.V2 --to at2 --out out/station");
  convert->callback([&r] { r.command = [&r] { return record_convert_command(r.convert); }; });
}

void add_record_list(CLI::App& app, Request& r) {
  CLI::App* list = app.add_subcommand("records", "List the shipped ground motions, or those of a folder");
  RecordListOptions& o = r.records;
  list->add_option("folder", o.folder,
                   "Folder with recordings, below it too; without one the shipped motions");
  list->add_option("--periods", o.periods, "Of the spectral accelerations, 5 % (0.2 s,0.5 s,1 s,2 s)")
      ->delimiter(',');
  list->add_option("--near-period", o.near_period,
                   "First the motions whose mean period is nearest to this one: \"0.5 s\"");
  list->add_option("--sort", o.sort,
                   "name, pga, pgv, d5-95, dt, length, mean-period, psa (the first period)");
  list->add_option("--csv", o.csv, "Write the table as CSV");
  list->add_option("-j,--jobs", o.jobs, "Files at a time (one a processor)")->check(CLI::Range(1, 1024));
  list->add_flag("--json", o.json, "As JSON");
  list->add_flag("--force", o.force, "Write over an existing file");
  list->footer("Example: dougong records recordings --near-period \"0.5 s\" --csv recordings.csv");
  list->callback([&r] { r.command = [&r] { return records_command(r.records); }; });
}

void add_records(CLI::App& app, Request& r) {
  add_record_list(app, r);
  CLI::App* record = app.add_subcommand("record", "One ground motion");
  record->require_subcommand(1);
  record->footer("Example: dougong record info station.AT2");
  CLI::App* info = record->add_subcommand("info", "What a file holds, and its measures");
  add_record_choice(*info, r.record);
  info->add_flag("--json", r.record.json, "As JSON");
  info->add_option("--csv", r.record.csv, "File to write, a row a component");
  info->add_flag("--force", r.record.force, "Write over an existing file");
  info->footer("Example: dougong record info station.csv --units gal --interval \"0.01 s\" --json");
  info->callback([&r] { r.command = [&r] { return record_info_command(r.record); }; });
  add_record_tools(*record, r.command);
  add_convert(*record, r);
}

void add_report(CLI::App& app, Request& r) {
  CLI::App* report = app.add_subcommand("report", "Draw the report of a run again, from its results.h5");
  report->add_option("directory", r.report.directory, "Folder of the run")->required();
  add_film(*report, r.report.film);
  add_pdf(*report, r.report.pdf);
  report->add_flag("--force", r.report.force, "Write over a film that is there already");
  report->footer(
      "Example: dougong report out/strong\n         dougong report out/strong --film strong.mp4 --slow 4");
  report->callback([&r] { r.command = [&r] { return report_command(r.report); }; });
}

void add_set(CLI::App& app, std::vector<std::string>& set, const char* meaning) {
  app.add_option("--set", set, meaning)->take_all()->allow_extra_args(false);
}

CLI::App* add_scene_command(CLI::App& scene, Request& r, const char* name, const char* meaning,
                            int (*command)(const SceneOptions&)) {
  CLI::App* app = scene.add_subcommand(name, meaning);
  app->add_option("file", r.scene.file, "Scene file (TOML, docs/scene.md)")->required();
  add_set(*app, r.scene.set, "key=value of the scene: duration=\"5 s\", body.NAME.mass=\"2 t\"");
  app->callback([&r, command] { r.command = [&r, command] { return command(r.scene); }; });
  return app;
}

void add_scene(CLI::App& app, Request& r) {
  CLI::App* scene = app.add_subcommand("scene", "Free scenes: bodies, terrain, joints and fields of a file");
  scene->require_subcommand(1);
  scene->footer("Example: dougong scene run app/examples/pendulum.toml");
  add_scene_command(*scene, r, "check", "Say what is wrong with a scene file, or that nothing is",
                    scene_check_command)
      ->footer("Exit codes: 0 sound, 2 not.\nExample: dougong scene check pendulum.toml");
  CLI::App* run = add_scene_command(*scene, r, "run", "Run a scene and keep its motion", scene_run_command);
  run->add_option("--out", r.scene.out, "Folder for the results (dougong-out)");
  run->add_flag("--force", r.scene.force, "Write into a folder that already holds something");
  run->footer(
      "Writes results.h5, scene.toml, bodies.csv, energy.csv and pictures.\n"
      "Exit codes: 0 completed, 20 numerically invalid, 30 interrupted, 2 bad input.\n"
      "Example: dougong scene run pendulum.toml --set duration=\"5 s\" --out out/pendulum");
  CLI::App* draw =
      add_scene_command(*scene, r, "draw", "Draw a scene as its file describes it", scene_draw_command);
  draw->add_option("--out", r.scene.out, "PNG or SVG file to draw (FILE.png in the current folder)");
  draw->add_flag("--force", r.scene.force, "Write over an existing picture");
  draw->footer("Example: dougong scene draw pendulum.toml --out pendulum.svg");
}

void add_list(CLI::App& app, const char* name, std::vector<std::string>& values, const char* meaning) {
  app.add_option(name, values, meaning)->delimiter(',')->take_all()->allow_extra_args(false);
}

void add_tradeoff(CLI::App& app, Request& r) {
  CLI::App* command = app.add_subcommand(
      "tradeoff", "Error against cost of a scene: integrators, steps and contact stiffnesses");
  TradeoffOptions& o = r.tradeoff;
  command->add_option("file", o.file, "Scene file (TOML, docs/scene.md)")->required();
  add_set(*command, o.set, "key=value of the scene");
  command->add_option("--out", o.out, "Folder for the results (FILE-tradeoff)");
  command->add_flag("--force", o.force, "Write into a folder that already holds something");
  add_list(*command, "--integrators", o.integrators, "By name, with commas between (all that apply)");
  add_list(
      *command, "--steps", o.steps,
      "Parts of the stability bound (0.9,0.5,0.25,0.1; where nothing touches 0.5,0.2,0.1,0.05,0.02,0.01)");
  add_list(*command, "--tolerances", o.tolerances, "Of adaptive integrators (1e-4,1e-6,1e-8,1e-10)");
  add_list(*command, "--stiffness", o.stiffnesses,
           "Factors on every Young's modulus beside 1 (0.1,1,10 where only contacts are elastic, else 1)");
  add_list(*command, "--body", o.bodies, "Bodies that are compared (all)");
  command->add_option("--measure", o.measure, "Of the distance of two runs: rms, largest, end (rms)");
  command->add_option("--target", o.target, "Error that is good enough (1 %)");
  command->add_option("--budget", o.budget, "Processor time of a run; a reference has ten times it (20 s)");
  command->add_option("--ensemble", o.members, "Runs that show how sensitive the motion is (8)");
  command->footer(
      "Writes tradeoff.csv, tradeoff.png, tradeoff.svg and scene.toml. What it measures, and what was found\n"
      "with it: docs/accuracy.md.\n"
      "Exit codes: 0 done, 20 no reference could be computed, 30 interrupted, 2 bad input.\n"
      "Example: dougong tradeoff app/examples/rocking-block.toml --out out/rocking");
  command->callback([&r] { r.command = [&r] { return tradeoff_command(r.tradeoff); }; });
}

void add_describe(CLI::App& app, Request& r) {
  CLI::App* describe =
      app.add_subcommand("describe", "What a scene or scenario would model, its step and its cost");
  describe->add_option("file", r.describe.file, "Scene file or scenario file (TOML)")->required();
  add_set(*describe, r.describe.set, "key=value of the file");
  describe->footer("Example: dougong describe pendulum.toml");
  describe->callback([&r] { r.command = [&r] { return describe_command(r.describe); }; });
}

void add_space(CLI::App& app, Request& r) {
  CLI::App* space = app.add_subcommand("space", "Enter a scene message by message, then run it");
  space->add_option("file", r.space.file, "Text with the messages; without one they are typed or piped in");
  space->add_flag("--earthquake", r.space.earthquake, "Shake the terrain: a record's name follows finish");
  space->add_option("--material", r.space.material,
                    "Of all bodies and terrain: concrete, brick, stone, timber, steel, rubber, glass, ptfe "
                    "(concrete with friction 0.5)");
  space->add_option("--duration", r.space.duration, "Simulated time (\"10 s\")");
  space->add_option("--out", r.space.out, "Folder for the results (dougong-out)");
  space->add_flag("--force", r.space.force,
                  "Write into a folder that already holds something, and over a saved scene");
  space->footer(
      "Messages, all values bare numbers in SI units:\n"
      "  cir      charge  velocity x y  spin  mass  centre x y  radius\n"
      "  tri      charge  velocity x y  spin  mass  three corners x y\n"
      "  rect     charge  velocity x y  spin  mass  length  width  centre x y  direction (rad)\n"
      "  tercir   centre x y  radius\n"
      "  tertri   three corners x y\n"
      "  terrect  length  width  centre x y  direction (rad)\n"
      "  plane    two points x y; solid below the line\n"
      "  star     position x y  mass  velocity x y\n"
      "  save     a file to write the scene to\n"
      "  finish   then, with --earthquake, a record's name; then n: the step is 0.01 s / n\n"
      "Exit codes: 0 completed, 20 numerically invalid, 30 interrupted, 2 bad input.\n"
      "Example: dougong space app/examples/table-edge.space --duration \"3 s\" --out out/table");
  space->callback([&r] { r.command = [&r] { return space_command(r.space); }; });
}

void describe_program(CLI::App& app, Request& r) {
  app.set_version_flag("--version", fmt::format("dougong {} ({}, {})", program_version(), program_git_hash(),
                                                program_compiler()));
  app.require_subcommand(1);
  app.footer("Example: dougong run --layout four-storey --record wenchuan --pga \"0.3 g\"");
  add_run(app, r);
  add_compare(app, r);
  add_statics(app, r);
  add_layouts(app, r);
  add_records(app, r);
  add_report(app, r);
  add_scene(app, r);
  add_tradeoff(app, r);
  add_describe(app, r);
  add_space(app, r);
}

int report_error(const std::string& text) {
  fmt::print(stderr, "dougong: {}\n", text);
  return exit_bad_input;
}

// --- words that no command knows -------------------------------------------------------------------

std::string suggestion(const std::string& word, const std::vector<std::string>& known) {
  const std::string nearest = structures::nearest_name(word, known);
  return nearest.empty() ? "" : fmt::format("; did you mean \"{}\"?", nearest);
}

std::string path_of(const CLI::App& app) {
  return app.get_parent() ? path_of(*app.get_parent()) + " " + app.get_name() : app.get_name();
}

std::vector<std::string> names_of_commands(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

std::vector<std::string> names_of_flags(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

const CLI::App* chosen_command(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  return chosen.empty() ? &app : chosen_command(*chosen.front());
}

std::string unknown_word(const CLI::App& command, const std::string& word) {
  if (word.starts_with("-"))
    return fmt::format("unknown option \"{}\" of {}{}", word, path_of(command),
                       suggestion(word, names_of_flags(command)));
  const std::vector<std::string> names = names_of_commands(command);
  if (names.empty())
    return fmt::format("unexpected \"{}\" after {}; a value with spaces is one argument, in quotes", word,
                       path_of(command));
  return fmt::format("unknown command \"{}\": expected {} {}{}", word, path_of(command),
                     fmt::join(names, " | "), suggestion(word, names));
}

std::string problem_of(const CLI::App& app, const CLI::App& command, const CLI::ParseError& error) {
  if (const auto left_over = app.remaining(true); !left_over.empty())
    return unknown_word(command, left_over.front());
  const auto names = names_of_commands(command);
  if (names.empty()) return fmt::format("{}: {}", path_of(command), error.what());
  return fmt::format("expected a command: {} {}", path_of(command), fmt::join(names, " | "));
}

std::string command_line_problem(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = *chosen_command(app);
  return fmt::format("{}\n  {} --help says more", problem_of(app, command, error), path_of(command));
}

// The reader of records names its options without knowing how they are written here.
struct OptionHint {
  const char* named;
  const char* written;
};
constexpr OptionHint option_hints[] = {
    {"option units", "dougong run ... --set units=gal, dougong record info ... --units gal"},
    {"option pga", "dougong run ... --pga \"0.3 g\""},
    {"option dt",
     "dougong run ... --set record.interval=\"0.01 s\", dougong record info ... --interval \"0.01 s\""},
    {"option scale",
     "dougong run ... --set count_scale=3920/6182761, dougong record info ... --count-scale 3920/6182761"},
    {"option response",
     "dougong run ... --set record.response=NET.STA.xml, dougong record info ... --response NET.STA.xml"},
    {"option station", "dougong run ... --set station=AOM001, dougong record info ... --station AOM001"},
    {"option member", "dougong run ... --set member=NAME, dougong record info ... --member NAME"},
};

std::string with_hints(std::string text) {
  for (const OptionHint& hint : option_hints)
    if (text.find(hint.named) != std::string::npos)
      text += fmt::format("\n  {}: {}", hint.named, hint.written);
  return text;
}

int carry_out(const Request& request) {
  try {
    return request.command();
  } catch (const ModelError& error) {
    return report_error(fmt::format("the model cannot be run:\n{}", error.what()));
  } catch (const seismic::InputError& error) {
    return report_error(with_hints(error.what()));
  } catch (const std::bad_alloc&) {
    return report_error("not enough memory: ask for fewer blocks, a shorter duration or a lower output.rate");
  } catch (const std::exception& error) {
    return report_error(error.what());
  }
}

}  // namespace

int run_program(int argc, const char* const* argv) {
  CLI::App app{
      "Dougong: how far does a building of blocks drift on a real ground motion, and does it collapse?",
      "dougong"};
  Request request;
  request.run.command = request.compare.command = request.tilt.command = request.pushover.command =
      request.layout.command = request.scene.command = request.space.command = command_text(argc, argv);
  describe_program(app, request);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {  // help and version
    return app.exit(asked) == 0 ? exit_survived : exit_bad_input;
  } catch (const CLI::ParseError& error) {
    return report_error(command_line_problem(app, error));
  }
  return carry_out(request);
}

}  // namespace dougong::app
