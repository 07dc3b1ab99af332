#include "app/study/scene_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/study/rocking_limits.h"
#include "app/study/run_cost.h"
#include "app/study/run_sheets.h"
#include "app/study/scene_file.h"
#include "app/study/scene_findings.h"
#include "app/study/scene_keys.h"
#include "app/study/stopwatch.h"
#include "engine/integrators/table.h"
#include "structures/verdict.h"

namespace dougong::app {
namespace {

using engine::Vec2;

void choose_drive(PreparedScene& p) {
  const SceneDescription& d = p.description;
  p.accuracy = choose_integration(d.solve, p.model, p.drive);
  p.drive.output_interval = 1.0 / d.output.rate;
  p.drive.end_time = d.solve.duration;
}

engine::Scene built(const SceneDescription& description) {
  BuiltScene result = build_scene(description);
  if (result.problems.empty()) return std::move(result.scene);
  std::vector<LocatedMessage> messages;
  for (const SceneProblem& p : result.problems) messages.push_back({p.section + "." + p.key, p.message});
  throw ScenarioError(std::move(messages));
}

double highest_frequency(const PreparedScene& p) {
  const auto frames = engine::frames_of(p.model, p.state);
  engine::State state = p.state;
  state.contacts.make_rigid(p.model, frames, engine::traits_of(p.drive.integrator).rigid_contacts);
  const double squared = engine::spectral_bound(p.model, state, frames).stiffness;
  return std::sqrt(std::max(squared, 0.0)) / (2.0 * std::numbers::pi);
}

std::vector<engine::TreeError> tree_errors_now(const PreparedScene& p) {
  return engine::tree_errors(p.model.fields, engine::frames_of(p.model, p.state));
}

// Pose, velocity and acceleration of every body and a dozen histories.
void refuse_too_much_output(const PreparedScene& p) {
  const double values = 9.0 * static_cast<double>(p.model.body_count) + 12.0;
  app::refuse_too_much_output(p.drive.end_time / p.plan.output_interval, values, p.model.body_count);
}

// --- recording ---------------------------------------------------------------------------------------

// Terrains that all move alike carry the camera with them; else it stands still.
bool camera_rides(const PreparedScene& p) {
  const auto& terrains = p.scene.terrains;
  return !terrains.empty() && terrains.front().motion &&
         std::ranges::all_of(terrains, [&](const auto& t) { return t.motion == terrains.front().motion; });
}

class SceneRecorder {
 public:
  SceneRecorder(const PreparedScene& p, SceneResult& result) : p_(p), out_(result), rides_(camera_rides(p)) {
    out_.run.trajectory.blocks = p.model.body_count;
  }

  void note(const engine::Sample& sample) {
    note_bodies(sample);
    note_damage(p_.model, sample.state, out_.run.model.bonded);
    note_terrains(sample);
    for (std::string& text : rocking_.look(p_.model, sample.state)) warnings_.push_back(std::move(text));
    energies_.note(p_.model, sample.state);
    const OverlapRatios overlap =
        overlap_ratios(sample.state.contacts.points, engine::frames_of(p_.model, sample.state));
    out_.run.numerics.overlap_ratio.push_back(overlap.deepest);
    out_.run.numerics.mean_overlap_ratio.push_back(overlap.mean);
  }

  SceneProgress progress() const {
    return {out_.run.trajectory.times.back(), p_.drive.end_time, fastest_, energies_.energy.relative_error};
  }
  EnergyHistory take_energy() { return std::move(energies_.energy); }
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  void note_bodies(const engine::Sample& sample) {
    structures::Trajectory& t = out_.run.trajectory;
    const auto q = sample.state.q(), v = sample.state.v();
    const std::size_t n = t.blocks;
    t.times.push_back(sample.state.time);
    fastest_ = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      const Vec2 velocity{v[i], v[n + i]};
      t.poses.insert(t.poses.end(), {q[i] + p_.model.origin.x, q[n + i] + p_.model.origin.y, q[2 * n + i]});
      out_.velocities.push_back(velocity);
      out_.spins.push_back(v[2 * n + i]);
      out_.accelerations.push_back({sample.accelerations[i], sample.accelerations[n + i]});
      out_.angular_accelerations.push_back(sample.accelerations[2 * n + i]);
      fastest_ = std::max(fastest_, engine::norm(velocity));
    }
  }

