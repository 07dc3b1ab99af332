// A run of a free scene: what is found out before it moves, the run, and what it leaves behind.
#pragma once

#include <functional>

#include "app/study/run_result.h"
#include "app/study/scene_build.h"
#include "app/study/scene_description.h"
#include "engine/drive.h"
#include "engine/fields/tree_error.h"
#include "engine/settle.h"

namespace dougong::app {

struct PreparedScene {
  SceneDescription description;
  engine::Scene scene;                 // with its motions
  std::vector<TerrainMotion> motions;  // one a terrain; empty where it stands still
  engine::Model model;
  engine::State state;  // settled where that was asked for
  engine::SettleReport settle;
  engine::DriveOptions drive;
  std::string accuracy;  // what it chose and why; empty when an integrator was named
  engine::StepPlan plan;
  double highest_frequency = 0.0;              // Hz, bound; 0 where nothing vibrates
  double estimated_seconds = 0.0;              // of one processor
  std::vector<engine::TreeError> tree_errors;  // at the start, of fields summed by a tree
  /// What is accepted and perhaps not meant: bodies that overlap at the start, outputs at other times.
  std::vector<std::string> findings;
};

/// Throws ScenarioError, seismic::InputError, std::invalid_argument.
PreparedScene prepare_scene(const SceneDescription& description,
                            const std::filesystem::path& records_directory);
/// Compiled and at its start only: what is checked before anything is computed.
PreparedScene check_scene(const SceneDescription& description,
                          const std::filesystem::path& records_directory);

/// The same scene from the same start, integrated in another way; an unstable step is found out by the run.
/// Throws std::invalid_argument.
PreparedScene integrated_by(PreparedScene scene, const IntegrationChoice& choice);

/// Heads and reasons: "uniform gravity of 9.80665 m/s2".
std::vector<std::string> modelled_terms(const PreparedScene& scene);
std::vector<std::string> missing_terms(const PreparedScene& scene);
/// The scene before any run, for a picture.
ModelSheet scene_sheet(const SceneDescription& description, const engine::Scene& scene);

struct SceneResult {
  /// The parts of a run that scenes share with buildings: model, trajectory, energy, numerics, moments.
  RunResult run;
  SceneOutput output;
  std::vector<engine::Vec2> velocities, accelerations;  // m/s, m/s2, [time][body]
  std::vector<double> spins, angular_accelerations;     // rad/s, rad/s2, [time][body]
  std::vector<std::string> terrain_names;
  std::vector<engine::Vec2> terrain_displacements;  // m, absolute, [time][terrain]
  bool valid = true;                                // false: the numbers failed; `reason` says which
  std::string reason;
  /// Of fields summed by a tree, measured where the bodies were at the start and at the end.
  std::vector<engine::TreeError> tree_at_start, tree_at_end;
};

struct SceneProgress {
  double time = 0.0, end_time = 0.0;  // s
  double fastest = 0.0;               // m/s, of any body now
  double energy_error = 0.0;          // -, of the energy turned over so far
};
/// Returns false to interrupt the run.
using SceneObserver = std::function<bool(const SceneProgress&)>;

SceneResult run_scene(PreparedScene& scene, const std::string& command, const SceneObserver& progress = {});

}  // namespace dougong::app
