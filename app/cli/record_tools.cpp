#include "app/cli/record_tools.h"

#include <CLI/CLI.hpp>
#include <memory>

#include "app/study/target_choice.h"

namespace dougong::app {
namespace {

void add_set(CLI::App& app, std::vector<std::string>& set, const char* meaning) {
  app.add_option("--set", set, meaning)->take_all()->allow_extra_args(false);
}

// How a record is read, and whether it is conditioned.
void add_reading(CLI::App& app, RecordSource& source) {
  app.add_option("--component", source.component, "Component to choose: EW, NS, 180 ...");
  app.add_option("--units", source.units, "Units of a file that does not say: g, gal, m/s2 ...");
  app.add_option("--interval", source.interval, "Time between samples, for a file that does not say");
  app.add_option("--count-scale", source.count_scale, "gal per count: 3920/6182761");
  app.add_flag("--condition", source.condition, "Condition it as a run would (docs/scenario.md)");
  add_set(app, source.set, "key=value of the sections record and conditioning; means --condition");
}

void add_source(CLI::App& app, RecordSource& source) {
  app.add_option("file", source.record, "A file, or a name from `dougong records`")->required();
  add_reading(app, source);
}

void add_periods(CLI::App& app, PeriodChoice& periods, const char* from, const char* to, const char* count) {
  app.add_option("--from", periods.from, from);
  app.add_option("--to", periods.to, to);
  app.add_option("--count", periods.count, count);
  app.add_option("--periods", periods.periods, "Periods instead, with commas between: \"0.2 s,1 s\"")
      ->delimiter(',')
      ->take_all()
      ->allow_extra_args(false);
}

// A command with its options, which live as long as it may be called.
template <class Options>
std::pair<CLI::App*, std::shared_ptr<Options>> command_of(CLI::App& record, const char* name,
                                                          const char* meaning, int (*run)(const Options&),
                                                          std::function<int()>& chosen) {
  CLI::App* app = record.add_subcommand(name, meaning);
  auto options = std::make_shared<Options>();
  app->callback([options, run, &chosen] { chosen = [options, run] { return run(*options); }; });
  return {app, options};
}

void add_spectrum(CLI::App& record, std::function<int()>& chosen) {
  auto [app, o] =
      command_of<SpectrumOptions>(record, "spectrum", "Response, inelastic, rotated and Fourier spectra",
                                  record_spectrum_command, chosen);
  add_source(*app, o->source);
  add_periods(*app, o->periods, "Shortest period (0.02 s)", "Longest period (10 s)",
              "Periods, equally spaced in the logarithm (121)");
  app->add_option("--damping", o->damping, "Damping ratio (5 %)");
  app->add_option("--peaks", o->peaks, "Where peaks are sought: samples, continuous (samples)")
      ->check(CLI::IsMember({"samples", "continuous"}));
  app->add_option("--ductility", o->ductility, "Inelastic spectrum of this constant ductility, bilinear");
  app->add_option("--hardening", o->hardening, "Hardening ratio of the bilinear oscillator (0)");
  app->add_flag("--rotated", o->rotated, "RotD00, RotD50, RotD100 of the horizontal pair");
  app->add_flag("--fourier", o->fourier, "Fourier amplitude, smoothed after Konno and Ohmachi");
  app->add_option("--smoothing", o->smoothing, "Bandwidth of that smoothing (40)");
  app->add_option("--target", o->target, "Design spectrum to draw beside it");
  app->add_option("--csv", o->csv, "Write the table as CSV");
  app->add_option("--plot", o->plot, "Draw it: PNG or SVG");
  app->add_flag("--json", o->json, "As JSON");
  app->add_flag("--force", o->force, "Write over existing files");
  app->footer(target_help() + "Example: dougong record spectrum wenchuan --rotated --csv spectrum.csv");
}

void add_measure(CLI::App& record, std::function<int()>& chosen) {
  auto [app, o] =
      command_of<MeasureOptions>(record, "measure", "Every measure of a record, its pair and its station",
                                 record_measure_command, chosen);
  add_source(*app, o->source);
  app->add_option("--damping", o->damping, "Damping ratio of the spectra (5 %)");
  app->add_option("--threshold", o->threshold, "Of bracketed and uniform duration (0.05 g)");
  app->add_option("--cav-threshold", o->standard_threshold, "Of the standardised CAV (0.025 g)");
  app->add_option("--period", o->period, "First period of a building: its PSa and average Sa");
  app->add_flag("--json", o->json, "As JSON");
  app->add_option("--csv", o->csv, "Write them as CSV");
  app->add_flag("--force", o->force, "Write over an existing file");
  app->footer("Example: dougong record measure tohoku --period \"0.5 s\"");
}

void add_process(CLI::App& record, std::function<int()>& chosen) {
  auto [app, o] = command_of<ProcessOptions>(record, "process", "Condition a record and say every step",
                                             record_process_command, chosen);
  add_source(*app, o->source);
  app->add_option("--period", o->period, "Period of a building: warns of what does not suit it");
  app->add_option("--out", o->out, "Write the conditioned motion: .at2 or .csv");
  app->add_option("--plot", o->plot, "Draw before and after: PNG or SVG");
  app->add_flag("--json", o->json, "As JSON");
  app->add_flag("--force", o->force, "Write over existing files");
  app->footer(
      "Example: dougong record process wenchuan --set high_pass=\"0.05 Hz\" --set end=at-rest --out w.at2 "
      "--plot "
      "w.png");
}

void add_plot(CLI::App& record, std::function<int()>& chosen) {
  auto [app, o] = command_of<PlotOptions>(
      record, "plot", "Acceleration, velocity, displacement, Husid curve and spectra on one sheet",
      record_plot_command, chosen);
  add_source(*app, o->source);
  app->add_option("--damping", o->damping, "Damping ratio of the spectrum (5 %)");
  app->add_option("--out", o->out, "PNG or SVG file (NAME.png in the current folder)");
  app->add_option("--csv", o->csv, "Write the histories as CSV");
  app->add_flag("--force", o->force, "Write over existing files");
  app->add_flag("--json", o->json, "What was drawn and its peaks, as JSON");
  app->footer("Example: dougong record plot kobe --component NS --out kobe.svg");
}

void add_scale(CLI::App& record, std::function<int()>& chosen) {
  auto [app, o] = command_of<ScaleOptions>(record, "scale", "Factors that bring records to a target",
                                           record_scale_command, chosen);
  app->add_option("files", o->records, "Files, or names from `dougong records`")->required();
  add_reading(*app, o->source);
  add_periods(*app, o->periods, "Start of the band (0.2 s)", "End of the band (2 s)",
              "Periods, equally spaced in the logarithm (50)");
  app->add_option("--target", o->target, "Target spectrum");
  app->add_option("--rule", o->rule, "mean-log, least-squares, never-below (mean-log)")
      ->check(CLI::IsMember({"mean-log", "least-squares", "never-below"}));
  app->add_option("--floor", o->floor,
                  "Raise all by one factor until their mean is nowhere below this part of the target: 0.9");
  app->add_option("--damping", o->damping, "Damping ratio (that of the target)");
  app->add_option("--pga", o->pga, "Scale to a peak ground acceleration instead: \"0.3 g\"");
  app->add_option("--sa", o->sa, "Scale to a PSa at --period instead: \"0.5 g\"");
  app->add_option("--period", o->period, "Period of --sa");
  app->add_option("--csv", o->csv, "Write target, mean and scaled spectra as CSV");
  app->add_option("--plot", o->plot, "Draw them: PNG or SVG");
  app->add_flag("--json", o->json, "As JSON");
  app->add_flag("--force", o->force, "Write over existing files");
  app->footer(target_help() +
              "Example: dougong record scale wenchuan tohoku kobe --target \"ec8: type=1, ground=C, ag=0.25 "
              "g\" --from "
              "\"0.2 s\" --to \"2 s\" --floor 0.9");
}

void add_rotate(CLI::App& record, std::function<int()>& chosen) {
  auto [app, o] = command_of<RotateOptions>(record, "rotate", "A horizontal pair at another azimuth",
                                            record_rotate_command, chosen);
  add_source(*app, o->source);
  app->add_option("--azimuth", o->azimuth,
                  "Clockwise from north: \"30 deg\"; needs components that say theirs");
  app->add_option("--angle", o->angle, "From the first horizontal component towards the second instead");
  app->add_flag("--largest", o->largest, "The angle of the greatest acceleration instead (RotD100)");
  app->add_option("--out", o->out, "Write it: .at2 or .csv");
  app->add_flag("--json", o->json, "As JSON");
  app->add_flag("--force", o->force, "Write over existing files");
  app->footer("Example: dougong record rotate tohoku --azimuth \"30 deg\" --out tohoku-030.at2");
}

void add_make(CLI::App& record, std::function<int()>& chosen) {
  auto [app, o] = command_of<MakeOptions>(
      record, "make", "Make a motion: pulses, noise, stochastic, compatible", record_make_command, chosen);
  app->add_option("kind", o->kind, "What to make; without one the kinds are listed with their keys");
  add_set(*app, o->set, "key=value of the kind");
  app->add_option("--out", o->out, "File: .at2 or .csv");
  app->add_flag("--json", o->json, "What was made, as JSON");
  app->add_flag("--force", o->force, "Write over an existing file");
  app->footer(
      "Example: dougong record make ricker --set peak=\"0.3 g\" --set frequency=\"2 Hz\" --out ricker.at2");
}

}  // namespace

void add_record_tools(CLI::App& record, std::function<int()>& chosen) {
  add_spectrum(record, chosen);
  add_measure(record, chosen);
  add_process(record, chosen);
  add_plot(record, chosen);
  add_scale(record, chosen);
  add_rotate(record, chosen);
  add_make(record, chosen);
}

}  // namespace dougong::app
