// The record that a command of `dougong record` works on: as it was read, or as a scenario's conditioning
// leaves it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/study/motion_input.h"
#include "app/study/quantity.h"

namespace dougong::app {

struct RecordSource {
  std::string record;  // a file, or a name of the catalogue
  std::string component, units, interval, count_scale;
  bool condition = false;        // as a run would apply it
  std::vector<std::string> set;  // key=value of the sections record and conditioning; means condition
};

Scenario scenario_of(const RecordSource& source);
seismic::RecordSet read_source(const RecordSource& source);

/// One horizontal or vertical history to be measured.
struct SourceMotion {
  std::string title;                 // "Imperial Valley / El Centro / 180"
  std::string state;                 // "as read, mean removed", "conditioned"
  std::vector<double> acceleration;  // m/s2, or multiples of the peak when dimensionless
  double interval = 0.0;             // s
  bool dimensionless = false;
  bool synthetic = false;
  std::vector<std::string> processing, warnings;
};
/// The chosen component, its mean removed where it is taken as read.
SourceMotion motion_of(const RecordSource& source);
std::string title_of(const seismic::Record& record);
/// Throws InputError where there are not two.
std::pair<const seismic::Record*, const seismic::Record*> horizontal_pair(const seismic::RecordSet& set);

/// Throws ScenarioError: where it was written, and what was expected and found.
[[noreturn]] void refuse(const std::string& where, const std::string& message);

/// A quantity of the command line. Throws ScenarioError that names the option.
double quantity_of(const std::string& text, Dimension dimension, const char* option);
/// The same, of a text that may be empty.
double quantity_or(const std::string& text, Dimension dimension, const char* option, double otherwise);

/// --damping, 5 % where it is empty. Throws ScenarioError.
double damping_of(const std::string& text);

/// --from, --to, --count and --periods of a spectrum.
struct PeriodChoice {
  std::string from, to;
  std::size_t count = 0;             // 0: as the command says
  std::vector<std::string> periods;  // instead: "0.2 s"
};
/// Throws ScenarioError for periods that are not within 1 ms to 100 s or rise from `from` to `to`.
std::vector<double> periods_of(const PeriodChoice& choice, double from, double to, std::size_t count);

}  // namespace dougong::app
