// Error against cost of one scene, over integrators, steps and contact stiffnesses.
//
//   error      distance of a run from the scene's reference, over the largest motion (distance.h)
//   numerical  distance from the reference of the run's own stiffness: what steps do
//   model      distance between the two references: what another stiffness does
//
// Nothing is dropped: a run that is refused, fails or is too dear is in the list, with its reason.
#pragma once

#include <algorithm>
#include <stdexcept>

#include "app/study/tradeoff/knee.h"
#include "app/study/tradeoff/reference.h"

namespace dougong::app {

struct TradeoffChoice {
  LadderChoice ladder;
  double target = 0.01;     // -, error that is good enough
  double budget = 20.0;     // s of processor time a run; a reference has ten times as much
  std::size_t members = 8;  // of the ensemble; 0: none
  Measure measure = Measure::rms;
  std::vector<std::string> bodies;  // that are compared; empty: all
};

/// The model of one stiffness, as well as it can be computed.
struct TradeoffModel {
  double stiffness = 1.0;
  Trial reference;
  double resolution = 0.0;  // -, the reference against one twice as coarse
  double error = 0.0;       // -, against the scene's own model
};

struct Tradeoff {
  TradeoffChoice choice;  // completed
  std::string title;
  double duration = 0.0;              // s, simulated
  double motion = 0.0;                // m, the largest in the reference
  std::vector<TradeoffModel> models;  // the scene's own first
  std::vector<JudgedTrial> trials;
  std::size_t own = 0;  // the trial that the scene itself asks for
  Ensemble ensemble;
  std::vector<std::string> left_out;  // integrators that do not apply, and why
  bool interrupted = false;

  double spread() const { return ensemble.spread() / motion; }
  /// Whether what began alike has parted by a thousand times as much.
  bool chaotic() const;
  double resolution() const { return models.front().resolution; }
  /// The least error that can be told: what the reference resolves, and of a chaotic motion twice the spread,
  /// since run and reference are two of its members.
  double least_known() const;
  /// The error that is asked for, or the least that can be told.
  double target() const { return std::max(choice.target, least_known()); }
  std::optional<std::size_t> recommended() const { return cheapest_within(target(), trials); }
  std::optional<std::size_t> ten_times_better() const;
};

struct TradeoffProgress {
  std::size_t done = 0, total = 0;  // runs
  std::string now;                  // "rk4, 0.25 of the bound, stiffness x 10"
  double part = 0.0;                // of the present run
};
/// Returns false to stop: what is left is not run.
using TradeoffObserver = std::function<bool(const TradeoffProgress&)>;

/// No run of any candidate completed, so that there is nothing to measure by.
class NoReference : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws as prepare_scene(), and NoReference.
Tradeoff run_tradeoff(const SceneDescription& description, const std::filesystem::path& records_directory,
                      const TradeoffChoice& choice, const TradeoffObserver& progress = {});

}  // namespace dougong::app
