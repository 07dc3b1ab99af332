// The commands of `dougong record` that measure, condition, draw, scale, turn and make motions.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/cli/record_source.h"

namespace CLI {
class App;
}

namespace dougong::app {

struct SpectrumOptions {
  RecordSource source;
  PeriodChoice periods;
  std::string damping;            // "5 %"
  std::string peaks = "samples";  // samples, continuous
  std::string ductility, hardening;
  bool rotated = false, fourier = false;
  std::string smoothing;  // bandwidth of Konno and Ohmachi; empty: 40
  std::string target, csv, plot;
  bool json = false, force = false;
};
int record_spectrum_command(const SpectrumOptions& options);

struct MeasureOptions {
  RecordSource source;
  std::string damping, threshold, standard_threshold, period, csv;
  bool json = false, force = false;
};
/// Every measure of every component, of the pair and of the station.
int record_measure_command(const MeasureOptions& options);

struct ProcessOptions {
  RecordSource source;
  std::string out, plot, period;
  bool json = false, force = false;
};
int record_process_command(const ProcessOptions& options);

struct PlotOptions {
  RecordSource source;
  std::string damping, out, csv;
  bool json = false, force = false;
};
int record_plot_command(const PlotOptions& options);

struct ScaleOptions {
  std::vector<std::string> records;
  RecordSource source;  // all but the record
  PeriodChoice periods;
  std::string target, rule = "mean-log", damping, floor;
  std::string pga, sa, period;  // instead of a target
  std::string csv, plot;
  bool json = false, force = false;
};
int record_scale_command(const ScaleOptions& options);

struct RotateOptions {
  RecordSource source;
  std::string azimuth, angle, out;
  bool largest = false, json = false, force = false;
};
int record_rotate_command(const RotateOptions& options);

struct MakeOptions {
  std::string kind;
  std::vector<std::string> set;
  std::string out;
  bool json = false, force = false;
};
int record_make_command(const MakeOptions& options);

/// Adds them to `dougong record`; the one that was asked for becomes `command`.
void add_record_tools(CLI::App& record, std::function<int()>& command);

}  // namespace dougong::app