  void note_terrains(const engine::Sample& sample) {
    Vec2 ground;
    for (const engine::Terrain& terrain : p_.scene.terrains) {
      const Vec2 displacement = terrain.motion ? terrain.motion->at(sample.state.time).displacement : Vec2{};
      out_.terrain_displacements.push_back(displacement);
      if (rides_)
        ground = displacement;
      else
        out_.run.terrain_displacement.push_back(displacement);
    }
    out_.run.trajectory.ground_displacement.push_back(ground);
    out_.run.trajectory.ground_reaction.push_back(sample.terrain_reaction);
  }

  const PreparedScene& p_;
  SceneResult& out_;
  bool rides_;
  EnergyRecorder energies_;
  RockingLimits rocking_;
  std::vector<std::string> warnings_;
  double fastest_ = 0.0;
};

// --- judging -----------------------------------------------------------------------------------------

std::string number_trouble(const SceneResult& r, const engine::RunOutcome& run) {
  const structures::VerdictCriteria limits;
  if (run.outcome == engine::Outcome::diverged || run.outcome == engine::Outcome::step_too_large)
    return run.detail;
  const double error = r.run.energy.relative_error, overlap = r.run.numerics.deepest_overlap_ratio;
  if (!(error <= limits.energy_error))
    return fmt::format("the energy error is {:.2g} % of the energy turned over; at most {:.2g} % are trusted",
                       100.0 * error, 100.0 * limits.energy_error);
  if (!(overlap <= limits.overlap))
    return fmt::format("{} overlapped by {:.2g} % of the smaller one's width; at most {:.2g} % are trusted",
                       r.run.numerics.deepest_overlap_where, 100.0 * overlap, 100.0 * limits.overlap);
  return "";
}

// --- moments -----------------------------------------------------------------------------------------

// How much the picture changes up to every output time: the greatest movement of any body in between.
std::vector<double> activity_of(const PreparedScene& p, const structures::Trajectory& t) {
  std::vector<double> sum(t.times.size());
  for (std::size_t k = 1; k < t.times.size(); ++k) {
    double most = 0.0;
    for (std::size_t i = 0; i < t.blocks; ++i) {
      const double turn = std::abs(t.angle(k, i) - t.angle(k - 1, i)) * p.model.bounding_radius[i];
      most = std::max(most, engine::norm(t.position(k, i) - t.position(k - 1, i)) + turn);
    }
    sum[k] = sum[k - 1] + (std::isfinite(most) ? most : 0.0);
  }
  return sum;
}

// Start, end, and moments between which equally much happened.
std::vector<Moment> moments_of(const PreparedScene& p, const structures::Trajectory& t) {
  const auto wanted = static_cast<std::size_t>(p.description.output.pictures);
  if (t.times.empty() || wanted == 0) return {};
  std::vector<Moment> moments{{t.times.front(), "start"}};
  const std::vector<double> activity = activity_of(p, t);
  for (std::size_t i = 1; i + 1 < wanted && activity.back() > 0.0; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(wanted - 1) * activity.back();
    const auto k = std::ranges::lower_bound(activity, part) - activity.begin();
    moments.push_back({t.times[static_cast<std::size_t>(k)], ""});
  }
  return moments;
}

std::string checksum_of(const std::vector<TerrainMotion>& motions) {
  for (const TerrainMotion& motion : motions)
    if (!motion.sha256.empty()) return motion.sha256;
  return "";
}

void describe_motion(const PreparedScene& p, MotionSheet& sheet) {
  for (std::size_t i = 0; i < p.motions.size(); ++i) {
    if (!p.motions[i].motion || sheet.title == p.motions[i].title) continue;
    sheet.title += (sheet.title.empty() ? "" : "; ") + p.motions[i].title;
    sheet.processing.insert(sheet.processing.end(), p.motions[i].processing.begin(),
                            p.motions[i].processing.end());
  }
}

}  // namespace

