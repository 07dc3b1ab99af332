// The commands of the program, each from its options to an exit code. Errors are thrown: main() prints
// them and exits with 2.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace dougong::app {

enum ExitCode : int {
  exit_survived = 0,
  exit_bad_input = 2,
  exit_collapsed = 10,
  exit_numerically_invalid = 20,
  exit_undecided = 30,
};

/// A film of a building's run.
struct FilmChoice {
  std::string path;                     // .mp4; empty: none
  double slow = 1.0;                    // 4: a second of the run takes four
  std::string colour = "displacement";  // of the blocks: one of block_colours()
};

struct RunOptions {
  std::string scenario;  // path; empty: defaults and flags
  std::string layout, record, component, pga, ensemble, codes, out;
  std::vector<std::string> set;  // key=value
  std::size_t jobs = 0;          // runs at a time; 0: one a processor
  bool force = false;
  bool json = false;
  bool pdf = false;  // report.pdf beside report.html
  FilmChoice film;
  std::string command;  // as typed
};
int run_command(const RunOptions& options);

struct CompareOptions {
  std::string scenario;               // path; empty: defaults and flags
  std::vector<std::string> vary;      // "key = value, value"
  std::vector<std::string> records;   // files or names; empty: the base's own
  std::string layout, pga, ensemble;  // of all runs
  std::vector<std::string> set;       // key=value of all runs
  std::string same_sa = "auto";       // auto, yes, no
  std::string out;                    // folder; empty: SCENARIO-compare in the current folder
  std::size_t jobs = 0;               // runs at a time; 0: one a processor
  bool force = false;
  bool pdf = false;     // compare.pdf beside compare.html
  std::string command;  // as typed
};
/// Variants of a building on the same motions, paired.
int compare_command(const CompareOptions& options);

struct StaticsOptions {
  bool pushover = false;  // else a tilt
  std::string scenario;   // path; empty: defaults and flags
  std::string layout;
  std::vector<std::string> set;  // key=value
  std::string towards = "both";  // left, right, both
  std::string pattern = "mass";  // of a pushover: mass, triangular, first-mode
  std::string precision, step, largest, hold, target;
  std::string out;  // folder; empty: LAYOUT-tilt or LAYOUT-pushover
  bool force = false;
  std::string command;  // as typed
};
/// How much of its weight a building bears sideways, and how it would go.
int statics_command(const StaticsOptions& options);

struct LayoutsOptions {
  std::string page;  // HTML file to write as well
  bool force = false;
};
/// The table of all; with a page, also their drawings and parameters.
int layouts_command(const LayoutsOptions& options);

struct LayoutOptions {
  std::string name;              // of a layout, or a scene file with storeys
  std::vector<std::string> set;  // parameter=value
  std::string out;               // PNG or SVG; of an export TOML, SVG or DXF; empty: NAME.png or NAME.toml;
                                 // of the modes a folder; empty: NAME-modes
  bool force = false;
  std::size_t count = 6;  // of modes
  std::string command;    // as typed
};
/// What it is, its parameters, and a picture.
int layout_show_command(const LayoutOptions& options);
/// A picture.
int layout_draw_command(const LayoutOptions& options);
/// What the model check finds, whether it settles, and its period.
int layout_check_command(const LayoutOptions& options);
/// Periods and shapes of small vibrations; writes into a folder.
int layout_modes_command(const LayoutOptions& options);
int layout_export_command(const LayoutOptions& options);

struct ImportOptions {
  std::string file;                   // .dxf or .csv
  std::string out;                    // .toml
  std::string units = "m";            // of a DXF file
  std::string material = "concrete";  // a preset
  bool force = false;
};
/// Outlines drawn elsewhere, written as a scene file that lists its storeys.
int layout_import_command(const ImportOptions& options);

struct RecordListOptions {
  std::string folder;                // empty: the shipped motions
  std::vector<std::string> periods;  // of the spectral accelerations: "0.5 s"
  std::string near_period, sort, csv;
  std::size_t jobs = 0;  // files at a time; 0: one a processor
  bool json = false, force = false;
};
/// The shipped motions, or every recording below a folder, with what they measure.
int records_command(const RecordListOptions& options);

struct RecordInfoOptions {
  std::vector<std::string> more;  // further files: other components of the station
  std::string record, component, station, member, response, units, interval, count_scale;
  std::string csv;  // file of record info, a row a component; empty: none
  bool json = false;
  bool force = false;
};
int record_info_command(const RecordInfoOptions& options);

struct RecordConvertOptions {
  RecordInfoOptions from;
  std::string format;        // at2, knet, csmnc, csv, miniseed
  std::string out;           // stem of the files' names; empty: that of the record, in the current folder
  std::string azimuth, pga;  // empty: as recorded
  bool force = false;
};
/// A record in the files of another format.
int record_convert_command(const RecordConvertOptions& options);

struct ReportOptions {
  std::string directory;
  FilmChoice film;
  bool force = false;  // of the film
  bool pdf = false;    // report.pdf beside report.html
};
int report_command(const ReportOptions& options);

struct SceneOptions {
  std::string file;
  std::string out;               // folder of a run, picture of a drawing; empty: as the scene says
  std::vector<std::string> set;  // key=value
  bool force = false;
  std::string command;  // as typed
};
/// Whether a scene file is sound: its errors, or what it holds.
int scene_check_command(const SceneOptions& options);
int scene_run_command(const SceneOptions& options);
int scene_draw_command(const SceneOptions& options);

struct TradeoffOptions {
  std::string file;
  std::string out;               // folder; empty: FILE-tradeoff in the current folder
  std::vector<std::string> set;  // key=value
  std::vector<std::string> integrators, steps, tolerances, stiffnesses, bodies;
  std::string target, budget, measure, members;
  bool force = false;
};
/// Error against cost of a scene, over integrators, steps and contact stiffnesses.
int tradeoff_command(const TradeoffOptions& options);

struct DescribeOptions {
  std::string file;
  std::vector<std::string> set;  // key=value
};
/// What would be modelled, of a scene file or a scenario, and what it would cost.
int describe_command(const DescribeOptions& options);

struct SpaceOptions {
  std::string file;  // empty: standard input
  bool earthquake = false;
  std::string material, duration, out;
  bool force = false;
  std::string command;  // as typed
};
/// The message loop: messages in, a run out.
int space_command(const SpaceOptions& options);

/// Folder of the shipped records: $DOUGONG_RECORDS, or where the program was built from.
std::filesystem::path records_directory();

}  // namespace dougong::app
