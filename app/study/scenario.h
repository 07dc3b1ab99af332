// A scenario: everything one run is asked for, as plain data. SI units and radians inside.
//
// It is read from TOML, where every value with a dimension is text with its unit ("0.4 g"; a bare number
// is an error), and from overrides "key=value" of the command line. One table (scenario_keys.h) says
// which keys there are; docs/scenario.md lists them. All errors are collected and thrown together.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/study/integration_choice.h"
#include "app/study/override.h"
#include "app/study/perturbation.h"
#include "structures/layouts/layout.h"
#include "structures/response.h"
#include "structures/verdict.h"

namespace dougong::app {

struct LayoutChoice {
  std::string name = "four-storey";
  std::string file = {};  // a building by hand instead: a scene file with storeys (building_scene.h)
  /// By name, SI. Complete once read: what was not given holds the layout's default.
  structures::ParameterMap parameters;
  friend bool operator==(const LayoutChoice&, const LayoutChoice&) = default;
};

/// A layout on a floor of the building; without a name there is none.
struct ItemChoice : LayoutChoice {
  double level = 1;    // its place among the levels, from 1
  double place = 0.0;  // m, of its middle
};

/// A neighbour on the right; without a name there is none.
struct NeighbourChoice : LayoutChoice {
  double gap = 0.05;  // m, between the two
};

struct RecordChoice {
  std::string file;       // path, or empty
  std::string name;       // in the catalogue, or empty
  std::string component;  // that drives the horizontal axis; empty: the file's own
  std::string station;    // of a file with several; empty: there is one
  std::string member;     // of an archive; empty: all of it
  std::string response;   // StationXML with the sensitivity of counts; empty: the one beside the file
  bool vertical = false;  // the vertical component drives the ground too
  std::string format;     // empty: found from the content
  std::string units;      // of the values, for files that do not say
  std::optional<double> interval;  // s between samples, for files that do not say
  std::string count_scale;         // gal per count, "3920/6182761", for files in counts that do not say
  std::optional<double> pga;       // m/s2, that the horizontal component is scaled to
  std::optional<double> scale;     // -, instead of pga
  std::string design_spectrum;     // drawn beside the motion's, in words (target_choice.h); empty: none
};

struct Conditioning {
  std::string offset = "mean";    // mean, pre-event, keep
  double pre_event = 5.0;         // s at the start, whose mean pre-event takes off
  std::string baseline = "none";  // none, acceleration-line, velocity-parabola, acceleration-polynomial,
                                  // velocity-polynomial
  double baseline_degree = 3;     // of the polynomials
  double taper = 0.05;            // of the record's duration, at each end
  std::optional<double> pad;      // s of zeros at each end; unset: what the filter needs
  std::optional<double> high_pass = 0.1;  // Hz
  bool filter = true;
  std::optional<double> low_pass;  // Hz; unset: 25, or none where the record has nothing above it
  double filter_order = 4;
  std::string filter_phase = "zero";  // zero, causal
  std::optional<double> interval;     // s, to resample to; unset: the record's own
  std::string resample = "fft";       // fft, spline, linear
  std::string end = "as-it-is";       // as-it-is, at-rest
};

struct SolveChoice : IntegrationChoice {
  std::optional<double> duration;              // s; unset: the motion and free_vibration
  double free_vibration = 5.0;                 // s, after the motion
  std::optional<double> after_collapse = 5.0;  // s, after every storey is lost; unset: to the end
  bool settle = true;                          // under gravity, before the motion
};

struct ScreeningChoice {
  std::string codes = "automatic";      // ids of standards, automatic or none
  std::string structure = "automatic";  // a structural type (structures/code_screen.h), automatic or none
};

struct EnsembleChoice {
  double n = 1;  // runs in all, the one described first
  bool half_step = true;
  Perturbation perturbation;
};

struct OutputChoice {
  double rate = 100.0;       // Hz, of the histories
  double state_rate = 50.0;  // Hz, of the states of all blocks
  std::string directory = "dougong-out";
  double save_every = 30.0;  // s, of the clock
};

struct Scenario {
  LayoutChoice layout;
  ItemChoice on{{.name = "", .file = "", .parameters = {}}};
  NeighbourChoice beside{{.name = "", .file = "", .parameters = {}}};
  RecordChoice record;
  Conditioning conditioning;
  SolveChoice solve;
  structures::LossCriteria loss;
  structures::VerdictCriteria verdict;
  ScreeningChoice screening;
  EnsembleChoice ensemble;
  OutputChoice output;
};

/// The building with what stands on it and beside it. Throws LayoutError, and ScenarioError for a file that
/// is no building.
structures::Building building_of(const Scenario& scenario);

enum class RecordRule { required, optional };

/// Overrides win over the text; of two that exclude each other the overriding one stays. Throws
/// ScenarioError.
Scenario read_scenario(const std::string& text, const std::string& source,
                       const std::vector<Override>& overrides = {}, RecordRule rule = RecordRule::required);
/// others: lists of tables that the file holds for someone else.
Scenario load_scenario(const std::filesystem::path& path, const std::vector<Override>& overrides = {},
                       RecordRule rule = RecordRule::required, const std::vector<std::string>& others = {});
/// Without a file: the defaults and the overrides.
Scenario scenario_from(const std::vector<Override>& overrides, RecordRule rule = RecordRule::required);

enum class Comments { none, meanings };

/// The complete scenario, defaults included. Reading it gives the same scenario. Throws LayoutError for
/// a layout or parameters that do not exist.
std::string to_toml(const Scenario& scenario, Comments comments = Comments::none);

}  // namespace dougong::app