PreparedScene check_scene(const SceneDescription& description,
                          const std::filesystem::path& records_directory) {
  PreparedScene p;
  p.description = description;
  p.scene = built(description);
  p.motions = attach_motions(description, p.scene, records_directory);
  p.model = engine::compile(p.scene);
  p.state = engine::initial_state(p.model, p.scene);
  choose_drive(p);
  p.plan = engine::plan_steps(p.model, p.state, p.drive);
  p.highest_frequency = highest_frequency(p);
  p.findings = findings_of(p);
  p.tree_errors = tree_errors_now(p);
  return p;
}

PreparedScene integrated_by(PreparedScene p, const IntegrationChoice& choice) {
  static_cast<IntegrationChoice&>(p.description.solve) = choice;
  choose_drive(p);
  p.plan = engine::plan_steps(p.model, p.state, p.drive);
  return p;
}

PreparedScene prepare_scene(const SceneDescription& description,
                            const std::filesystem::path& records_directory) {
  PreparedScene p = check_scene(description, records_directory);
  if (description.solve.settle) {
    p.settle = engine::settle(p.model, p.state);
    p.plan = engine::plan_steps(p.model, p.state, p.drive);
    p.highest_frequency = highest_frequency(p);
    p.tree_errors = tree_errors_now(p);
  }
  refuse_unstable_step(p.drive, p.plan);
  refuse_too_much_output(p);
  p.estimated_seconds = estimated_cost(p.model, p.state, p.drive, p.plan, p.drive.end_time);
  return p;
}

ModelSheet scene_sheet(const SceneDescription& description, const engine::Scene& scene) {
  ModelSheet sheet;
  sheet.free_scene = true;
  sheet.trails = scene.fields.gravitational_constant != 0.0 || scene.fields.coulomb_constant != 0.0;
  sheet.layout = description.head.title.empty() ? "scene" : description.head.title;
  for (const engine::Material& m : scene.materials) sheet.materials.push_back(material_sheet(m));
  for (const engine::Body& body : scene.bodies) {
    sheet.blocks.push_back(drawn_shape(body, scene));
    sheet.mass += sheet.blocks.back().mass;
  }
  for (const engine::Terrain& terrain : scene.terrains) sheet.terrains.push_back(drawn_shape(terrain, scene));
  draw_connections(scene, sheet);
  return sheet;
}

SceneResult run_scene(PreparedScene& p, const std::string& command, const SceneObserver& progress) {
  SceneResult result;
  RunResult& run = result.run;
  run.model = scene_sheet(p.description, p.scene);
  run.model.modelled = modelled_terms(p);
  run.model.not_modelled = missing_terms(p);
  describe_motion(p, run.motion);
  run.settle = settle_sheet(p.settle);
  run.reproducibility = reproducibility_of(to_toml(p.description), checksum_of(p.motions), command);
  result.output = p.description.output;
  for (const engine::Terrain& terrain : p.scene.terrains) result.terrain_names.push_back(terrain.name);

  result.tree_at_start = p.tree_errors;
  const Stopwatch watch;
  SceneRecorder recorder(p, result);
  const engine::RunOutcome outcome =
      engine::drive(p.model, p.state, p.drive, [&](const engine::Sample& sample) {
        recorder.note(sample);
        return !progress || progress(recorder.progress()) ? engine::Wish::go_on : engine::Wish::interrupt;
      });
  run.reproducibility.wall_seconds = watch.wall();
  run.reproducibility.cpu_seconds = watch.cpu();
  run.reproducibility.state_hash = engine::state_hash(p.state);

  result.tree_at_end = tree_errors_now(p);
  run.partial = outcome.outcome == engine::Outcome::interrupted;
  run.energy = recorder.take_energy();
  const std::vector<double> overlaps = std::move(run.numerics.overlap_ratio);
  run.numerics = numerics_of(p.model, p.state, p.drive, outcome);
  run.numerics.overlap_ratio = overlaps;
  run.numerics.warnings.insert(run.numerics.warnings.end(), recorder.warnings().begin(),
                               recorder.warnings().end());
  result.reason = number_trouble(result, outcome);
  result.valid = result.reason.empty();
  run.moments = moments_of(p, run.trajectory);
  return result;
}

}  // namespace dougong::app
